// Reads lines from a file or a pipe, and words from lines.
// SPDX-License-Identifier: MIT
#include "lab/frame_lines.hpp"

#include "lab/failure.hpp"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <iostream>
#include <system_error>

namespace lab {

namespace {

constexpr std::string_view blanks = " \t\v\f";

bool isBlank(char c) { return blanks.find(c) != std::string_view::npos; }

// Takes one word off the front of `line`, which begins with no blank.
std::string takeWord(std::string_view& line) {
    std::string word;
    char quote = '\0';  // the one that is open
    std::size_t i = 0;
    for (; i < line.size() && (quote != '\0' || !isBlank(line[i])); ++i) {
        const char c = line[i];
        const bool escapes = c == '\\' && (quote == '\0' || (quote == '"' && i + 1 < line.size() &&
                                                             (line[i + 1] == '"' || line[i + 1] == '\\')));
        if (c == quote)
            quote = '\0';
        else if (quote == '\0' && (c == '\'' || c == '"'))
            quote = c;
        else if (escapes && ++i == line.size())
            throw UsageError(
                "found a backslash at the end of the line; expected a character after it; write \\\\ "
                "for a backslash, and everything about a frame in one line");
        else
            word += line[i];
    }
    if (quote != '\0')
        throw UsageError(std::string("found a ") + quote +
                         " without its end; expected a second one in the same line");
    line.remove_prefix(i);
    return word;
}

}  // namespace

std::vector<std::string> splitWords(std::string_view line) {
    if (line.find('\0') != std::string_view::npos)
        throw UsageError("found a NUL byte; expected a line of text; is this the right file?");
    std::vector<std::string> words;
    for (;;) {
        line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
        if (line.empty() || line.front() == '#')
            return words;
        words.push_back(takeWord(line));
    }
}

LineReader::LineReader(const std::string& file) : name_(file == "-" ? "stdin" : file), in_(&std::cin) {
    if (file == "-")
        return;
    std::error_code error;
    errno = 0;
    if (std::filesystem::is_directory(file, error))
        errno = EISDIR;
    else
        file_.open(file, std::ios::binary);
    if (!file_.is_open())
        throw UsageError("--frames-from: cannot read '" + file +
                         "': " + std::generic_category().message(errno) +
                         "; expected a text file with a line of options for each frame, or - for stdin");
    in_ = &file_;
    if (std::filesystem::is_regular_file(file, error))
        size_ = std::filesystem::file_size(file, error);
}

int LineReader::nextByte() {
    try {
        return in_->rdbuf()->sbumpc();
    } catch (const std::ios_base::failure&) {
        throw UsageError("--frames-from: cannot read on in '" + name_ + "' after line " +
                         std::to_string(number_) +
                         "; expected a text file; copy it to a disk that can be read");
    }
}

bool LineReader::next(std::string& line) {
    line.clear();
    tooLong_ = false;
    constexpr int end = std::char_traits<char>::eof();
    int c = nextByte();
    if (c == end)
        return false;
    for (; c != end && c != '\n'; c = nextByte()) {
        ++read_;
        if (line.size() < longest)
            line += static_cast<char>(c);
        else
            tooLong_ = true;
    }
    ++read_;
    ++number_;
    if (line.ends_with('\r'))
        line.pop_back();
    if (number_ == 1 && line.starts_with("\xEF\xBB\xBF"))  // a byte order mark, as some editors leave it
        line.erase(0, 3);
    return true;
}

std::string LineReader::place() const { return name_ + ":" + std::to_string(number_); }

double LineReader::share() const {
    return size_ == 0 ? 0 : std::min(1.0, static_cast<double>(read_) / static_cast<double>(size_));
}

}  // namespace lab
