// Gives every file of some folders to a fuzz target, without a fuzzer: what once was found is tested in every build.
// SPDX-License-Identifier: MIT
#include "fuzz/property.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

int main(int argc, char** argv) {
    namespace fs = std::filesystem;
    std::vector<fs::path> files;
    for (int i = 1; i < argc; ++i)
        if (fs::is_directory(argv[i]))
            std::copy(fs::directory_iterator(argv[i]), fs::directory_iterator(), std::back_inserter(files));
        else
            files.emplace_back(argv[i]);
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
        std::cout << file.filename().string()
                  << std::endl;  // out before a crash, so that one sees which it was
        std::ifstream in(file, std::ios::binary);
        const std::vector<char> bytes(std::istreambuf_iterator<char>(in), {});
        if (!in.is_open()) {
            std::cerr << file.string() << ": cannot be read; expected a file or a folder of files\n";
            return 1;
        }
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    }
    std::cout << files.size() << " files\n";
    if (files.empty())
        std::cerr << "expected files or folders of files, found none; see tests/fuzz/corpus/\n";
    return files.empty() ? 1 : 0;
}
