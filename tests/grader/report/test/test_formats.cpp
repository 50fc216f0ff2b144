// Every format read back: facts, and the traps of each gradebook.
// SPDX-License-Identifier: MIT
#include "grader/report/formats/formats.hpp"
#include "grader/report/test/samples.hpp"
#include "image/write.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

using namespace grader;
using Json = nlohmann::json;

namespace {

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

std::vector<Report> withoutMarks() { return {samples::infrastructure(), samples::notGradable()}; }

// A folder with this report's pictures.
std::filesystem::path folderOf(const Report& report, const std::string& name) {
    const auto folder = samples::folderFor(name);
    samples::writeImages(report, folder);
    return folder;
}

// What others wrote must never be a tag.
void expectNoScript(const std::string& html) {
    EXPECT_FALSE(holds(html, "<script")) << html.substr(0, 200);
    EXPECT_FALSE(holds(html, "\x1B"));
    EXPECT_FALSE(holds(html, "\xE2\x80\xAE"));
}

}  // namespace

TEST(Formats, namesForTheCommandLine) {
    EXPECT_EQ(parseFormats("junit,gradescope,junit"),
              (std::vector<Format>{Format::junit, Format::gradescope}));
    for (const char* bad : {"", "junit,", "JUnit", "junit gradescope", "pdf"}) {
        try {
            parseFormats(bad);
            ADD_FAILURE() << bad << " was not refused";
        } catch (const std::runtime_error& error) {
            EXPECT_TRUE(holds(error.what(), "expected some of gradescope, prairielearn,")) << error.what();
        }
    }
    EXPECT_STREQ(nameOf(Format::vpl), "vpl");
    EXPECT_STREQ(fileNameOf(Format::csv), "report.csv");
}

TEST(Formats, theSameReportGivesTheSameBytes) {
    const Report report = samples::partialMarks();
    const auto folder = folderOf(report, "bytes");
    for (const Format each : parseFormats("gradescope,prairielearn,autolab,coderunner,vpl,junit,csv,html"))
        EXPECT_EQ(format(report, folder, each), format(report, folder, each)) << nameOf(each);
}

TEST(Formats, gradescope) {
    const Report report = samples::partialMarks();
    const Json json = Json::parse(gradescope(report, folderOf(report, "gradescope")));
    EXPECT_EQ(json["score"], 9.5);
    EXPECT_EQ(json["stdout_visibility"], "hidden");
    const Json& wrong = json["tests"][3];
    EXPECT_EQ(wrong["status"], "failed");
    EXPECT_EQ(wrong["score"], 0);
    EXPECT_EQ(wrong["max_score"], 3);
    EXPECT_EQ(wrong["output_format"], "html");
    EXPECT_TRUE(holds(wrong["output"], "<img src=\"data:image/png;base64,iVBORw0KGgo"));
    EXPECT_TRUE(holds(wrong["output"], "The side that faces the point light is dark"));  // stands alone
    EXPECT_FALSE(json["tests"][4].contains("status"));  // in part: neither passed nor failed
    EXPECT_EQ(json["tests"][0]["status"], "passed");
    EXPECT_FALSE(json["tests"][6].contains("score"));  // what the program said: for information
    for (const Json& test : json["tests"])
        EXPECT_NE(test.value("visibility", "visible"), "");
}

TEST(Formats, gradescopeKeepsEachChecksVisibility) {
    Report report = samples::fullMarks();
    report.checks[2].visibility = "after_published";
    EXPECT_EQ(Json::parse(gradescope(report, "."))["tests"][2]["visibility"], "after_published");
}

TEST(Formats, gradescopeHasNoScoreWithoutMarks) {
    for (const Report& report : withoutMarks()) {
        const std::string text = gradescope(report, ".");
        EXPECT_FALSE(holds(text, "score\":")) << text;
        EXPECT_TRUE(holds(Json::parse(text)["output"], report.reason));
    }
}

TEST(Formats, prairielearn) {
    const Report report = samples::partialMarks(Language::it);
    const Json json = Json::parse(prairielearn(report, folderOf(report, "prairielearn")));
    EXPECT_EQ(json["gradable"], true);
    EXPECT_DOUBLE_EQ(json["score"].get<double>(), 9.5 / 14);  // 0 to 1
    EXPECT_EQ(json["tests"][3]["images"].size(), 3);
    EXPECT_EQ(json["tests"][3]["images"][0]["url"].get<std::string>().substr(0, 22),
              "data:image/png;base64,");
    EXPECT_EQ(json["tests"][4]["points"], 2.5);
    EXPECT_EQ(json["tests"][4]["max_points"], 4);
}

TEST(Formats, prairielearnUsesUpNoAttemptWithoutMarks) {
    for (const Report& report : withoutMarks()) {
        const Json json = Json::parse(prairielearn(report, "."));
        EXPECT_EQ(json["gradable"], false);
        EXPECT_FALSE(json.contains("score"));
        EXPECT_TRUE(holds(json["format_errors"][0], report.reason));
    }
}

