// A check as a small piece of HTML, for gradebooks that show some. Internal to tests/grader/report.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/report/formats/common.hpp"

#include <functional>

namespace grader {

/// feedbackLines() in <p> and <pre>, then a picture for every image with a source. Only tags that sanitizers let through; the
/// text stands alone where pictures do not. `source` gives an image's URL, or "" to leave it out.
std::string richText(const Report& report, const Check& check,
                     const std::function<std::string(const ReportImage&)>& source);

}  // namespace grader
