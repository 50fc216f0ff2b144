// Chooses the lesson, makes the starter's files, and writes them all at once.
// SPDX-License-Identifier: MIT
#include "starter.hpp"

#include "starter_text.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <sys/stat.h>

namespace fs = std::filesystem;

namespace nuovo {
namespace {

constexpr std::size_t kTermLimit = std::size_t{1} << 20U;  // bytes

using Rule = std::function<bool(const Lesson&)>;

std::vector<Rule> rulesFor(const std::string& asked) {
    const bool isNumber =
        !asked.empty() && asked.size() <= 2 && asked.find_first_not_of("0123456789") == std::string::npos;
    const int number = isNumber ? std::stoi(asked) : -2;  // -1 is what lies outside the chain
    return {[&asked](const Lesson& lesson) { return lesson.stem == asked; },
            [number](const Lesson& lesson) { return lesson.number == number; },
            [&asked](const Lesson& lesson) { return lesson.stem.rfind(asked, 0) == 0; },
            [&asked](const Lesson& lesson) { return lesson.stem.find(asked) != std::string::npos; }};
}

std::string names(const std::vector<const Lesson*>& lessons) {
    std::string text;
    for (const Lesson* const lesson : lessons) {
        text += "\n    " + lesson->stem;
    }
    return text;
}

/// A new folder beside `directory`, so that renaming it is one step; removed again unless keep() was called.
class TemporaryFolder {
  public:
    explicit TemporaryFolder(const fs::path& directory) {
        std::string name =
            (directory.parent_path() / ("." + directory.filename().string() + ".XXXXXX")).string();
        if (mkdtemp(name.data()) == nullptr) {
            throw FolderError(
                directory.parent_path().string() +
                ": no folder can be made there; expected one that exists and that you may write to");
        }
        path_ = name;
        const mode_t mask = umask(0);
        umask(mask);
        fs::permissions(path_, static_cast<fs::perms>(0777U & ~mask));  // mkdtemp's is for its owner alone
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);  // nothing, once it was renamed
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

void checkTarget(const fs::path& directory) {
    std::error_code ignored;
    const fs::file_status status = fs::status(directory, ignored);
    if (fs::exists(status) && !fs::is_directory(status)) {
        throw FolderError(directory.string() + ": is a file; expected a new folder's name; choose another");
    }
    if (fs::exists(status) && !fs::is_empty(directory, ignored)) {
        throw FolderError(
            directory.string() +
            ": is not empty; expected a new or empty folder, so that no work is lost; choose another");
    }
    if (fs::exists(status) && fs::equivalent(directory, fs::current_path(), ignored)) {
        throw FolderError(directory.string() +
                          ": is where you are; expected the name of a new folder, which would be made here");
    }
}

}  // namespace

const Lesson& findStarter(const LessonSet& lessons, const std::string& asked) {
    std::vector<const Lesson*> found;
    for (const Rule& matches : rulesFor(asked)) {
        for (const std::vector<Lesson>* const some : {&lessons.chain, &lessons.others}) {
            for (const Lesson& lesson : *some) {
                if (matches(lesson)) {
                    found.push_back(&lesson);
                }
            }
        }
        if (!found.empty()) {
            break;
        }
    }
    std::vector<const Lesson*> all;
    for (const Lesson& lesson : lessons.chain) {
        if (lesson.number > 0) {
            all.push_back(&lesson);
        }
    }
    if (found.size() != 1) {
        throw NoStarter("'" + asked +
                        "' is not the name of one lesson. Choose from:" + names(found.empty() ? all : found));
    }
    if (found[0]->number < 1) {
        throw NoStarter(found[0]->stem + " has no starter: " +
                        (found[0]->number == 0 ? "there is no lesson before it to start from"
                                               : "it is no step of the chain of lessons") +
                        ". Choose from:" + names(all));
    }
    return *found[0];
}

Folder makeStarter(const Lesson& lesson, const fs::path& tasksFile, const fs::path& shaders,
                   const std::string& lang) {
    if (lesson.count(LineKind::Faulty) > 0) {
        throw InputError(lesson.file.string() +
                         ": has faulty marks; expected what `nuovo check` accepts; run it");
    }
    const LessonTasks tasks = readTasks(tasksFile, lesson);
    Folder folder;
    folder[lesson.stem + ".cpp"] = starterLesson(lesson, tasks, lang);
    folder["CMakeLists.txt"] = starterCMake(lesson, lang);
    folder["README.md"] = starterReadme(lesson, tasks, lang);
    for (const auto& [term, task] : tasks.terms) {
        const std::string name = "terms/" + term + ".glsl";
        const fs::path file = shaders / name;
        folder[name] = starterTerm(readText(file, kTermLimit), term, task.at(lang), file.string());
    }
    return folder;
}

void writeFolder(const Folder& folder, const fs::path& asked) {
    fs::path directory = fs::absolute(asked).lexically_normal();
    if (!directory.has_filename()) {
        directory = directory.parent_path();
    }
    checkTarget(directory);
    const TemporaryFolder temporary(directory);
    std::error_code error;
    for (const auto& [name, text] : folder) {
        const fs::path file = temporary.path() / name;
        fs::create_directories(file.parent_path(), error);
        if (!(std::ofstream(file, std::ios::binary) << text << std::flush)) {
            throw FolderError((directory / name).string() + ": cannot be written; is the disk full?");
        }
    }
    fs::rename(temporary.path(), directory, error);
    if (error) {
        throw FolderError(directory.string() + ": the new folder cannot take this name: " + error.message() +
                          "; choose another");
    }
}

}  // namespace nuovo