// Pictures of noise, which no compression makes smaller.
TEST(Formats, prairielearnStaysBelowOneMegabyte) {
    Report report = samples::fullMarks();
    const auto folder = samples::folderFor("large");
    std::mt19937 random(2026);
    image::Frame noise{256, 256, image::Bytes(256 * 256 * 3)};
    for (auto& byte : std::get<image::Bytes>(noise.pixels))
        byte = static_cast<std::uint8_t>(random());
    image::write((folder / "noise.png").string(), noise, {});
    for (int i = 0; i < 12; ++i) {
        const std::string id = "view-" + std::to_string(i);
        report.images.push_back({id, "yours", id, "noise.png", 256, 256});
        report.checks[2].images.push_back(id);
    }
    report.buildLog = std::string(3000000, 'x');
    const std::string text = prairielearn(report, folder);
    EXPECT_LT(text.size(), 1000000U);
    EXPECT_GT(text.size(), 400000U);  // no more was given up than needed
    EXPECT_EQ(Json::parse(text)["tests"][2]["images"].size(), 12);
}

TEST(Formats, prairielearnDropsTheLeastImportantLast) {
    Report report = samples::partialMarks();
    const auto folder = folderOf(report, "many");
    report.images[0].label = "the important one";
    for (int i = 0; i < 3000; ++i) {
        const std::string id = "copy-" + std::to_string(i);
        report.images.push_back({id, "yours", id, report.images[0].file, 192, 192});
        report.checks[2].images.push_back(id);  // a check that passed
    }
    const std::string text = prairielearn(report, folder);
    EXPECT_LT(text.size(), 1000000U);
    const Json json = Json::parse(text);
    EXPECT_EQ(json["tests"][3]["images"].size(), 3);
    EXPECT_LT(json["tests"][2]["images"].size(), 3000);
}

TEST(Formats, autolabEndsWithTheScores) {
    for (const Report& report : {samples::partialMarks(), samples::hostile()}) {
        const auto lines = linesOf(autolab(report));
        const Json last = Json::parse(lines.back());
        EXPECT_EQ(last["scores"]["37.5"], 0);
        EXPECT_EQ(last["scores"].size(), 6);
        const Json semantic = Json::parse(lines.at(lines.size() - 2));
        EXPECT_EQ(semantic["_presentation"], "semantic");
        EXPECT_EQ(semantic["Build"]["The program builds"]["passed"], true);
        for (std::size_t i = 0; i + 2 < lines.size(); ++i)
            EXPECT_FALSE(lines[i].starts_with("{")) << lines[i];
    }
}

TEST(Formats, autolabGivesNoScoresWithoutMarks) {
    for (const Report& report : withoutMarks())
        EXPECT_EQ(Json::parse(linesOf(autolab(report)).back()), Json::parse(R"({"scores":{}})"));
}

TEST(Formats, coderunner) {
    const Report report = samples::partialMarks();
    const Json json = Json::parse(coderunner(report, folderOf(report, "coderunner")));
    EXPECT_DOUBLE_EQ(json["fraction"].get<double>(), 9.5 / 14);
    const Json& rows = json["testresults"];
    EXPECT_EQ(rows[0], Json::parse(R"(["iscorrect","Check","Points","Feedback","ishidden"])"));
    EXPECT_EQ(json["columnformats"].size(), 3);
    for (const Json& row : rows)
        EXPECT_EQ(row.size(), 5);
    EXPECT_EQ(rows[5][0], 0.625);
    EXPECT_TRUE(holds(rows[4][3], "<img src=\"view-2-yours.png\""));
    EXPECT_EQ(json["files"].size(), 3);
    EXPECT_EQ(json["files"]["view-2-yours.png"].get<std::string>().substr(0, 11), "iVBORw0KGgo");
    for (const auto& [key, value] : json.items())  // CodeRunner refuses others
        EXPECT_TRUE(key == "fraction" || key == "prologuehtml" || key == "epiloguehtml" ||
                    key == "testresults" || key == "columnformats" || key == "files")
            << key;
}

TEST(Formats, coderunnerHasNoFractionWithoutMarks) {
    for (const Report& report : withoutMarks()) {
        const Json json = Json::parse(coderunner(report, "."));
        EXPECT_FALSE(json.contains("fraction"));
        EXPECT_FALSE(json.contains("showoutputonly"));  // would be full marks
    }
}

TEST(Formats, vplHasOneGrade) {
    for (const Report& report : {samples::partialMarks(), samples::hostile()}) {
        const auto lines = linesOf(vpl(report));
        EXPECT_EQ(lines.front(), "<|--");
        EXPECT_EQ(lines.at(lines.size() - 2), "--|>");
        EXPECT_EQ(lines.back(), report.submission == "bianchi_luca.zip" ? "Grade :=>> 9.5" : "Grade :=>> 11");
        for (std::size_t i = 1; i + 2 < lines.size(); ++i) {
            EXPECT_TRUE(lines[i][0] == '-' || lines[i][0] == '>') << lines[i];
            for (const char* tag : {":=>>", "<|--", "--|>"})
                EXPECT_FALSE(holds(lines[i], tag)) << lines[i];
        }
    }
}

