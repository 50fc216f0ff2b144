// What a fuzz target may expect of the program, and how it says that the program did otherwise.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace fuzz {

/// Ends the process as a crash would, so that the fuzzer keeps the input.
[[noreturn]] inline void fail(const std::string& message) {
    std::fprintf(stderr, "FINDING: %s\n", message.c_str());
    std::abort();
}

inline void require(bool condition, const std::string& message) {
    if (!condition)
        fail(message);
}

}  // namespace fuzz

/// One input to one target: libFuzzer calls it, and replay.cpp for the files of the corpus.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
