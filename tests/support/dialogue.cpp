// Pipes to a program and from it.
// SPDX-License-Identifier: MIT
#include "support/dialogue.hpp"

#include <cstdio>
#include <cstdlib>
#include <poll.h>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

namespace support {

Dialogue::Dialogue(const std::vector<std::string>& arguments, const std::filesystem::path& directory) {
    const std::string program = std::string(LAMBERT_BIN_DIR) + "/" + arguments.at(0);
    std::vector<char*> argv{const_cast<char*>(program.c_str())};
    for (std::size_t i = 1; i < arguments.size(); ++i)
        argv.push_back(const_cast<char*>(arguments[i].c_str()));
    argv.push_back(nullptr);
    int in[2], out[2];
    if (pipe(in) != 0 || pipe(out) != 0)
        throw std::runtime_error("cannot make a pipe");
    child_ = fork();
    if (child_ == 0) {
        unsetenv("DISPLAY");
        unsetenv("WAYLAND_DISPLAY");
        if (chdir(directory.c_str()) != 0 || dup2(in[0], STDIN_FILENO) < 0 ||
            dup2(out[1], STDOUT_FILENO) < 0 || freopen("/dev/null", "w", stderr) == nullptr)
            _exit(126);
        for (const int descriptor : {in[0], in[1], out[0], out[1]})
            close(descriptor);
        execv(argv[0], argv.data());
        _exit(127);
    }
    close(in[0]);
    close(out[1]);
    to_ = in[1];
    from_ = out[0];
}

Dialogue::~Dialogue() {
    if (child_ > 0)
        end();
    close(from_);
}

void Dialogue::say(const std::string& text) {
    if (write(to_, text.data(), text.size()) != static_cast<ssize_t>(text.size()))
        throw std::runtime_error("the program does not listen");
}

std::string Dialogue::hear() {
    for (std::size_t end = heard_.find('\n');; end = heard_.find('\n')) {
        if (end != std::string::npos) {
            std::string line = heard_.substr(0, end);
            heard_.erase(0, end + 1);
            return line;
        }
        pollfd waiting{from_, POLLIN, 0};
        char bytes[4096];
        const ssize_t count = poll(&waiting, 1, 20'000) == 1 ? read(from_, bytes, sizeof bytes) : 0;
        if (count <= 0)
            return "";
        heard_.append(bytes, static_cast<std::size_t>(count));
    }
}

int Dialogue::end() {
    close(to_);
    int status = 0;
    waitpid(child_, &status, 0);
    child_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace support
