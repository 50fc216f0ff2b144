// The two renderings of a report as text.
// SPDX-License-Identifier: MIT
#include "checks.hpp"

#include <algorithm>
#include <iomanip>
#include <ostream>

namespace nuovo {
namespace {

/// A line of a file, fit for a terminal: control bytes spelled out, very long lines cut.
std::string shown(const std::string& text) {
    constexpr std::size_t kLongest = 200;
    std::string result;
    for (const char c : text.substr(0, kLongest)) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7F) {
            constexpr const char* kHex = "0123456789abcdef";
            result.append("\\x").append(1, kHex[byte >> 4U]).append(1, kHex[byte & 15U]);
        } else {
            result += c;
        }
    }
    return text.size() > kLongest ? result + "..." : result;
}

void printLines(const char* label, const std::vector<std::string>& lines, std::ostream& out) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
        out << "    " << std::left << std::setw(10) << (i == 0 ? label : "") << '|' << shown(lines[i])
            << "|\n";
    }
}

}  // namespace

const char* name(Rule rule) {
    switch (rule) {
    case Rule::Number:
        return "number";
    case Rule::Chain:
        return "chain";
    case Rule::Count:
        return "count";
    case Rule::Slides:
        return "slides";
    case Rule::Items:
        return "items";
    case Rule::Comment:
        return "comment";
    case Rule::Width:
        return "width";
    case Rule::Tags:
        return "tags";
    case Rule::Place:
        return "place";
    }
    return "";
}

void printMatrix(const Report& report, std::ostream& out) {
    std::size_t width = 0;
    for (const auto& row : report.rows) {
        width = std::max(width, row.first.size());
    }
    for (const auto& [row, rules] : report.rows) {
        out << std::left << std::setw(static_cast<int>(width)) << row;
        for (const Rule rule : rules) {
            const bool failed =
                std::any_of(report.failures.begin(), report.failures.end(),
                            [&, &r = row](const Failure& f) { return f.rule == rule && f.row == r; });
            out << "  " << name(rule) << (failed ? " FAILED" : " ok");
        }
        out << '\n';
    }
    out << (report.ok() ? "ok: " : "FAILED, " + std::to_string(report.failures.size()) + " times: ")
        << report.summary << '\n';
}

void printFailures(const Report& report, std::ostream& out) {
    for (const Failure& failure : report.failures) {
        out << failure.file.string() << ':' << failure.line << ": " << name(failure.rule) << ": "
            << shown(failure.what) << '\n';
        printLines("expected", failure.expected, out);
        printLines("found", failure.found, out);
        out << "    " << std::left << std::setw(10) << "to do" << failure.remedy << '\n';
    }
}

}  // namespace nuovo
