// A small chain of lessons that keeps every rule, and means to break it.
// SPDX-License-Identifier: MIT
#pragma once

#include "checks.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

namespace nuovo::test {

/// File name -> text; std::map's order by name is the chain's.
using Files = std::map<std::string, std::string>;

/// Four lessons with a PRIMA, a tagged #include, a line with its own comment and one that cites no item, and
/// an interlude outside the chain.
inline Files validFiles() {
    const std::string top = "#include \"lab/lab.hpp\"\n";
    const std::string main = "\nint main(int argc, char** argv) {\n    auto app = lab::App(argc, argv, \"";
    const std::string end = "\n    return app.run(miaScena);\n}\n";
    return {
        {"lesson_00_scene.cpp", "// lesson_00_scene: nothing is lit yet\n// Slides 3, 34\n\n" + top + main +
                                    "lesson_00_scene\");\n    // la mesh, prima delle luci\n"
                                    "    THREE::Mesh miaMesh(buffers);\n" +
                                    end},
        {"lesson_01_material.cpp",
         "// lesson_01_material: the base colour D | black\n// Slides 9-15, 36.1-36.2\n\n" + top + main +
             "lesson_01_material\");\n    // la mesh, prima delle luci\n"
             "    // Slide 36.1: un nuovo materiale  // NUOVO 36.1\n"
             "    THREE::MeshLambertMaterial mioMat;  // NUOVO 36.1\n"
             "    THREE::Mesh miaMesh(buffers, mioMat);  // NUOVO 36.1\n"
             "    // PRIMA THREE::Mesh miaMesh(buffers);\n"
             "    mioMat.color.set(0xFF8855);  // NUOVO 36.2\n" +
             end},
        {"lesson_02_light.cpp",
         "// lesson_02_light: P = (n . w) D (x) L\n// NUOVO marks what is new.\n// Slides 16-30, 36.3\n\n" +
             top + "#include \"lab/light.hpp\"  // NUOVO 36\n" + main +
             "lesson_02_light\");\n    // la mesh, prima delle luci\n"
             "    // Slide 36.1: un nuovo materiale\n"
             "    THREE::MeshLambertMaterial mioMat;\n"
             "    THREE::Mesh miaMesh(buffers, mioMat);\n"
             "    mioMat.color.set(0xFF8855);\n"
             "    // Slide 36.3: la luce  // NUOVO 36.3\n\n"
             "    THREE::DirectionalLight miaLuce;  // NUOVO 36.3\n"
             "    miaScena.add(miaLuce);  // viene aggiunta  // NUOVO 36.3\n" +
             end},
        {"lesson_03_ambient.cpp", "// lesson_03_ambient: + D (x) L_A\n// Slides 40-43\n\n" + top +
                                      "#include \"lab/light.hpp\"\n" + main +
                                      "lesson_03_ambient\");\n    // la mesh, prima delle luci\n"
                                      "    // Slide 36.1: un nuovo materiale\n"
                                      "    THREE::MeshLambertMaterial mioMat;\n"
                                      "    THREE::Mesh miaMesh(buffers, mioMat);\n"
                                      "    mioMat.color.set(0xFF8855);\n"
                                      "    // Slide 36.3: la luce\n\n"
                                      "    THREE::DirectionalLight miaLuce;\n"
                                      "    miaScena.add(miaLuce);  // viene aggiunta\n"
                                      "    // Slide 43: luce ambiente, perché no  // NUOVO 43\n"
                                      "    THREE::AmbientLight luceAmbiente;  // NUOVO 43\n"
                                      "    miaScena.add(luceAmbiente);  // NUOVO 43\n"
                                      "    luceAmbiente.intensity = 0.5;  // NUOVO 42\n" +
                                      end},
        {"interlude_brdf.cpp", "// interlude_brdf: after lesson_00; the lines of lessons are tagged NUOVO\n\n"
                               "int main() { return 0; }  // un nuovo inizio\n"},
    };
}

inline const char* const kSlides = R"({"slides": [
    {"number": 3}, {"number": 34, "code": []}, {"number": 40}, {"number": 42},
    {"number": 36, "title": {"it": "Luci in three.js", "en": "Lights in three.js"}, "code": [
        {"item": "36.1", "lesson": "lesson_01_material",
         "cpp": ["THREE::MeshLambertMaterial mioMat;", "THREE::Mesh miaMesh(buffers, mioMat);"]},
        {"item": "36.2", "lesson": "lesson_01_material", "cpp": ["mioMat.color.set(0xFF8855);"]},
        {"item": "36.3", "lesson": "lesson_02_light",
         "cpp": ["THREE::DirectionalLight miaLuce;", "miaScena.add(miaLuce); // viene aggiunta"]}]},
    {"number": 43, "code": [{"item": "43", "lesson": "lesson_03_ambient",
        "cpp": ["THREE::AmbientLight luceAmbiente;", "miaScena.add(luceAmbiente);"]}]},
    {"number": 44, "code": [{"item": "44.1", "lesson": "lesson_09_later", "cpp": ["mioMat.shininess = 30;"]}]}
]})";

/// The same sorting that readLessons does, without a disk between.
inline LessonSet parseAll(const Files& files) {
    LessonSet set;
    for (const auto& [file, text] : files) {
        Lesson lesson = parseLesson(file, text);
        (lesson.number < 0 ? set.others : set.chain).push_back(std::move(lesson));
    }
    return set;
}

inline const std::string k00 = "lesson_00_scene.cpp";
inline const std::string k01 = "lesson_01_material.cpp";
inline const std::string k02 = "lesson_02_light.cpp";
inline const std::string k03 = "lesson_03_ambient.cpp";

/// A test with its own directory, in which `write` puts the valid chain after the edits that break it.
class OnDisk : public testing::Test {
  protected:
    OnDisk() {
        const auto* const test = testing::UnitTest::GetInstance()->current_test_info();
        directory = std::filesystem::path(testing::TempDir()) /
                    ("nuovo_" + std::to_string(getpid()) + "_" + test->name());
        std::filesystem::create_directories(directory);
    }
    ~OnDisk() override {
        std::error_code ignored;
        std::filesystem::remove_all(directory, ignored);
    }

    /// Replaces the one place where `from` stands in the file.
    void edit(const std::string& file, const std::string& from, const std::string& to) {
        std::string& text = files.at(file);
        const auto at = text.find(from);
        ASSERT_NE(at, std::string::npos) << file << " has no " << from;
        ASSERT_EQ(text.find(from, at + 1), std::string::npos) << file << " has more than one " << from;
        text.replace(at, from.size(), to);
    }

    /// The number of the first line of the file that has this text.
    int lineOf(const std::string& file, const std::string& part) const {
        const std::string& text = files.at(file);
        const auto at = text.find(part);
        EXPECT_NE(at, std::string::npos) << file << " has no " << part;
        return 1 + static_cast<int>(
                       std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    }

    void write() const {
        for (const auto& [file, text] : files) {
            std::ofstream(directory / file, std::ios::binary) << text;
        }
        std::ofstream(directory / "slides.json", std::ios::binary) << slides;
    }

    Report report() const {
        write();
        return check(readLessons(directory), readSlides(directory / "slides.json"));
    }

    std::filesystem::path directory;
    Files files = validFiles();
    std::string slides = kSlides;
};

}  // namespace nuovo::test
