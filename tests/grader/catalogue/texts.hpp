// What the grader says of a misconception and of a check, in both languages: slides_refs/misconceptions.json.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/report/report.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace grader {

/// A text in both languages of the lab.
struct BothLanguages {
    std::string it, en;
    const std::string& in(Language language) const { return language == Language::it ? it : en; }
};

/// What there is to say of a wrong equation, or of a class that no picture can split.
struct MisconceptionText {
    std::vector<std::string> ids;  ///< one; of a class, all
    std::string check;  ///< whose marks it costs: CheckText::id
    std::string why;  ///< why that check, where it is not plain; for maintainers
    std::vector<int> slides;  ///< to reread, as printed on them
    BothLanguages name;  ///< a short clause: "w points away from the light"
    BothLanguages hint;  ///< makes one think, without the answer
    BothLanguages convention;  ///< whose convention it is elsewhere; empty: nobody's that students would copy
};

/// One thing that marks are given for: a term of the lab by its name, or "sum", "normals", "colours".
struct CheckText {
    std::string id;
    std::vector<int> slides;
    BothLanguages title;
    BothLanguages expected;  ///< what one sees when it is right
};

/// The whole file.
class Texts {
  public:
    /// Throws std::runtime_error that names file and field, and says what was expected.
    explicit Texts(const std::filesystem::path& file);

    /// In the order of the file. A class has the slides of its first member and no convention.
    const std::vector<MisconceptionText>& misconceptions() const { return misconceptions_; }
    const std::vector<MisconceptionText>& classes() const { return classes_; }
    const std::vector<CheckText>& checks() const { return checks_; }
    /// Throw std::out_of_range that names an id which has no text.
    const MisconceptionText& misconception(const std::string& id) const;
    const CheckText& check(const std::string& id) const;
    /// Of the class with all of `ids`, in any order; of the misconception where there is one id. Throws std::out_of_range.
    const MisconceptionText& textOf(const std::vector<std::string>& ids) const;

  private:
    std::vector<MisconceptionText> misconceptions_, classes_;
    std::vector<CheckText> checks_;
};

}  // namespace grader
