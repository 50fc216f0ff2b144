// Equal hashes, in words.
// SPDX-License-Identifier: MIT
#include "grader/class/similarity.hpp"

#include <algorithm>

namespace grader {

namespace {

constexpr std::size_t mostWithFrames = 4;  // what more share is a common mistake

// Submissions by what they have: a part's name and its hash.
using Groups = std::map<std::pair<std::string, std::string>, std::vector<std::size_t>>;

bool isExplained(const Report& report) {
    return std::any_of(report.checks.begin(), report.checks.end(),
                       [](const Check& check) { return check.explanation.has_value(); });
}

class Similarities {
  public:
    Similarities(std::vector<Result>& results, bool it) : results_(results), it_(it), found_(results.size()) {
        Groups files, sources, frames;
        for (std::size_t i = 0; i < results.size(); ++i) {
            for (const auto& part : results[i].files)
                files[part].push_back(i);
            for (const auto& part : results[i].sources)
                sources[part].push_back(i);
            if (!results[i].frames.empty() && !isExplained(results[i].report))
                frames[{"", results[i].frames}].push_back(i);
        }
        // The strongest first: two submissions are named together once.
        note(files, results.size(), [&](const std::string& name) {
            return part(name) + (it_ ? ": lo stesso file, byte per byte" : ": the same file, byte for byte");
        });
        note(sources, results.size(), [&](const std::string& name) {
            return part(name) + (it_ ? ": lo stesso testo, a parte commenti e spazi"
                                     : ": the same text but for comments and blanks");
        });
        note(frames, mostWithFrames, [&](const std::string&) {
            return std::string(it_ ? "immagini sbagliate e uguali fino all'ultimo bit"
                                   : "frames that are wrong and equal to the last bit");
        });
    }

    void fill() {
        for (std::size_t i = 0; i < results_.size(); ++i) {
            results_[i].report.similar.clear();
            for (const auto& [other, how] : found_[i])
                results_[i].report.similar.push_back({results_[other].report.submission, how});
        }
    }

  private:
    std::string part(const std::string& name) const {
        return name == "lesson" ? std::string(it_ ? "il programma" : "the program") : name;
    }
    template <class Words>
    void note(const Groups& groups, std::size_t most, const Words& words) {
        for (const auto& [key, members] : groups)
            for (const std::size_t a : members)
                for (const std::size_t b : members)
                    if (a != b && members.size() <= most)
                        found_[a].emplace(b, words(key.first));
    }

    std::vector<Result>& results_;
    bool it_;
    std::vector<std::map<std::size_t, std::string>> found_;
};

}  // namespace

void findSimilar(std::vector<Result>& results, Language language) {
    Similarities(results, language == Language::it).fill();
}

}  // namespace grader
