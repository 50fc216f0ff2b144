// Equal hashes, in words.
// SPDX-License-Identifier: MIT
#include "grader/class/similarity.hpp"

#include <algorithm>

namespace grader {

namespace {

// Whether both have a part of the same hash; its name, or nothing.
std::string shared(const std::map<std::string, std::string>& a, const std::map<std::string, std::string>& b) {
    for (const auto& [name, hash] : a)
        if (const auto other = b.find(name); other != b.end() && other->second == hash)
            return name;
    return "";
}

std::string howAlike(const Result& a, const Result& b, bool it) {
    const auto part = [it](const std::string& name) {
        return name == "lesson" ? std::string(it ? "il programma" : "the program") : name;
    };
    if (const std::string name = shared(a.files, b.files); !name.empty())
        return part(name) + (it ? ": lo stesso file, byte per byte" : ": the same file, byte for byte");
    if (const std::string name = shared(a.sources, b.sources); !name.empty())
        return part(name) + (it ? ": lo stesso testo, a parte commenti e spazi"
                                : ": the same text but for comments and blanks");
    if (!a.frames.empty() && a.frames == b.frames)
        return it ? "immagini sbagliate e uguali fino all'ultimo bit"
                  : "frames that are wrong and equal to the last bit";
    return "";
}

}  // namespace

void findSimilar(std::vector<Result>& results, Language language) {
    for (Result& one : results) {
        one.report.similar.clear();
        for (const Result& other : results)
            if (&one != &other)
                if (const std::string how = howAlike(one, other, language == Language::it); !how.empty())
                    one.report.similar.push_back({other.report.submission, how});
    }
}

}  // namespace grader
