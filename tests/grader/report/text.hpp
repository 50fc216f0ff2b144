// Text of unknown origin made fit for pages, tables, gradebooks and terminals, and the words that all of these use.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/report/report.hpp"

#include <string>

namespace grader {

/// Valid UTF-8 that no terminal, browser or XML reader obeys: line ends become \n, escape sequences go, and other control
/// characters, marks that turn the direction of text around, and broken bytes become U+FFFD. Tabs stay.
std::string harmless(const std::string& text);
/// harmless(), all in one line: line ends and tabs become blanks.
std::string oneLine(const std::string& text);
/// harmless(), with & < > " ' as entities: for HTML and XML, between tags and in attributes.
std::string escaped(const std::string& text);
/// The beginning, at most so many bytes of UTF-8, with "..." where something is left out.
std::string shortened(const std::string& text, std::size_t bytes);

/// The shortest decimal number that reads back as this one: "2.5", "14". What is not finite is "?".
std::string number(double value);
/// Points for readers: at most two decimals.
std::string points(double value);
/// 0.973 as "97 %"; 100 % only for all of it, 0 % only for nothing.
std::string percent(double share);

std::string base64(const std::string& bytes);

/// The words of the report's language.
inline const char* say(Language language, const char* english, const char* italian) {
    return language == Language::it ? italian : english;
}
/// "passed", "in part", "not yet", "skipped"
std::string wordFor(Language language, CheckStatus status);
/// "lit side", ... of a region's name in report.json; unknown names as they are.
std::string regionName(Language language, const std::string& name);
/// "(0.863, 0.533, 0.333)"
std::string colorText(const std::array<double, 3>& color);

}  // namespace grader
