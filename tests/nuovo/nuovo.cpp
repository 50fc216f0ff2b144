// The tool `nuovo`: checks that every lesson is the one before plus its tagged lines, and prints each step.
// SPDX-License-Identifier: MIT
#include "checks.hpp"
#include "input.hpp"
#include "table.hpp"

#include <CLI/CLI.hpp>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

namespace {

enum ExitStatus { Done = 0, RuleFailed = 1, WrongUsage = 2, UnreadableInput = 4, CannotWrite = 5 };

/// Where the lessons and the slides are: this source tree's, unless the command line says otherwise.
struct Inputs {
    std::string lessons = LAMBERT_SOURCE_DIR "/lessons";
    std::string slides = LAMBERT_SOURCE_DIR "/slides_refs/slides.json";

    void addOptions(CLI::App& command) {
        command.add_option("--lessons", lessons, "Directory of the lessons' .cpp files")
            ->capture_default_str();
        command.add_option("--slides", slides, "The slides' numbers and code")->capture_default_str();
    }
};

/// The language of the locale, as far as the tool speaks it.
std::string localeLanguage() {
    for (const char* const variable : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
        const char* const value = std::getenv(variable);
        if (value != nullptr && *value != '\0') {
            return std::string(value).rfind("it", 0) == 0 ? "it" : "en";
        }
    }
    return "en";
}

int runCheck(const Inputs& inputs) {
    const auto report = nuovo::check(nuovo::readLessons(inputs.lessons), nuovo::readSlides(inputs.slides));
    nuovo::printMatrix(report, std::cout);
    std::cout.flush();
    nuovo::printFailures(report, std::cerr);
    return report.ok() ? Done : RuleFailed;
}

int runTable(const Inputs& inputs, const std::string& lang) {
    nuovo::printTable(nuovo::readLessons(inputs.lessons), nuovo::readSlides(inputs.slides), lang, std::cout);
    return Done;
}

int run(int argc, char** argv) {
    CLI::App app("nuovo: the lessons' promise that each one is the one before plus its NUOVO lines");
    app.require_subcommand(1);
    Inputs inputs;
    std::string lang = localeLanguage();
    CLI::App* const check =
        app.add_subcommand("check", "Check every rule; exit 0 if all hold, 1 if one fails");
    inputs.addOptions(*check);
    CLI::App* const table = app.add_subcommand("table", "Print lessons, slides and new lines as Markdown");
    inputs.addOptions(*table);
    table->add_option("--lang", lang, "Language, by default the locale's")
        ->check(CLI::IsMember({"it", "en"}));
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? Done : WrongUsage;
    }
    const int status = check->parsed() ? runCheck(inputs) : runTable(inputs, lang);
    if (!std::cout.flush()) {
        std::cerr << "nuovo: standard output: cannot be written; is the disk full?\n";
        return CannotWrite;
    }
    return status;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const nuovo::InputError& error) {
        std::cerr << "nuovo: " << error.what() << '\n';
        return UnreadableInput;
    } catch (const std::exception& error) {  // memory, or a bug: nothing that a rule or an input explains
        std::cerr << "nuovo: unexpected: " << error.what() << '\n';
        return UnreadableInput;
    }
}
