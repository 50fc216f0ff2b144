// Writes the generated parts of slides_refs/README.md and puts them between their markers.
// SPDX-License-Identifier: MIT
#include "refs.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <utility>

namespace nuovo {
namespace {

namespace fs = std::filesystem;

std::string replaced(std::string text, std::string_view from, std::string_view to) {
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

// Inside a cell a bar would end it.
std::string cell(const std::string& text) { return replaced(text, "|", "\\|"); }
std::string code(const std::string& text) { return "`" + text + "`"; }

// For an attribute of an <img>.
std::string quoted(const std::string& text) {
    return '"' + replaced(replaced(text, "&", "&amp;"), "\"", "&quot;") + '"';
}

std::string joined(const std::vector<std::string>& parts, const char* separator) {
    std::string text;
    for (const std::string& part : parts)
        text += (text.empty() ? "" : separator) + part;
    return text;
}

// A link that opens the file at the line; `file` is from the root, the README stands one folder below it.
std::string link(const std::string& text, const std::string& file, int first, int last) {
    std::string target = "../" + file + "#L" + std::to_string(first);
    if (last > first)
        target += "-L" + std::to_string(last);
    return "[" + code(text) + "](" + target + ")";
}

std::string link(const CodeLine& line, const fs::path& root) {
    const int number = lineOf(root / line.file, line.code);
    return link(line.code, line.file, number, number);
}

// Consecutive lines with the same tag.
struct Run {
    int first = 0;
    int last = 0;
    Citation cites;
    std::vector<std::pair<int, std::string>> code;  // line number and text, comments left out
};

std::vector<Run> runsOf(const Lesson& lesson, int slide) {
    std::vector<Run> runs;
    for (const Line& line : lesson.lines) {
        if (line.kind != LineKind::New || line.cites.slide != slide)
            continue;
        if (runs.empty() || !(runs.back().cites == line.cites) || runs.back().last + 1 != line.number)
            runs.push_back({line.number, line.number, line.cites, {}});
        runs.back().last = line.number;
        const std::string text(trimmed(line.code));
        if (text.rfind("//", 0) != 0)
            runs.back().code.emplace_back(line.number, text);
    }
    return runs;
}

// Short runs line by line, a long one as a whole, named by its first line.
void addLinks(const Run& run, const std::string& file, std::vector<std::string>& links) {
    if (run.code.size() > 3) {
        links.push_back(link(run.code.front().second + " ...", file, run.first, run.last));
        return;
    }
    for (const auto& [number, text] : run.code)
        links.push_back(link(text, file, number, number));
}

struct Writer {
    const Companion& companion;
    const LessonSet& lessons;
    const fs::path& root;

    // Its lessons, each with its new lines for the slide; then the lines of other files that the slide names.
    std::string lessonLinks(const CompanionSlide& slide) const {
        std::vector<std::string> parts;
        for (const std::string& name : slide.lessons) {
            std::vector<std::string> links;
            for (const Lesson& lesson : lessons.chain)
                if (lesson.stem == name)
                    for (const Run& run : runsOf(lesson, slide.number))
                        addLinks(run, "lessons/" + name + ".cpp", links);
            parts.push_back("[" + name + "](../lessons/" + name + ".cpp)");
            parts.insert(parts.end(), links.begin(), links.end());
        }
        for (const CodeLine& line : slide.lines)
            if (line.file.rfind("shaders/", 0) != 0)
                parts.push_back(link(line, root));
        return joined(parts, "<br>");
    }

    std::string shaderLinks(const CompanionSlide& slide) const {
        std::vector<std::string> links;
        for (const CodeLine& line : slide.lines)
            if (line.file.rfind("shaders/", 0) == 0)
                links.push_back(link(line, root));
        for (const std::string& term : slide.terms) {
            const auto found = companion.termLines.find(term);
            if (found == companion.termLines.end())
                throw InputError(companion.file.string() + ": slide " + std::to_string(slide.number) +
                                 " names the term " + term + ", which term_lines does not have; add it");
            links.push_back(link(found->second, root));
        }
        return joined(links, "<br>");
    }

    std::string lines() const {
        std::ostringstream out;
        out << "| slide | | lessons | equation (shaders) | options, keys |\n|---|---|---|---|---|\n";
        for (const CompanionSlide& slide : companion.slides) {
            std::vector<std::string> views;
            for (const std::string& view : slide.views)
                views.push_back(code(view));
            out << "| [" << slide.number << "](#slide-" << slide.number << ") | " << slide.title.it << "<br>"
                << slide.title.en << " | " << cell(lessonLinks(slide)) << " | " << cell(shaderLinks(slide))
                << " | " << cell(joined(views, "<br>")) << " |\n";
        }
        return out.str();
    }

    // Pictures side by side, then the commands that draw them, one below the other in the same order.
    static void show(const CompanionSlide& slide, bool areAnswers, std::ostream& out) {
        std::string images;
        std::string commands;
        for (const Picture& picture : slide.pictures) {
            if (picture.isAnswer != areAnswers)
                continue;
            images += "<img src=\"pictures/" + picture.file + "\" alt=" + quoted(picture.alt.en) +
                      " title=" + quoted(picture.alt.it) + ">\n";
            commands += "    " + picture.command + "\n";
        }
        if (!images.empty())
            out << images << '\n' << commands << '\n';
    }

    static void section(const CompanionSlide& slide, std::ostream& out) {
        out << "<a id=\"slide-" << slide.number << "\"></a>\n\n### " << slide.number << ". " << slide.title.it
            << " · " << slide.title.en << "\n\n";
        if (!slide.equation.empty())
            out << "    " << slide.equation << "\n\n";
        out << "**it** " << slide.says.it << "\n\n**en** " << slide.says.en << "\n\n";
        show(slide, false, out);
        out << "> **Prima di guardare.** " << slide.question.it << "\n>\n> **Before you look.** "
            << slide.question.en << "\n\n<details><summary>Risposta · Answer</summary>\n\n"
            << "**it** " << slide.answer.it << "\n\n**en** " << slide.answer.en << "\n\n";
        show(slide, true, out);
        out << "</details>\n";
    }

    std::string slides() const {
        std::ostringstream out;
        for (const CompanionSlide& slide : companion.slides) {
            out << (&slide == &companion.slides.front() ? "" : "\n");
            section(slide, out);
        }
        return out.str();
    }

    void errataTable(std::string BothLanguages::*language, const std::string& head, bool misprints,
                     std::ostream& out) const {
        const auto columns = static_cast<std::size_t>(std::count(head.begin(), head.end(), '|')) - 1;
        out << head << "\n|";
        for (std::size_t i = 0; i < columns; ++i)
            out << "---|";
        out << '\n';
        for (const Erratum& erratum : companion.errata) {
            if ((erratum.kind == "misprint") != misprints)
                continue;
            std::vector<std::string> numbers;
            for (const int slide : erratum.slides)
                numbers.push_back(std::to_string(slide));
            out << "| " << joined(numbers, ", ") << " | ";
            if (!misprints) {  // "errore: alla lettera ..." in its column says "errore"
                const std::string& kind = companion.kinds.at(erratum.kind).*language;
                out << kind.substr(0, kind.find(':')) << " | ";
            }
            out << cell(erratum.says.*language) << " | " << cell(erratum.shouldSay.*language) << " | "
                << cell(erratum.reason.*language) << " |\n";
        }
    }

    std::string errata() const {
        std::ostringstream out;
        errataTable(&BothLanguages::en, "| slide | kind | it says | it should say | why |", false, out);
        out << "\nPlain misprints, collected so that nobody wonders (we read a text extract; a few may be "
               "the "
               "extract's own):\n\n";
        errataTable(&BothLanguages::en, "| slide | it says | it should say | why |", true, out);
        out << "\n<details><summary>In italiano</summary>\n\n";
        errataTable(&BothLanguages::it, "| slide | specie | dice | dovrebbe dire | perché |", false, out);
        out << "\nRefusi, raccolti perché nessuno si chieda se ha capito male (leggiamo un estratto "
               "testuale: "
               "qualcuno può essere suo):\n\n";
        errataTable(&BothLanguages::it, "| slide | dice | dovrebbe dire | perché |", true, out);
        out << "\n</details>\n";
        return out.str();
    }
};

// Where the line `marker` begins; it must stand exactly once.
std::size_t placeOf(const fs::path& file, std::string_view readme, const std::string& marker) {
    const auto first = readme.find(marker);
    if (first == std::string_view::npos || readme.find(marker, first + 1) != std::string_view::npos)
        throw InputError(file.string() + ": expected the line \"" + marker + "\" once, found it " +
                         (first == std::string_view::npos ? "nowhere" : "several times") +
                         "; the generated text stands between the two lines of its name");
    return first;
}

}  // namespace

int lineOf(const fs::path& file, std::string_view code) {
    std::ifstream stream(file);
    if (!stream)
        throw InputError(file.string() + ": cannot be read, yet slides.json names a line of it (" +
                         std::string(code) + "); correct slides.json");
    std::vector<int> found;
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number)
        if (line.find(code) != std::string::npos)
            found.push_back(number);
    if (found.size() != 1)
        throw InputError(file.string() + ": expected one line with \"" + std::string(code) + "\", found " +
                         std::to_string(found.size()) + "; correct it in slides.json");
    return found.front();
}

std::map<std::string, std::string> refsBlocks(const Companion& companion, const LessonSet& lessons,
                                              const fs::path& root) {
    const Writer writer{companion, lessons, root};
    return {{"lines", writer.lines()}, {"slides", writer.slides()}, {"errata", writer.errata()}};
}

std::string renewed(const fs::path& file, std::string_view readme,
                    const std::map<std::string, std::string>& blocks) {
    std::string text(readme);
    for (const auto& [name, block] : blocks) {
        const std::string begin = "<!-- nuovo refs: " + name + " -->\n";
        const std::string end = "<!-- end of " + name + " -->\n";
        const std::size_t from = placeOf(file, text, begin) + begin.size();
        const std::size_t to = placeOf(file, text, end);
        if (to < from)
            throw InputError(file.string() + ": the end of " + name +
                             " stands before its beginning; swap them");
        text.replace(from, to - from, "\n" + block + "\n");
    }
    return text;
}

namespace {

std::string readWhole(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    if (!stream || !(text << stream.rdbuf()))
        throw InputError(file.string() + ": cannot be read; say where it is with --readme FILE");
    return text.str();
}

// Under a temporary name first, so that nothing half-written is left behind.
void writeWhole(const fs::path& file, const std::string& text) {
    const fs::path temporary = file.string() + ".new";
    std::ofstream stream(temporary, std::ios::binary);
    stream << text;
    stream.close();
    std::error_code error;
    if (stream)
        fs::rename(temporary, file, error);
    if (!stream || error) {
        fs::remove(temporary, error);
        throw std::runtime_error(file.string() + ": cannot be written; check its folder's permissions");
    }
}

int firstDifference(const std::string& a, const std::string& b) {
    const auto [place, other] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    return 1 + static_cast<int>(std::count(a.begin(), place, '\n'));
}

}  // namespace

int renewReadme(const Companion& companion, const LessonSet& lessons, const fs::path& readme, bool isCheck) {
    const std::string old = readWhole(readme);
    const fs::path root = fs::canonical(readme).parent_path().parent_path();  // a link in the build tree
    const std::string fresh = renewed(readme, old, refsBlocks(companion, lessons, root));
    if (fresh == old)
        return 0;
    if (!isCheck)
        writeWhole(readme, fresh);
    return firstDifference(old, fresh);
}

void printPictures(const Companion& companion, const LessonSet& lessons, std::ostream& out) {
    for (const Picture& picture : picturesToDraw(companion, lessons))
        out << picture.file << '\t' << picture.command << " --size " << picture.size << '\n';
    for (const std::string& file : companion.picturesElsewhere)
        out << file << "\t\n";
}

}  // namespace nuovo
