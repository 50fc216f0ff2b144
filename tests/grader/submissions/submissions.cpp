// Submissions are written as changes to the lab's own files, so that each says only what is different.
// SPDX-License-Identifier: MIT
#include "grader/submissions/submissions.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

namespace grader {

namespace fs = std::filesystem;

namespace {

const fs::path root = LAMBERT_SOURCE_DIR;
const fs::path folder = root / "tests/grader/submissions";

std::string readText(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    if (!in || !(text << in.rdbuf()))
        throw std::runtime_error("cannot read " + file.string() + "; expected a text file there");
    return text.str();
}

std::vector<std::string> linesOf(std::string_view text) {
    std::vector<std::string> lines;
    std::istringstream in{std::string(text)};
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines)
        text += line + "\n";
    return text;
}

std::size_t indentation(const std::string& line) {
    return std::min(line.find_first_not_of(' '), line.size());
}

std::string_view trimmed(std::string_view line) {
    const std::size_t first = line.find_first_not_of(' ');
    return first == std::string_view::npos ? std::string_view()
                                           : line.substr(first, line.find_last_not_of(' ') - first + 1);
}

// Lines that go, and those that come in their place.
struct Change {
    std::vector<std::string> old, fresh;
    std::size_t line = 0;  // of the edit, from 1
};

bool standsAt(const std::vector<std::string>& lines, std::size_t at, const std::vector<std::string>& wanted) {
    if (at + wanted.size() > lines.size())
        return false;
    for (std::size_t i = 0; i < wanted.size(); ++i)
        if (trimmed(lines[at + i]) != trimmed(wanted[i]))
            return false;
    return true;
}

void apply(const Change& change, const std::string& file, std::string& text, const std::string& where) {
    std::vector<std::string> lines = linesOf(text), result;
    std::size_t found = 0, at = 0;
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (standsAt(lines, i, change.old)) {
            ++found;
            at = i;
        }
    if (found != 1)
        throw std::runtime_error(where + "expected '" + change.old[0] + "' exactly once in " + file +
                                 ", found it " + std::to_string(found) +
                                 " times. Write what the file says now.");
    const std::string blanks(indentation(lines[at]), ' ');
    const auto begin = lines.begin() + static_cast<std::ptrdiff_t>(at);
    const auto end = begin + static_cast<std::ptrdiff_t>(change.old.size());
    result.assign(lines.begin(), begin);
    for (const std::string& line : change.fresh)
        result.push_back(line.empty() ? line : blanks + line);
    result.insert(result.end(), end, lines.end());
    text = joined(result);
}

// Reads an edit line by line.
class Editor {
  public:
    Editor(Files files, std::string name, const ReadFile& original)
        : files_(std::move(files)), name_(std::move(name)), original_(original) {}

    Files run(std::string_view edit) {
        const std::vector<std::string> lines = linesOf(edit);
        for (number_ = 1; number_ <= lines.size(); ++number_)
            read(lines[number_ - 1]);
        finish();
        return std::move(files_);
    }

  private:
    std::string where(std::size_t line) const { return name_ + ":" + std::to_string(line) + ": "; }

    void read(const std::string& line) {
        const auto text = [&line] { return line.size() > 2 ? line.substr(2) : std::string(); };
        if (line.starts_with("-") && change_.fresh.empty()) {
            change_.line = change_.old.empty() ? number_ : change_.line;
            change_.old.push_back(text());
        } else if (line.starts_with("+") && !change_.old.empty()) {
            change_.fresh.push_back(text());
        } else if (line.empty() || line.starts_with("#") || line.starts_with("from ")) {
            finish();
        } else if (line.starts_with("file ")) {
            finish();
            file_ = line.substr(5);
            if (!files_.contains(file_))
                files_[file_] = original_(file_);
        } else {
            throw std::runtime_error(where(number_) + "found '" + line +
                                     "', expected '# ...', 'from ID', 'file NAME', or '- ' lines and after "
                                     "them '+ ' lines, an empty line between changes");
        }
    }

    void finish() {
        if (change_.old.empty())
            return;
        if (file_.empty())
            throw std::runtime_error(where(change_.line) + "a change before the first 'file NAME'");
        apply(change_, file_, files_[file_], where(change_.line));
        change_ = {};
    }

    Files files_;
    std::string name_, file_;
    const ReadFile& original_;
    Change change_;
    std::size_t number_ = 0;
};

// The ID of a line `from ID`; empty if the edit has none.
std::string basedOn(const std::string& edit) {
    for (const std::string& line : linesOf(edit))
        if (line.starts_with("from "))
            return line.substr(5);
    return {};
}

Files submission(const std::string& kind, const fs::path& originals, const std::string& id, int depth = 0) {
    const fs::path whole = folder / kind / id, edit = folder / kind / (id + ".edit");
    if ((!fs::exists(whole) && !fs::exists(edit)) || depth > 3)
        throw std::runtime_error("no submission is called '" + id + "'; expected " + edit.string());
    const std::string text = fs::exists(edit) ? readText(edit) : std::string();
    const std::string base = basedOn(text);
    Files files =
        base.empty() ? Files() : submission(kind == "unnamed" ? "terms" : kind, originals, base, depth + 1);
    if (fs::exists(whole))
        for (const auto& entry : fs::recursive_directory_iterator(whole))
            if (entry.is_regular_file())
                files[fs::relative(entry.path(), whole).generic_string()] = readText(entry.path());
    return edited(std::move(files), text, fs::relative(edit, root).generic_string(),
                  [&](const std::string& name) { return readText(originals / name); });
}

std::vector<std::string> submissions(const std::string& kind) {
    std::set<std::string> ids;
    for (const auto& entry : fs::directory_iterator(folder / kind))
        ids.insert(entry.path().stem().string());
    return {ids.begin(), ids.end()};
}

}  // namespace

Files edited(Files files, std::string_view edit, const std::string& name, const ReadFile& original) {
    return Editor(std::move(files), name, original).run(edit);
}

Files shaderSubmission(const std::string& id) { return submission("terms", root / "shaders", id); }
std::vector<std::string> shaderSubmissions() { return submissions("terms"); }

Files unnamedSubmission(const std::string& name) { return submission("unnamed", root / "shaders", name); }
std::vector<std::string> unnamedSubmissions() { return submissions("unnamed"); }

Files lessonSubmission(const std::string& id) { return submission("lessons", root / "lessons", id); }
std::vector<std::string> lessonSubmissions() { return submissions("lessons"); }

const std::map<std::string, std::string>& cannotBeWritten() {
    static const std::map<std::string, std::string> reasons{
        {"B2", "a shader gets a directional light's direction, not its place; a lesson can: lessons/B2.edit"},
        {"B6",
         "a directional light's direction is normalised before a shader gets it, whatever a lesson writes"},
        {"B10", "a shader gets no place of the camera to turn lights with; a lesson can: lessons/B10.edit"},
    };
    return reasons;
}

}  // namespace grader