TEST(Formats, vplProposesNoGradeWithoutMarks) {
    for (const Report& report : withoutMarks())
        EXPECT_FALSE(holds(vpl(report), "Grade"));
}

TEST(Formats, csvFollowsRfc4180) {
    Report report = samples::fullMarks();
    report.submission = "Rossi, \"Anna\"\nline";
    EXPECT_EQ(csv(report),
              "submission,lesson,status,score,max_score,builds,runs,cosine,37.5,attenuation,ambient\r\n"
              "\"Rossi, \"\"Anna\"\" line\",lesson_05_attenuation,graded,14,14,1,1,3,3,4,2\r\n");
}

TEST(Formats, csvNeutralisesFormulas) {
    Report report = samples::fullMarks();
    for (const char* formula : {"=1+1", "+1", "-1", "@SUM(A1)", "\tx", "\r=1", " =1", "\x1B[0m=1"}) {
        report.submission = formula;
        EXPECT_EQ(linesOf(csv(report)).at(1)[0], '\'') << formula;
    }
}

TEST(Formats, csvLeavesScoresEmptyWithoutMarks) {
    const std::string text =
        marksCsv({samples::infrastructure(), samples::notGradable(), samples::fullMarks()});
    const auto lines = linesOf(text);
    EXPECT_EQ(lines.at(1), "costa_paolo.zip,lesson_05_attenuation,not_gradable,,14,,,,,,\r");
    EXPECT_EQ(lines.at(2), "gallo_sara,lesson_05_attenuation,infrastructure,,14,,,,,,\r");
    EXPECT_EQ(lines.at(3).substr(0, 10), "rossi_anna");
}

TEST(Formats, marksDoNotDependOnOrderOrTime) {
    std::vector<Report> reports = samples::aClass();
    const std::string before = marksCsv(reports);
    std::swap(reports.front(), reports.at(4));
    for (Report& report : reports)
        report.compileSeconds = 77;
    EXPECT_EQ(marksCsv(reports), before);
}

TEST(Formats, hiddenChecksAreNotTold) {
    Report report = samples::partialMarks();
    report.checks[3].visibility = "hidden";
    const std::string secret = report.checks[3].message;
    const auto folder = folderOf(report, "hidden");
    for (const Format each : parseFormats("prairielearn,autolab,coderunner,vpl,html"))
        EXPECT_FALSE(holds(format(report, folder, each), secret)) << nameOf(each);
    EXPECT_EQ(Json::parse(coderunner(report, folder))["testresults"][4][4], 1);
    EXPECT_TRUE(holds(html(report, folder), "One more check is not shown here."));
}

TEST(Formats, studentsNeverSeeWhatIsForTheInstructor) {
    const Report report = samples::partialMarks();
    const auto folder = folderOf(report, "student");
    for (const Format each : parseFormats("gradescope,prairielearn,autolab,coderunner,vpl,junit,csv,html")) {
        const std::string text = format(report, folder, each);
        EXPECT_FALSE(holds(text, "verdi_marco")) << nameOf(each);
        EXPECT_FALSE(holds(text, report.rubricHash)) << nameOf(each);
    }
}

TEST(Formats, picturesComeFromTheFolderAlone) {
    Report report = samples::partialMarks();
    const auto folder = folderOf(report, "outside");
    std::filesystem::create_directories(folder / "inner");
    for (ReportImage& image : report.images)
        image.file = "../" + image.file;
    EXPECT_FALSE(holds(html(report, folder / "inner"), "<img"));
    EXPECT_FALSE(holds(gradescope(report, folder / "inner"), "<img"));
}

TEST(Formats, hostileTextStaysText) {
    const Report report = samples::hostile();
    const auto folder = folderOf(report, "hostile");
    for (const Format each : parseFormats("gradescope,prairielearn,autolab,coderunner,vpl,junit,csv,html")) {
        const std::string text = format(report, folder, each);
        EXPECT_FALSE(holds(text, "\x1B")) << nameOf(each);
        EXPECT_FALSE(holds(text, "\xE2\x80\xAE")) << nameOf(each);
        EXPECT_FALSE(holds(text, "\xFF")) << nameOf(each);
    }
    expectNoScript(html(report, folder));
    expectNoScript(junit(report));
    const Json moodle = Json::parse(coderunner(report, folder));
    for (const Json& row : moodle["testresults"])
        expectNoScript(row[3]);
    expectNoScript(moodle["prologuehtml"].get<std::string>() + moodle["epiloguehtml"].get<std::string>());
    const Json scope = Json::parse(gradescope(report, folder));
    for (const Json& test : scope["tests"])
        if (test["output_format"] == "html")
            expectNoScript(test["output"]);
}
