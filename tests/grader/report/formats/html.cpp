// The student's page: everything in one file, nothing fetched, nothing run.
// SPDX-License-Identifier: MIT
#include "grader/report/formats/html_parts.hpp"

namespace grader {

namespace {

// "4 of 6 checks passed. Start with: ..." with a link to that card.
std::string whereToStart(const Report& report) {
    const Language language = report.language;
    std::size_t passed = 0, shown = 0, first = report.checks.size();
    for (std::size_t i = report.checks.size(); i-- > 0;) {
        if (!isShown(report.checks[i]))
            continue;
        ++shown;
        passed += report.checks[i].status == CheckStatus::pass;
        if (hasCard(report.checks[i]) && report.checks[i].status != CheckStatus::pass)
            first = i;
    }
    if (report.status != ReportStatus::graded || shown == 0)
        return "";
    std::string html = "<p>" + std::to_string(passed) + say(language, " of ", " su ") +
                       std::to_string(shown) + say(language, " checks passed.", " controlli superati.");
    if (first < report.checks.size())
        html += std::string(" ") + say(language, "Start with: ", "Comincia da: ") + "<a href=\"#check-" +
                std::to_string(first) + "\">" + escaped(oneLine(report.checks[first].title)) + "</a>.";
    return html + "</p>\n";
}

std::string top(const Report& report) {
    const bool graded = report.status == ReportStatus::graded;
    return std::string("<header class=\"card top") + (graded ? "" : " notice") + "\">\n" + scoreRing(report) +
           "\n<div>" + element("p", oneLine(report.submission), "eyebrow") +
           element("h1", oneLine(report.lessonTitle.empty() ? report.lesson : report.lessonTitle)) +
           element("p", headline(report), "verdict") + whereToStart(report) +
           element("p", hiddenSentence(report), "soft small") + "</div>\n</header>\n";
}

std::string listRow(const Report& report, std::size_t index) {
    const Check& check = report.checks[index];
    std::string name = escaped(oneLine(check.title));
    std::string below = hasCard(check) ? "" : oneLine(check.message);
    if (!check.isNew)
        below += std::string(below.empty() ? "" : " ") +
                 say(report.language, "(Already in the starter.)", "(C'era già nella base.)");
    if (hasCard(check))
        name = "<a href=\"#check-" + std::to_string(index) + "\">" + name + "</a>";
    return "<li class=\"row\">" + pill(report.language, check.status) + "<span class=\"name\">" + name +
           element("small", below) + "</span><span class=\"num soft\">" + points(check.score) + " / " +
           points(check.maxScore) + "</span></li>\n";
}

std::string contents(const Report& report) {
    std::string rows;
    for (std::size_t i = 0; i < report.checks.size(); ++i)
        if (isShown(report.checks[i]))
            rows += listRow(report, i);
    return rows.empty() ? ""
                        : std::string("<nav class=\"card\" style=\"padding:0\" aria-label=\"") +
                              say(report.language, "All checks", "Tutti i controlli") +
                              "\"><ul class=\"list\">\n" + rows + "</ul></nav>\n";
}

const char* roleOf(Language language, const std::string& role) {
    if (role == "lesson")
        return say(language, "the program", "il programma");
    if (role == "term")
        return say(language, "a term of the shader", "un termine dello shader");
    if (role == "header")
        return say(language, "included by the program", "incluso dal programma");
    return say(language, "left out", "escluso");
}

std::string files(const Report& report) {
    const Language language = report.language;
    std::string rows;
    for (const SubmittedFile& file : report.files)
        rows += "<tr><th scope=\"row\" class=\"symbol\">" + escaped(oneLine(file.path)) + "</th><td>" +
                roleOf(language, file.role) + (file.note.empty() ? "" : ": " + escaped(oneLine(file.note))) +
                "</td><td class=\"num\">" + std::to_string(file.bytes) + "</td></tr>\n";
    if (rows.empty())
        return "";
    return std::string("<section class=\"card\">\n<h2>") +
           say(language, "What was handed in", "Che cosa è stato consegnato") +
           "</h2>\n<table class=\"files\"><thead><tr><th scope=\"col\">" + say(language, "file", "file") +
           "</th><th scope=\"col\">" + say(language, "used as", "usato come") + "</th><th scope=\"col\">" +
           say(language, "bytes", "byte") + "</th></tr></thead>\n<tbody>" + rows +
           "</tbody></table>\n</section>\n";
}

std::string folded(const char* title, const std::string& text, bool open) {
    return text.empty() ? ""
                        : std::string("<details") + (open ? " open" : "") + "><summary>" + title +
                              "</summary>" + element("pre", text) + "</details>\n";
}

std::string logs(const Report& report) {
    const bool built = report.checks.empty() || report.checks[0].status == CheckStatus::pass;
    const std::string all =
        folded(say(report.language, "What the compiler said", "Che cosa ha detto il compilatore"),
               report.buildLog, !built) +
        folded(say(report.language, "What the program said", "Che cosa ha detto il programma"), report.said,
               false);
    return all.empty() ? "" : "<section class=\"card\">\n" + all + "</section>\n";
}

std::string foot(const Report& report) {
    return element("footer",
                   "Lambert Lab " + oneLine(report.toolVersion) + " · " + oneLine(report.lesson) + " · " +
                       oneLine(report.renderer) +
                       (report.submissionHash.empty() ? "" : " · SHA-256 " + oneLine(report.submissionHash)));
}

}  // namespace

std::string html(const Report& report, const std::filesystem::path& folder) {
    std::string body = top(report);
    if (report.status == ReportStatus::graded) {
        body += contents(report);
        for (std::size_t i = 0; i < report.checks.size(); ++i)
            if (isShown(report.checks[i]) && hasCard(report.checks[i]))
                body += checkCard(report, report.checks[i], i, folder);
    }
    body += files(report) + logs(report) + foot(report);
    return page(report.language, report.submission + " · " + report.lesson, "student", body);
}

}  // namespace grader
