// The tool `nuovo`: checks that every lesson is the one before plus its tagged lines, and prints each step.
// SPDX-License-Identifier: MIT
#include "checks.hpp"
#include "input.hpp"
#include "refs.hpp"
#include "starter.hpp"
#include "table.hpp"

#include <CLI/CLI.hpp>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

namespace {

enum ExitStatus { Done = 0, RuleFailed = 1, WrongUsage = 2, UnreadableInput = 4, CannotWrite = 5 };

/// A folder of the lab to which this program belongs: beside it where it is installed, else the source tree's.
std::filesystem::path own(const char* folder) {
    std::error_code ignored;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored);
    return std::filesystem::weakly_canonical(program / "../../share/lambert-lab" / folder, ignored);
}

/// Where the lessons and the slides are: the lab's own, unless the command line says otherwise.
struct Inputs {
    std::string lessons = own("lessons");
    std::string slides = own("slides_refs") / "slides.json";

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

int runRefs(const Inputs& inputs, const std::string& readme, bool isCheck) {
    const int line = nuovo::renewReadme(nuovo::readCompanion(inputs.slides),
                                        nuovo::readLessons(inputs.lessons), readme, isCheck);
    if (line == 0) {
        return Done;
    }
    if (!isCheck) {
        std::cout << readme << " is renewed from line " << line << " on\n";
        return Done;
    }
    std::cerr << readme << ':' << line << ": is older than slides.json, the lessons or the shaders; "
              << "renew it with build/bin/nuovo refs\n";
    return RuleFailed;
}

/// What `nuovo starter` is asked for.
struct StarterRequest {
    std::string lesson;
    std::string directory;
    std::string tasks = own("slides_refs") / "tasks.json";
    std::string shaders = own("shaders");

    void addOptions(CLI::App& command) {
        command.add_option("LESSON", lesson, "A name, a part of one, or a number")->required();
        command.add_option("-o,--output", directory, "The folder to write: new, or empty")->required();
        command.add_option("--tasks", tasks, "What each TODO says")->capture_default_str();
        command.add_option("--shaders", shaders, "The lab's shaders")->capture_default_str();
    }
};

int runStarter(const Inputs& inputs, const StarterRequest& request, const std::string& lang) {
    try {
        const nuovo::LessonSet lessons = nuovo::readLessons(inputs.lessons);
        const nuovo::Lesson& lesson = nuovo::findStarter(lessons, request.lesson);
        nuovo::writeFolder(nuovo::makeStarter(lesson, request.tasks, request.shaders, lang),
                           request.directory);
        std::cout << request.directory << ": " << lesson.stem
                  << ", to be completed; begin with its README.md\n";
        return Done;
    } catch (const nuovo::NoStarter& error) {
        std::cerr << "nuovo: " << error.what() << '\n';
        return WrongUsage;
    } catch (const nuovo::FolderError& error) {
        std::cerr << "nuovo: " << error.what() << '\n';
        return CannotWrite;
    }
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
    CLI::App* const refs =
        app.add_subcommand("refs", "Renew what slides_refs/README.md derives from the rest");
    inputs.addOptions(*refs);
    std::string readme = own("slides_refs") / "README.md";
    refs->add_option("--readme", readme, "The file to renew")->capture_default_str();
    bool isCheck = false;
    refs->add_flag("--check", isCheck, "Write nothing; exit 1 if it would change");
    CLI::App* const starter =
        app.add_subcommand("starter", "Write a lesson to be completed, with TODOs in place of its new lines");
    StarterRequest request;
    request.addOptions(*starter);
    starter->add_option("--lessons", inputs.lessons, "Directory of the lessons' .cpp files")
        ->capture_default_str();
    starter->add_option("--lang", lang, "Language, by default the locale's")
        ->check(CLI::IsMember({"it", "en"}));
    CLI::App* const pictures = app.add_subcommand("pictures", "Print each picture's file and command");
    inputs.addOptions(*pictures);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? Done : WrongUsage;
    }
    if (pictures->parsed()) {
        nuovo::printPictures(nuovo::readCompanion(inputs.slides), nuovo::readLessons(inputs.lessons),
                             std::cout);
    }
    const int status = check->parsed()      ? runCheck(inputs)
                       : refs->parsed()     ? runRefs(inputs, readme, isCheck)
                       : pictures->parsed() ? Done
                       : starter->parsed()  ? runStarter(inputs, request, lang)
                                            : runTable(inputs, lang);
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
