// Looks into the memory, the environment and the files of whoever started it.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"
#include <string>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/uio.h>

void look(const std::string& path) {
    const int file = ::open(path.c_str(), O_RDONLY);
    char text[65536] = {};
    const ssize_t size = file >= 0 ? ::read(file, text, sizeof(text) - 1) : 0;
    for (ssize_t i = 0; i < size; ++i) {
        text[i] = text[i] == 0 ? '\n' : text[i];
    }
    say(text);
}

int main() {
    for (const std::string& process : {std::string("1"), std::to_string(::getppid()), std::string("self")}) {
        for (const char* file :
             {"/environ", "/cmdline", "/mem", "/fd/3", "/fd/4", "/fd/5", "/fd/6", "/fd/7"}) {
            look("/proc/" + process + file);
        }
    }
    for (char** variable = ::environ; *variable != nullptr; ++variable) {
        say(*variable);
    }
    refused("open", ::open(("/proc/" + std::to_string(::getppid()) + "/mem").c_str(), O_RDWR));
    refused("ptrace", ::ptrace(PTRACE_ATTACH, ::getppid(), nullptr, nullptr));
    char byte = 0;
    iovec here{&byte, 1};
    iovec there{reinterpret_cast<void*>(0x400000), 1};
    refused("process_vm_readv", ::process_vm_readv(::getppid(), &here, 1, &there, 1, 0));
    refused("prlimit", ::prlimit(::getppid(), RLIMIT_CPU, nullptr, nullptr));
}
