// Starters as texts and as folders: the previous lesson plus TODOs that say everything, and never half of one.
// SPDX-License-Identifier: MIT
#include "starter.hpp"

#include "starter_text.hpp"
#include "support/program.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <sstream>

namespace nuovo {
namespace {

namespace fs = std::filesystem;

const fs::path root = LAMBERT_SOURCE_DIR;
const fs::path tasksFile = root / "slides_refs/tasks.json";

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

bool startsWith(std::string_view text, std::string_view start) {
    return text.substr(0, start.size()) == start;
}

// A starter's lines without header, blank lines, TODOs and its own name.
std::vector<std::string> withoutTodos(const std::string& text, const std::string& stem) {
    std::vector<std::string> result;
    bool inHeader = true;
    bool inTodo = false;
    for (const std::string& line : linesOf(text)) {
        const std::string_view code = trimmed(line);
        inHeader = inHeader && startsWith(code, "//");
        inTodo = startsWith(code, "// TODO ") || (inTodo && startsWith(code, "//     "));
        if (!inHeader && !inTodo && !code.empty())
            result.push_back(withoutOwnName(line, stem));
    }
    return result;
}

// The numbers in code: 0xFF8855, -2, 1.5; none of those within names, texts and comments.
std::set<std::string> numbersOf(std::string_view code) {
    std::set<std::string> numbers;
    code = code.substr(0, std::min(commentStart(code), code.size()));
    for (std::size_t i = 0; i < code.size();) {
        const auto partOf = [](char c) {
            return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.';
        };
        std::size_t end = i;
        while (end < code.size() && (partOf(code[end]) || code[end] == '_'))
            ++end;
        if (end > i && std::isdigit(static_cast<unsigned char>(code[i])) != 0)
            numbers.insert(std::string(code.substr(i, end - i)));
        i = std::max(end, i + 1);
    }
    return numbers;
}

TEST(Starter, IsThePreviousLessonPlusTodos) {
    const auto chain = readLessons(root / "lessons").chain;
    ASSERT_GE(chain.size(), 10U);
    for (std::size_t i = 1; i < chain.size(); ++i)
        for (const char* lang : {"it", "en"}) {
            const LessonTasks tasks = readTasks(tasksFile, chain[i]);
            const std::string text = starterLesson(chain[i], tasks, lang);
            std::vector<std::string> expected;
            for (const PlainLine& line : plain(chain[i - 1]))
                expected.push_back(withoutOwnName(line.text, chain[i - 1].stem));
            EXPECT_EQ(withoutTodos(text, chain[i].stem), expected) << chain[i].stem;
            std::size_t todos = 0;
            for (const std::string& line : linesOf(text))
                todos += startsWith(trimmed(line), "// TODO ") ? 1U : 0U;
            EXPECT_EQ(todos, tasks.runs.size()) << chain[i].stem;
            EXPECT_GE(todos, 1U) << chain[i].stem;
            for (const char* mark : {"NUOVO", "PRIMA"})
                EXPECT_EQ(text.find(mark), std::string::npos) << chain[i].stem << " keeps a mark";
        }
}

TEST(Starter, SaysEveryNumberThatTheLessonNeeds) {
    const auto chain = readLessons(root / "lessons").chain;
    std::size_t numbers = 0;
    for (std::size_t i = 1; i < chain.size(); ++i) {
        const LessonTasks tasks = readTasks(tasksFile, chain[i]);
        const std::vector<NewRun> runs = runsOf(chain[i]);
        for (std::size_t run = 0; run < runs.size(); ++run)
            for (std::size_t line = runs[run].begin; line < runs[run].end; ++line)
                for (const std::string& number : numbersOf(chain[i].lines[line].code)) {
                    ++numbers;
                    for (const auto& [lang, text] : tasks.runs[run])
                        EXPECT_NE(text.find(number), std::string::npos)
                            << chain[i].lines[line].raw << "\n  needs " << number
                            << ", which tasks.json does not say: " << text;
                }
    }
    EXPECT_GT(numbers, 30U) << "hardly a number was found: are they still recognised?";
}

TEST(Starter, TasksHaveNoLessonAndNoTagTooMany) {
    const auto json = nlohmann::json::parse(support::readFile(tasksFile));
    std::set<std::string> known;
    for (const Lesson& lesson : readLessons(root / "lessons").chain) {
        if (lesson.number == 0)
            continue;
        known.insert(lesson.stem);
        std::set<std::string> tags;
        for (const NewRun& run : runsOf(lesson))
            tags.insert(toString(run.cites));
        for (const auto& [tag, texts] : json.at("lessons").at(lesson.stem).at("tasks").items())
            EXPECT_TRUE(tags.contains(tag)) << lesson.stem << " has no line of " << tag;
    }
    for (const auto& [stem, tasks] : json.at("lessons").items())
        EXPECT_TRUE(known.contains(stem)) << "there is no " << stem;
    std::set<std::string> used;
    for (const auto& lesson : json.at("lessons"))
        for (const auto& term : lesson.at("terms"))
            EXPECT_TRUE(used.insert(term).second) << term << " is an exercise of two lessons";
    for (const auto& [term, text] : json.at("terms").items())
        EXPECT_TRUE(used.contains(term)) << term << " is nobody's exercise";
}

TEST(Starter, TasksThatAreMissingAreNamed) {
    const Lesson lesson =
        parseLesson("lesson_01_x.cpp", "// lesson_01_x: x\n\n// Do it.  // NUOVO 36.1\na(1);  // NUOVO 36.1\n"
                                       "b(2);  // NUOVO 36.2\n");
    const support::TemporaryDirectory directory;
    const fs::path file = directory.path() / "tasks.json";
    const auto with = [](const std::string& tasks, const std::string& terms = "[]") {
        return R"({"lessons": {"lesson_01_x": {"tasks": {)" + tasks + R"(}, "terms": )" + terms +
               R"(}}, "terms": {}})";
    };
    const std::string one = R"("36.1": [{"it": "fallo", "en": "do it"}])";
    const std::string two = R"("36.2": [{"it": "e poi", "en": "and then"}])";
    support::writeFile(file, with(one + "," + two));
    EXPECT_EQ(readTasks(file, lesson).runs.size(), 2U);
    const std::pair<std::string, const char*> cases[] = {
        {"", "expected JSON"},
        {"[]", "\"lessons\""},
        {R"({"lessons": {}})", "\"lesson_01_x\""},
        {with(one), "\"36.2\""},
        {with(two), "\"36.1\""},
        {with(R"("36.1": [],)" + two), "lesson_01_x.tasks.36.1: expected an array of 1"},
        {with(R"("36.1": {"it": "fallo", "en": "do it"},)" + two), "36.1: expected an array of 1"},
        {with(R"("36.1": [{"it": "fallo"}],)" + two), "36.1[0]: expected a member \"en\""},
        {with(R"("36.1": [{"it": " ", "en": "do it"}],)" + two), "36.1[0].it: expected a text"},
        {with(R"("36.1": [{"it": 7, "en": "do it"}],)" + two), "36.1[0].it: expected a text"},
        {with(one + "," + two, R"(["gloss"])"), "\"gloss\""},
        {with(one + "," + two, "[7]"), "terms: expected names"},
    };
    for (const auto& [text, message] : cases) {
        support::writeFile(file, text);
        try {
            readTasks(file, lesson);
            ADD_FAILURE() << text << " was accepted";
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
        }
    }
}

TEST(Starter, ARunEndsWhereItsTaskEnds) {
    const Lesson lesson = parseLesson(
        "lesson_01_x.cpp", "// lesson_01_x: x\n\n"
                           "a();  // NUOVO 1\n// PRIMA b();\nc();  // NUOVO 1\n\nd();  // NUOVO 1\n"
                           "// More.  // NUOVO 1\n// Still.  // NUOVO 1\ne();  // NUOVO 1\n"
                           "f();  // NUOVO 2\ng();\nh();  // NUOVO 2\n");
    std::vector<std::string> found;
    for (const NewRun& run : runsOf(lesson))
        found.push_back(toString(run.cites) + ": " + std::to_string(run.begin + 1) + "-" +
                        std::to_string(run.end));
    EXPECT_EQ(found, (std::vector<std::string>{"1: 3-3", "1: 5-7", "1: 8-10", "2: 11-11", "2: 13-13"}));
}

TEST(Starter, CommentsAreWrapped) {
    const std::string text = commented("    ", "TODO 1:",
                                       std::string(40, 'a') + " " + std::string(45, 'b') + " " +
                                           std::string(10, 'c') + "\nd e\xC2\xA0" + "f");
    EXPECT_EQ(linesOf(text),
              (std::vector<std::string>{"    // TODO 1: " + std::string(40, 'a'),
                                        "    //     " + std::string(45, 'b') + " " + std::string(10, 'c'),
                                        "    //     d e f"}));
    for (const Lesson& lesson : readLessons(root / "lessons").chain) {
        if (lesson.number == 0)
            continue;
        for (const std::string& line : linesOf(starterLesson(lesson, readTasks(tasksFile, lesson), "en")))
            EXPECT_LE(line.size(), 110U) << line;
    }
}

TEST(Starter, ATermBecomesItsNeutralElement) {
    EXPECT_EQ(
        starterTerm(
            "a\n  #if TERM_X\n    b\n  #if Y\n    c\n  #else\n    d\n  #endif\n  #else\n    e\n  #endif\nf\n",
            "x", "do", "x.glsl"),
        "a\n  #if TERM_X\n    // TODO: do\n    e\n#else\n    e\n#endif\nf\n");
    EXPECT_EQ(starterTerm("#if TERM_X\nhelp\n#endif\na\n#if TERM_X\nb\n#endif\nc\n", "x", "do", "x.glsl"),
              "a\n#if TERM_X\n// TODO: do\n#endif\nc\n");
    const std::pair<const char*, const char*> bad[] = {
        {"a\n", "#if TERM_X"},
        {"#if TERM_XY\n#endif\n", "#if TERM_X"},
        {"a\n#if TERM_X\nb\n", "x.glsl:2"},
        {"#if TERM_X\na\n#elif Y\nb\n#endif\n", "x.glsl:1"},
    };
    for (const auto& [glsl, message] : bad) {
        try {
            starterTerm(glsl, "x", "do", "x.glsl");
            ADD_FAILURE() << glsl << " was accepted";
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
        }
    }
    // The rule fits every term of the lab, whether it is an exercise yet or not.
    for (const auto& entry : fs::directory_iterator(root / "shaders/terms"))
        EXPECT_NE(
            starterTerm(support::readFile(entry.path()), entry.path().stem().string(), "do", "").find("TODO"),
            std::string::npos);
}

// --- the program

struct StarterProgram : testing::Test {
    support::TemporaryDirectory directory;
    support::Outcome nuovo(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"nuovo", "starter"});
        return support::run(arguments, directory.path());
    }
};

