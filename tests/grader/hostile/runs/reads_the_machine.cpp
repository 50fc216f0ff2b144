// Looks for solutions, secrets and other people's files.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"

int main() {
    for (const char* path :
         {SECRET_FILE, LESSON_FILE, SHADER_FILE, "/etc/passwd", "/etc/shadow", "/root/.bashrc", "/dev/mem",
          "/dev/sda", "/dev/vda", "/dev/kmsg", "/usr/share/doc"}) {
        const int file = ::open(path, O_RDONLY);
        refused("open", file);
        char text[4096] = {};
        if (file >= 0 && ::read(file, text, sizeof(text) - 1) > 0) {
            say(text);
        }
    }
}
