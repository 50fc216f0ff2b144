// Finds and loads the lessons' modules.
// SPDX-License-Identifier: MIT
#include "lab/live/programs.hpp"

#include "image/home.hpp"
#include "lab/failure.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>

lab::Handover* lambertHandover = nullptr;

namespace lab {

std::vector<std::string> programOrder() {
    std::ifstream in(image::home() / "share/lambert-lab/order.txt");
    std::vector<std::string> names;
    for (std::string name; std::getline(in, name);)
        if (!name.empty())
            names.push_back(name);
    return names;
}

std::string neighbour(const std::string& program, int steps) {
    const std::vector<std::string> names = programOrder();
    const auto found = std::find(names.begin(), names.end(), program);
    const std::ptrdiff_t here = found == names.end() ? -1 : found - names.begin();
    const std::ptrdiff_t there = here + steps;
    if (there < 0 || there >= static_cast<std::ptrdiff_t>(names.size()))
        throw UsageError(steps > 0 ? "expected a lesson after " + program + ", which is the last one"
                                   : "expected a lesson before " + program + ", but there is none");
    return names[static_cast<std::size_t>(there)];
}

std::string programNamed(const std::string& wanted) {
    const std::vector<std::string> names = programOrder();
    const bool isNumber =
        !wanted.empty() && wanted.size() <= 2 &&
        std::all_of(wanted.begin(), wanted.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
    const std::string numbered = "lesson_" + std::string(wanted.size() == 1 ? "0" : "") + wanted + "_";
    std::string all;
    std::vector<std::string> found;
    for (const std::string& name : names) {
        if (name == wanted)
            return name;
        if (isNumber ? name.starts_with(numbered) : !wanted.empty() && name.find(wanted) != std::string::npos)
            found.push_back(name);
        all += (all.empty() ? "" : ", ") + name;
    }
    if (found.size() != 1)
        throw UsageError("expected the name of one lesson, a part of it, or its number; found '" + wanted +
                         "'; there are " + all);
    return found[0];
}

std::string slidesOf(const std::string& program) {
    std::ifstream in(image::home() / "share/lambert-lab/lessons" / (program + ".cpp"));
    constexpr std::string_view mark = "// Slides ";
    for (std::string line; std::getline(in, line) && line.starts_with("//");)
        if (line.starts_with(mark))
            return line.substr(mark.size());
    return {};
}

namespace {

void* entryOf(const std::string& program, const char* name) {
    std::string reason;
    void* const entry = image::loadModule(program + ".so", name, reason);
    if (entry == nullptr)
        throw UsageError("cannot go on with " + program + ": " + reason + "; build it: cmake --build build");
    return entry;
}

}  // namespace

void expectProgram(const std::string& program) { entryOf(program, "main"); }

int runProgram(const std::string& program, const std::vector<std::string>& arguments, Handover& handover) {
    using Main = int (*)(int, char**);
    void* const channel = entryOf(program, "lambertHandover");
    void* const entry = entryOf(program, "main");
    std::vector<std::string> words{program};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words)
        argv.push_back(word.data());
    argv.push_back(nullptr);
    *static_cast<Handover**>(channel) = &handover;
    return reinterpret_cast<Main>(entry)(static_cast<int>(words.size()), argv.data());
}

}  // namespace lab