TEST_F(StarterProgram, WritesAFolder) {
    ASSERT_EQ(nuovo({"2", "--lang", "it", "-o", "due"}).status, 0);
    ASSERT_EQ(nuovo({"directional", "--lang", "en", "-o", "two/"}).status, 0);
    EXPECT_EQ(directory.contents(), (std::vector<std::string>{"due", "two"}));
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(directory.path() / "two"))
        if (entry.is_regular_file())
            names.insert(fs::relative(entry.path(), directory.path() / "two").string());
    EXPECT_EQ(names, (std::set<std::string>{"CMakeLists.txt", "README.md", "lesson_02_directional_light.cpp",
                                            "terms/albedo.glsl", "terms/clamp.glsl", "terms/cosine.glsl"}));
    EXPECT_EQ(fs::status(directory.path() / "two").permissions() & fs::perms::others_read,
              fs::status(directory.path() / "two/terms").permissions() & fs::perms::others_read)
        << "the folder is as open as what is in it";
    for (const std::string& name : names) {
        const std::string it = support::readFile(directory.path() / "due" / name);
        const std::string en = support::readFile(directory.path() / "two" / name);
        EXPECT_NE(it, en) << name;
        for (const std::string& text : {it, en}) {
            EXPECT_EQ(text.find('@'), std::string::npos) << name << ": a mark was not filled in";
            EXPECT_EQ(text.find("\xC2\xA0"), std::string::npos) << name << ": a no-break blank";
            EXPECT_EQ(text.find(LAMBERT_SOURCE_DIR), std::string::npos) << name << ": a path of this machine";
            EXPECT_EQ(text.find(LAMBERT_BIN_DIR), std::string::npos) << name << ": a path of this machine";
        }
    }
    fs::create_directory(directory.path() / "empty");
    EXPECT_EQ(nuovo({"lesson_07_normal_space", "-o", "empty"}).status, 0);
    EXPECT_FALSE(fs::exists(directory.path() / "empty/terms")) << "it has no shader exercise";
    EXPECT_EQ(support::readFile(directory.path() / "empty/README.md").find("--shaders"), std::string::npos);
}

