// The tool `check`: a student's own look at a submission, again with every save; mine, expected, difference.
// SPDX-License-Identifier: MIT
#include "grader/check/loops.hpp"
#include "grader/grading/command_line.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <iostream>

namespace {

using namespace grader;

constexpr int frameSize = 384;  // larger than grade's: a person looks at them
constexpr const char* pictureWithoutWindow = "check.png";

void findFile(CheckRequest& request) {
    namespace fs = std::filesystem;
    if (!fs::exists(request.file))
        throw UsageError(
            request.file.string() +
            ": is not there; expected a lesson's .cpp, a shader's .glsl, or the folder of a starter");
    request.file = fs::absolute(request.file).lexically_normal();
    if (!request.file.has_filename())  // "." and "folder/"
        request.file = request.file.parent_path();
    request.grading.onlyGiven = !fs::is_directory(request.file);
}

int checkWith(CheckRequest request) {
    if (!request.once && request.picture.empty()) {
        std::string reason;
        const std::string title = request.grading.lesson + " - check";
        if (const auto window = lab::openWindow(1280, 720, title, reason))
            return checkInWindow(request, *window);
        std::cerr << "check: no window (" << reason << "); the picture is written to " << pictureWithoutWindow
                  << "\n";
        request.picture = pictureWithoutWindow;
    }
    return checkInTerminal(request);
}

int run(int argc, char** argv) {
    CLI::App app("check: what your lesson or shader draws, what is expected, and the difference; again "
                 "whenever you save");
    CheckRequest request;
    std::string lang, theme, letters;
    app.set_version_flag("--version", LAMBERT_VERSION);
    app.add_option("LESSON", request.grading.lesson, "A name, a part of one, or a number")->required();
    app.add_option("FILE", request.file, "A lesson's .cpp, a shader's .glsl, or the folder of a starter")
        ->required();
    app.add_option("--picture", request.picture,
                   "Write the pictures to this file instead of opening a window");
    app.add_flag("--once", request.once, "One verdict, then end: 0 all right, 1 not right yet; no window");
    app.add_option("--lang", lang, "it or en, by default the locale's")->check(CLI::IsMember({"it", "en"}));
    app.add_option("--rubric", request.grading.rubric, "The course's own rubric, instead of the lesson's");
    const auto* const presenter =
        app.add_option("--presenter", letters, "[N]: large type for a projector, N from 16 to 48 (28)")
            ->expected(0, 1);
    app.add_option("--theme", theme, "dark or light")->check(CLI::IsMember({"dark", "light"}));
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? AllRight : CheckUsage;
    }
    request.grading.publicViews = true;
    request.grading.size = frameSize;
    request.grading.language = languageOf(lang);
    request.style.light = theme == "light";
    if (presenter->count() > 0)
        request.style.fontSize = 28;
    if (!letters.empty()) {
        request.style.fontSize = std::atoi(letters.c_str());
        if (request.style.fontSize < 16 || request.style.fontSize > 48)
            throw UsageError("--presenter: expected a number from 16 to 48, found " + letters);
    }
    findFile(request);
    return checkWith(std::move(request));
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const UsageError& error) {
        std::cerr << "check: " << error.what() << '\n';
        return CheckUsage;
    } catch (const std::exception& error) {
        std::cerr << "check: " << error.what() << '\n';
        return CheckCannot;
    }
}
