// JUnit XML for build servers: what ctest's own leaves out, scores and reasons, is in it.
// SPDX-License-Identifier: MIT
#include "grader/report/formats/common.hpp"

namespace grader {

namespace {

std::string attribute(const char* name, const std::string& value) {
    return std::string(" ") + name + "=\"" + escaped(oneLine(value)) + "\"";
}

std::string property(const char* name, const std::string& value) {
    return "    <property" + attribute("name", name) + attribute("value", value) + "/>\n";
}

std::string caseOf(const Report& report, const Check& check) {
    std::string feedback;
    for (const std::string& line : feedbackLines(report, check))
        feedback += escaped(line) + "\n";
    std::string xml = "  <testcase" + attribute("classname", report.lesson) +
                      attribute("name", check.id + " " + check.title) + attribute("time", "0") + ">\n";
    xml += "    <properties>\n  " + property("score", number(check.score)) + "  " +
           property("max_score", number(check.maxScore)) + "    </properties>\n";
    if (check.status == CheckStatus::skipped)
        xml += "    <skipped" + attribute("message", check.message) + "/>\n";
    else if (check.status != CheckStatus::pass)
        xml += "    <failure" + attribute("message", check.message) +
               attribute("type", check.status == CheckStatus::partial ? "partial" : "fail") + ">" + feedback +
               "</failure>\n";
    return xml + "  </testcase>\n";
}

std::string casesOf(const Report& report) {
    if (report.status != ReportStatus::graded)
        return "  <testcase" + attribute("classname", report.lesson) + attribute("name", "grading") +
               attribute("time", "0") + ">\n    <error" + attribute("message", headline(report)) +
               attribute("type", statusName(report.status)) + "/>\n  </testcase>\n";
    std::string xml;
    for (const Check& check : report.checks)
        xml += caseOf(report, check);
    return xml;
}

std::string suiteStart(const Report& report) {
    const bool graded = report.status == ReportStatus::graded;
    std::size_t failures = 0, skipped = 0;
    for (const Check& check : report.checks) {
        failures += graded && (check.status == CheckStatus::fail || check.status == CheckStatus::partial);
        skipped += graded && check.status == CheckStatus::skipped;
    }
    const std::string counts = attribute("tests", std::to_string(graded ? report.checks.size() : 1)) +
                               attribute("failures", std::to_string(failures)) +
                               attribute("errors", graded ? "0" : "1") +
                               attribute("skipped", std::to_string(skipped));
    const double seconds = report.compileSeconds + report.framesSeconds + report.judgeSeconds;
    std::string xml = "<testsuites" + counts + ">\n<testsuite" + attribute("name", report.lesson) + counts +
                      attribute("time", number(seconds)) + ">\n  <properties>\n";
    xml += property("submission", report.submission) + property("status", statusName(report.status));
    if (graded)
        xml += property("score", number(report.score)) + property("max_score", number(report.maxScore));
    return xml + "  </properties>\n";
}

std::string output(const char* element, const std::string& text) {
    return text.empty() ? "" : std::string("  <") + element + ">" + escaped(text) + "</" + element + ">\n";
}

}  // namespace

std::string junit(const Report& report) {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + suiteStart(report) + casesOf(report) +
           output("system-out", report.said) + output("system-err", report.buildLog) +
           "</testsuite>\n</testsuites>\n";
}

}  // namespace grader