TEST_F(StarterProgram, RefusesWhatHasNoStarter) {
    const std::pair<const char*, const char*> cases[] = {
        {"0", "no lesson before it"},
        {"lesson_00_scene", "no lesson before it"},
        {"interlude_brdf", "no step of"},
        {"viewer", "no step of"},
        {"nowhere", "lesson_09_phong"},
        {"99", "lesson_01_material"},
        {"light", "lesson_06_many_lights\n"},
        {"", "not the name of one lesson"},
        {"-1", ""},
    };
    for (const auto& [lesson, message] : cases) {
        const support::Outcome outcome = nuovo({lesson, "-o", "x"});
        EXPECT_EQ(outcome.status, 2) << lesson;
        EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
    }
    EXPECT_EQ(nuovo({"2"}).status, 2);
    EXPECT_EQ(nuovo({"2", "-o", "x", "--lang", "fr"}).status, 2);
    EXPECT_EQ(directory.contents(), std::vector<std::string>{});
}

TEST_F(StarterProgram, LeavesNothingBehindWhereItCannotWrite) {
    fs::create_directories(directory.path() / "full");
    support::writeFile(directory.path() / "full/mine.txt", "mine");
    support::writeFile(directory.path() / "file", "mine");
    fs::create_directory(directory.path() / "empty");
    fs::create_directory_symlink("empty", directory.path() / "link");
    const std::vector<std::string> before = directory.contents();
    const std::pair<const char*, const char*> cases[] = {
        {"full", "not empty"}, {"file", "is a file"}, {"nowhere/x", "no folder can be made there"},
        {".", "not empty"},    {"/", "not empty"},    {"link", "cannot take this name"},
    };
    for (const auto& [name, message] : cases) {
        const support::Outcome outcome = nuovo({"2", "-o", name});
        EXPECT_EQ(outcome.status, 5) << name << ": " << outcome.err;
        EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
        EXPECT_EQ(directory.contents(), before) << name;
    }
    EXPECT_EQ(support::readFile(directory.path() / "full/mine.txt"), "mine");
    EXPECT_EQ(nuovo({"2", "-o", "x", "--tasks", "none.json"}).status, 4);
    EXPECT_EQ(nuovo({"2", "-o", "x", "--shaders", "full"}).status, 4);
    EXPECT_EQ(directory.contents(), before);
}

}  // namespace
}  // namespace nuovo
