// Where the lab's own files are: the same layout in the build tree and wherever it is installed.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace image {

// The folder with the lab's bin/, lib/lambert-lab/ (modules) and share/lambert-lab/ (shaders, lessons, slides): what
// setHome() said, else the one above the program's own folder. Links of the build tree lead to the sources.
std::filesystem::path home();

// For programs that were built outside the lab, before main: its CMake package calls it (lab/say_home.cpp).
void setHome(std::string folder);

// Loads a module of the lab, such as "liblambert_window.so", and returns the address of its function `entry`. The
// module is never unloaded: its libraries start threads and static objects that would outlive it. Null, with a reason,
// if either is missing.
void* loadModule(const std::string& file, const char* entry, std::string& reason);

}  // namespace image
