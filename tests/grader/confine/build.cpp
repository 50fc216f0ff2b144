// Compiles a submission. What the compiler says is for students: short, and about their files.
// SPDX-License-Identifier: MIT
#include "grader/confine/builder.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace grader {

namespace {

constexpr std::size_t mostLines = 60;
constexpr std::ptrdiff_t firstLines = 40;

// A name that no tool takes for an option, a path or a pattern.
std::string tame(const std::string& name) {
    std::string stem = std::filesystem::path(name).stem().string();
    for (char& c : stem) {
        const bool plain =
            (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
        c = plain ? c : '_';
    }
    return (stem.empty() ? "submission" : stem.substr(0, 80)) + ".cpp";
}

// Inside in/: no way up, no way out.
bool staysInside(const std::string& name) {
    const std::filesystem::path path = name;
    return !name.empty() && name.size() < 200 && path.is_relative() && name.find('\0') == std::string::npos &&
           std::none_of(path.begin(), path.end(),
                        [](const auto& part) { return part == ".." || part.empty(); });
}

bool beginsPath(const std::string& line, std::size_t at) {
    for (const char* start : {"/", "../", "in/", "out/"}) {
        if (line.compare(at, std::string(start).size(), start) == 0) {
            const char before = at == 0 ? ' ' : line[at - 1];
            // The last is the end of an opening quote in UTF-8.
            return std::string(" \t\"'(`<,:\x98").find(before) != std::string::npos;
        }
    }
    return false;
}

// "in/a.cpp:3:1: error" becomes "a.cpp:3:1: error"; lines of the source itself ("   3 | ...") stay as they are.
std::string withoutFolders(const std::string& line) {
    const std::size_t first = line.find_first_not_of(" 0123456789");
    if (first != std::string::npos && first > 0 && line[first] == '|') {
        return line;
    }
    std::string cut;
    for (std::size_t at = 0; at < line.size();) {
        if (!beginsPath(line, at)) {
            cut += line[at++];
            continue;
        }
        const std::size_t end = std::min(line.find_first_of(" \t:\"'`<>(),;\xE2", at), line.size());
        const std::size_t slash = line.rfind('/', end - 1);
        cut += line.substr(slash + 1, end - slash - 1);
        at = end;
    }
    return cut;
}

// The beginning and the end: what is wrong stands in one of them.
std::string shortened(const std::string& said) {
    std::istringstream lines(said);
    std::vector<std::string> all;
    for (std::string line; std::getline(lines, line);) {
        all.push_back(withoutFolders(line).substr(0, 400));
    }
    if (all.size() > mostLines) {
        const auto end = all.end() - (static_cast<std::ptrdiff_t>(mostLines) - firstLines - 1);
        const auto begin = all.begin() + firstLines;
        const std::string left = "(" + std::to_string(end - begin) + " more lines)";
        all.insert(all.erase(begin, end), left);
    }
    std::string log;
    for (const std::string& line : all) {
        log += line + "\n";
    }
    return harmless(log);  // cutting may have split a character
}

Job compilation(const Kit& kit, const Source& source, const Limits& limits) {
    const std::string file = tame(source.name);
    Job job;
    job.limits = limits;
    job.command = {kit.compiler};
    job.command.insert(job.command.end(), kit.flags.begin(), kit.flags.end());
    for (const char* word : {"-pipe", "-fdiagnostics-color=never", "-fmax-errors=12", "-I../lab/kit",
                             "-I../lab/include", "-o", "out/program"}) {
        job.command.emplace_back(word);
    }
    job.command.push_back("in/" + file);
    for (const char* word : {"-L../lab/lib/lambert-lab", "-llambert_lab_kit",
                             "-Wl,-rpath,$ORIGIN/../lib/lambert-lab", "-Wl,--allow-shlib-undefined"}) {
        job.command.emplace_back(word);
    }
    job.mounts = {{kit.includes, "/lab/include"},
                  {kit.compiled, "/lab/kit"},
                  {kit.library, "/lab/lib/lambert-lab/liblambert_lab_kit.so"}};
    job.texts = {{"/box/in/" + file, source.text}};
    for (const auto& [name, text] : source.headers) {
        job.texts.emplace_back("/box/in/" + name, text);
    }
    job.wanted = {{"program", limits.fileBytes, false}};
    return job;
}

}  // namespace

Limits buildLimits() {
    Limits limits;
    limits.wallSeconds = 90;
    limits.cpuSeconds = 30;
    limits.memoryBytes = std::uint64_t{2} << 30;
    limits.fileBytes = std::uint64_t{32} << 20;
    limits.folderBytes = std::uint64_t{96} << 20;
    limits.files = 1000;
    return limits;
}

Built build(const Confinement& confinement, const Kit& kit, const Source& source, int slot,
            const Limits& limits) {
    Built built;
    for (const auto& header : source.headers) {
        if (!staysInside(header.first)) {
            built.how = Ended::exited;
            built.log =
                harmless("the file name '" + header.first +
                         "' leads out of the submission; expected a name in its own folder; rename it\n");
            return built;
        }
    }
    Outcome outcome = confinement.run(compilation(kit, source, limits), slot);
    built.how = outcome.how;
    built.trouble = outcome.trouble;
    built.seconds = outcome.seconds;
    built.log = shortened(outcome.said);
    if (!outcome.limit.empty()) {
        built.log += "the compiler was stopped: " + outcome.limit + "\n";
    }
    if (outcome.how != Ended::exited || outcome.status != 0) {
        return built;
    }
    if (!outcome.files[0].problem.empty()) {
        built.log += "the program " + outcome.files[0].problem + "\n";
        return built;
    }
    built.program = std::move(outcome.files[0].bytes);
    built.ok = true;
    return built;
}

}  // namespace grader
