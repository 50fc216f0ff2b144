// What the hostile submissions share. It lies beside each of them as a header of its own; SECRET_FILE and others are put in front.
// SPDX-License-Identifier: MIT
#pragma once

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <initializer_list>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

/// Into the grader's ear, at once.
inline void say(const char* text) {
    std::puts(text);
    std::fflush(stdout);
}

/// Says whether the machine let it.
inline void refused(const char* call, long result) {
    std::printf("%s: %s\n", call, result < 0 ? "refused" : "ALLOWED");
    std::fflush(stdout);
}

/// A frame as 16x8 pixels would be, of one value, or with another header and number of floats.
inline void writeFrame(float value, const char* header = "PF\n16 8\n-1.0\n", int floats = 16 * 8 * 3) {
    std::FILE* const file = std::fopen("out/0.pfm", "wb");
    std::fputs(header, file);
    for (int i = 0; i < floats; ++i) {
        std::fwrite(&value, sizeof(value), 1, file);
    }
    std::fclose(file);
}
