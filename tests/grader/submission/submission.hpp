// What a student handed in: a folder, an archive or one file, read as data; nothing in it is trusted.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/report/report.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace grader {

/// A file and its bytes.
struct NamedText {
    std::string name, text;
};

/// What the grader looks for in a submission.
struct Expectations {
    std::string lesson;  ///< "lesson_05_attenuation": its .cpp is the one that counts where there are several
    std::vector<std::string>
        shaders;  ///< the lab's, by name below shaders/: "terms/cosine.glsl", "lighting.glsl"
    std::vector<std::map<std::string, std::string>>
        starters;  ///< shaders of the lesson's starter, one map per language
    bool keepNeutral = false;  ///< shaders that are still the starter's are judged although a lesson is there
};

struct Submission {
    std::string name;  ///< the path's last part
    std::string hash;  ///< SHA-256 over names and bytes of all its files
    std::vector<SubmittedFile> files;
    std::optional<NamedText> lesson;  ///< the .cpp
    std::vector<NamedText> headers;  ///< beside it
    std::map<std::string, std::string> shaders;  ///< by the lab's names
    std::set<std::string> untouched;  ///< terms whose file is still the starter's: "cosine"
    std::string problem;  ///< why nothing in it can be judged; empty if something can

    bool has(const std::string& part) const {  ///< as rubrics say it: "lesson", "terms/cosine.glsl"
        return part == "lesson" ? lesson.has_value() : shaders.count(part) != 0;
    }
};

/// Reads a folder, a .zip or .tar.gz, a .cpp, or a .glsl. Links are not followed, devices not opened; at most 200 files of 1 MiB, 8 MiB
/// together. A folder or archive with nothing but one archive is that archive. Throws std::runtime_error only where the path itself cannot be read.
Submission readSubmission(const std::filesystem::path& path, const Expectations& expected, Language language);

/// C++ or GLSL without comments, and with blanks only where they part words: what is left is what a compiler sees.
std::string withoutComments(const std::string& source);

}  // namespace grader
