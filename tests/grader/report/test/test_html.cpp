// The pages: well-formed, self-contained, complete, in both languages.
// SPDX-License-Identifier: MIT
#include "grader/report/formats/formats.hpp"
#include "grader/report/test/samples.hpp"

#include <gtest/gtest.h>
#include <set>

using namespace grader;

namespace {

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::size_t countOf(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size())
        ++count;
    return count;
}

std::string pageOf(const Report& report, const std::string& name) {
    const auto folder = samples::folderFor(name);
    samples::writeImages(report, folder);
    return html(report, folder);
}

// Are all attributes' values in double quotes?
bool isQuoted(const std::string& tag) {
    bool inside = false;
    for (std::size_t i = 0; i < tag.size(); ++i) {
        if (!inside && tag[i] == '=' && tag.compare(i + 1, 1, "\"") != 0)
            return false;
        inside ^= tag[i] == '"';
    }
    return !inside;
}

// Where tags are not nested properly, or an attribute is not quoted; "" if all is well.
std::string nestingComplaint(const std::string& html) {
    static const std::set<std::string> single = {"!DOCTYPE", "meta", "img", "br"};
    std::vector<std::string> open;
    for (std::size_t at = 0; (at = html.find('<', at)) != std::string::npos;) {
        const std::size_t end = html.find('>', at);
        if (end == std::string::npos)
            return "a tag without end";
        const std::string tag = html.substr(at + 1, end - at - 1);
        at = end;
        const bool closes = tag.starts_with('/');
        const std::string name = tag.substr(closes, tag.find_first_of(" /", closes) - closes);
        if (!isQuoted(tag))
            return "quotes in <" + tag.substr(0, 80) + ">";
        if (single.contains(name) || tag.ends_with('/'))
            continue;
        if (!closes) {
            open.push_back(name);
            if (name == "script" || name == "style")  // what is in it is no markup
                at = html.find("</" + name, at) - 1;
        } else if (open.empty() || open.back() != name) {
            return "</" + name + "> closes <" + (open.empty() ? "" : open.back()) + ">";
        } else {
            open.pop_back();
        }
    }
    return open.empty() ? "" : "<" + open.back() + "> stays open";
}

std::vector<ClassMember> theClass() {
    std::vector<ClassMember> members;
    for (const Report& report : samples::aClass())
        members.push_back({report, std::to_string(members.size()) + "/report.html"});
    return members;
}

}  // namespace

TEST(ReportPage, isWellFormed) {
    for (const Report& report : samples::all())
        EXPECT_EQ(nestingComplaint(pageOf(report, "formed")), "") << report.submission;
    EXPECT_EQ(nestingComplaint(overview(theClass(), Language::en)), "");
    EXPECT_EQ(nestingComplaint(overview(theClass(), Language::it)), "");
    EXPECT_NE(nestingComplaint("<p><b></p>"), "");
    EXPECT_NE(nestingComplaint("<p a=\"b></p>"), "");
}

TEST(ReportPage, needsNothingFromElsewhere) {
    const std::string page = pageOf(samples::partialMarks(), "alone");
    EXPECT_TRUE(holds(
        page,
        "Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src 'unsafe-inline'"));
    for (const char* foreign : {"http:", "https:", "src=\"/", "url(", "@import", "<script", "<link"})
        EXPECT_FALSE(holds(page, foreign)) << foreign;
    EXPECT_EQ(countOf(page, "<img src=\"data:image/png;base64,iVBORw0KGgo"), 3);
}

TEST(ReportPage, saysEverythingAboutACheck) {
    const std::string page = pageOf(samples::partialMarks(), "complete");
    for (const char* words : {"9.5 of 14 points.",
                              "4 of 6 checks passed.",
                              "not yet",
                              "in part",
                              "slide 29",
                              "The side that faces the point light is dark",
                              "w points from the surface",
                              "Draw w on paper",
                              "w points away from the light, or the normal is flipped",
                              "explains 97 % of the wrong pixels",
                              "width:97.3%",
                              "x 117, y 64",
                              "0.8627",
                              "max(0, n . w_1)",
                              "border of light and shade",
                              "3 %",
                              "12841",
                              "yellow 0.4 or more",
                              "notes/plan.odt",
                              "left out: not a source file",
                              "drawing...",
                              "lwjgl-basics"})
        EXPECT_TRUE(holds(page, words)) << words;
}

TEST(ReportPage, speaksItalian) {
    const std::string page = pageOf(samples::partialMarks(Language::it), "italian");
    EXPECT_TRUE(holds(page, "<html lang=\"it\">"));
    for (const char* words : {"9.5 su 14 punti.", "Comincia da:", "non ancora", "in parte", "Sembra questo",
                              "Il pixel peggiore", "confine tra luce e ombra", "Che cosa è stato consegnato"})
        EXPECT_TRUE(holds(page, words)) << words;
    for (const char* words : {"not yet", "Expected", "This looks like", "points."})
        EXPECT_FALSE(holds(page, words)) << words;
}

TEST(ReportPage, withoutMarksShowsNoScore) {
    for (const Report& report : {samples::infrastructure(), samples::notGradable()}) {
        const std::string page = pageOf(report, "none");
        EXPECT_FALSE(holds(page, " of 14"));
        EXPECT_TRUE(holds(page, "No marks:"));
        EXPECT_TRUE(holds(page, report.reason));
    }
}

TEST(ReportPage, everyPictureHasWordsAndEveryPageOneTitle) {
    for (const Report& report : samples::all()) {
        const std::string page = pageOf(report, "words");
        EXPECT_EQ(countOf(page, "<img "), countOf(page, "alt=\""));
        EXPECT_FALSE(holds(page, "alt=\"\""));
        EXPECT_EQ(countOf(page, "<h1"), 1);
    }
}

TEST(ReportPage, theCompilersWordsAreOpenWhereItDoesNotBuild) {
    EXPECT_TRUE(
        holds(pageOf(samples::doesNotBuild(), "log"), "<details open><summary>What the compiler said"));
}

TEST(Overview, tellsTheInstructorEverything) {
    const std::string page = overview(theClass(), Language::en);
    for (const char* words :
         {"22 submissions, 20 with marks.", "gallo_sara", "grade again", "costa_paolo.zip",
          "the zip is broken", "These render from the same source: reported, never judged.",
          "verdi_marco.zip", "the distance in place of its square", "href=\"./1/report.html\"",
          "Time, in seconds: building 71.5, rendering 33, judging 16.5; in all 121."})
        EXPECT_TRUE(holds(page, words)) << words;
    EXPECT_LT(page.find("Without marks"), page.find("Points, in percent"));
    EXPECT_TRUE(holds(page, "Submissions by percentage of the points: 0–10 %: 1, 10–20 %: 0"));
}

TEST(Overview, linksAreEncoded) {
    Report report = samples::fullMarks();
    const std::string page = overview({{report, "a b/#1?\"è.html"}}, Language::en);
    EXPECT_TRUE(holds(page, "href=\"./a%20b/%231%3F%22%C3%A8.html\""));
}

TEST(Overview, ofNobody) { EXPECT_EQ(nestingComplaint(overview({}, Language::it)), ""); }
