// Finds a loop's head and statement, and repeats the statement.
// SPDX-License-Identifier: MIT
#include "render/shader_loops.hpp"

#include <algorithm>
#include <charconv>
#include <sstream>

namespace render {

namespace {

std::string withoutSpaces(std::string text) {
    std::erase_if(text, [](unsigned char c) { return std::isspace(c) != 0; });
    return text;
}

// The text between two others, which moves `at` behind the second; empty if they are not there.
std::string between(const std::string& text, std::size_t& at, const std::string& before,
                    const std::string& after) {
    if (text.compare(at, before.size(), before) != 0)
        return {};
    const std::size_t begin = at + before.size(), end = text.find(after, begin);
    if (end == std::string::npos)
        return {};
    at = end + after.size();
    return text.substr(begin, end - begin);
}

// Where a statement that begins in line `first` ends: with its ';', or with the '}' of its block.
std::optional<std::size_t> lastLine(const std::vector<std::string>& lines, std::size_t first, bool block) {
    int depth = block ? 1 : 0;
    for (std::size_t i = first; i < lines.size(); ++i) {
        depth += static_cast<int>(std::count(lines[i].begin(), lines[i].end(), '{') -
                                  std::count(lines[i].begin(), lines[i].end(), '}'));
        if (block ? depth == 0 : lines[i].find(';') != std::string::npos)
            return i;
    }
    return std::nullopt;
}

}  // namespace

LoopWriter::LoopWriter(const std::string& preamble) {
    std::istringstream in(preamble);
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string define, name, value;
        if (words >> define >> name >> value && define == "#define")
            defines_[name] = value;
    }
}

bool LoopWriter::is(const char* name) const {
    const auto found = defines_.find(name);
    return found != defines_.end() && found->second == "1";
}

std::optional<int> LoopWriter::value(const std::string& text) const {
    const auto found = defines_.find(text);
    const std::string& digits = found == defines_.end() ? text : found->second;
    int number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return error == std::errc() && end == digits.data() + digits.size() ? std::optional(number)
                                                                        : std::nullopt;
}

std::optional<Loop> LoopWriter::read(const std::vector<std::string>& lines, std::size_t pragma) const {
    if (withoutSpaces(lines[pragma]) != "#pragmaunroll" || pragma + 2 >= lines.size())
        return std::nullopt;
    std::string head = withoutSpaces(lines[pragma + 1]);
    const bool block = head.ends_with('{');
    if (block)
        head.pop_back();
    Loop loop;
    std::size_t at = 0;
    loop.variable = between(head, at, "for(int", "=");
    loop.begin = between(head, at, "", ";");
    loop.end = between(head, at, loop.variable + "<", ";");
    const std::optional<std::size_t> last = lastLine(lines, pragma + 2, block);
    if (loop.variable.empty() || loop.begin.empty() || loop.end.empty() || !last ||
        head.substr(at) != "++" + loop.variable + ")")
        return std::nullopt;
    loop.head = pragma + 1;
    loop.last = *last;
    const bool everyTurn = is("LIGHTS_ARE_CONSTANTS") && value(loop.begin) && value(loop.end);
    return everyTurn || is("LONG_LOOPS") ? std::optional(loop) : std::nullopt;
}

std::vector<LoopLine> LoopWriter::writeOut(const Loop& loop, const std::vector<std::string>& lines) const {
    std::vector<LoopLine> out;
    const bool everyTurn = is("LIGHTS_ARE_CONSTANTS");
    // One turn: the statement where the variable is `number`.
    const auto turn = [&](const std::string& before, const std::string& number) {
        out.push_back(
            {before + (everyTurn ? "{ const int " : "{ int ") + loop.variable + " = " + number + ";",
             loop.head});
        for (std::size_t i = loop.head + 1; i <= loop.last; ++i)
            out.push_back({lines[i], i});
        if (!withoutSpaces(lines[loop.head]).ends_with('{'))
            out.push_back({"}", loop.last});
    };
    if (everyTurn) {
        for (int i = *value(loop.begin); i < *value(loop.end); ++i)
            turn("", std::to_string(i));
        return out;
    }
    const std::string first = loop.variable + "_first";
    out.push_back({"for (int " + first + " = " + loop.begin + "; " + first + " < " + loop.end + "; " + first +
                       " += 4) {",
                   loop.head});
    turn("", first);
    for (const char* const more : {" + 1", " + 2", " + 3"})
        turn("if (" + first + more + " < " + loop.end + ") ", first + more);
    out.push_back({"}", loop.last});
    return out;
}

}  // namespace render
