// Pieces that the student's page and the class's overview share. Internal to tests/grader/report.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/report/formats/common.hpp"

namespace grader {

/// The whole document; `script` is the only one that its policy lets run, known by its SHA-256 in base64. Both may be "".
std::string page(Language language, const std::string& title, const std::string& mainClass,
                 const std::string& body, const std::string& script = "", const std::string& scriptHash = "");
/// "pass", "partial", ...: the style's class.
const char* classFor(CheckStatus status);
/// Sign and word on the status's colour.
std::string pill(Language language, CheckStatus status);
/// A bar filled to `share`; its number stands beside it in words, so readers skip it.
std::string bar(double share, const char* color = "");
/// The score as a ring; "-" in it where there are no marks.
std::string scoreRing(const Report& report);
/// <element class>text</element>, the text escaped; "" for an empty text.
std::string element(const std::string& tag, const std::string& text, const std::string& styleClass = "");

/// Does the check say more than a line of the list can?
bool hasCard(const Check& check);
/// One check of the student's page.
std::string checkCard(const Report& report, const Check& check, std::size_t index,
                      const std::filesystem::path& folder);

}  // namespace grader
