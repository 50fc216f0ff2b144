// From the files of a submission to the parts that are judged.
// SPDX-License-Identifier: MIT
#include "grader/submission/submission.hpp"

#include "grader/submission/files.hpp"
#include "grader/submission/hash.hpp"

#include <algorithm>
#include <cctype>

namespace grader {

namespace {

namespace fs = std::filesystem;

bool isWord(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

std::string extensionOf(const std::string& name) { return fs::path(name).extension().string(); }
bool isProgram(const std::string& name) {
    const std::string e = extensionOf(name);
    return e == ".cpp" || e == ".cc" || e == ".cxx";
}
bool isHeader(const std::string& name) {
    const std::string e = extensionOf(name);
    return e == ".hpp" || e == ".h";
}

// The lab's shader that a file stands for, by the end of its path or, failing that, by its name alone; empty: none.
std::string shaderOf(const std::string& name, const std::vector<std::string>& shaders) {
    const std::string path = "/" + name;
    for (const std::string& shader : shaders)
        if (path.ends_with("/" + shader))
            return shader;
    for (const std::string& shader : shaders)
        if (fs::path(shader).filename() == fs::path(name).filename())
            return shader;
    return "";
}

// Puts files into a Submission and says in its list what became of each.
class Sorter {
  public:
    Sorter(Submission& submission, const Expectations& expected, Language language)
        : submission_(submission), expected_(expected), italian_(language == Language::it) {}

    void sort(const std::vector<NamedText>& files) {
        const NamedText* program = chosenProgram(files);
        for (const NamedText& file : files) {
            if (&file == program)
                use(file, "lesson"), submission_.lesson = file;
            else if (isProgram(file.name))
                leave(file, italian_ ? "un altro .cpp è il programma della lezione"
                                     : "another .cpp is the lesson's program");
            else if (isHeader(file.name))
                use(file, "header"), submission_.headers.push_back(file);
            else
                sortShader(file);
        }
        leaveNeutralShaders();
    }

  private:
    const NamedText* chosenProgram(const std::vector<NamedText>& files) {
        const NamedText *named = nullptr, *lab = nullptr, *any = nullptr;
        int labs = 0;
        for (const NamedText& file : files) {
            if (!isProgram(file.name))
                continue;
            any = &file;
            if (fs::path(file.name).stem() == expected_.lesson && named == nullptr)
                named = &file;
            if (file.text.find("lab/lab.hpp") != std::string::npos)
                lab = &file, ++labs;
        }
        if (named == nullptr && labs > 1)
            submission_.problem = italian_
                                      ? "ci sono più file .cpp di lezioni; me ne serve uno, o uno di nome " +
                                            expected_.lesson + ".cpp"
                                      : "there are several lesson .cpp files; expected one, or one called " +
                                            expected_.lesson + ".cpp";
        return named != nullptr ? named : lab != nullptr ? lab : any;
    }

    void sortShader(const NamedText& file) {
        const std::string shader = shaderOf(file.name, expected_.shaders);
        if (shader.empty())
            leave(file, italian_ ? "nessuno shader del laboratorio si chiama così"
                                 : "no shader of the lab has this name");
        else if (!submission_.shaders.emplace(shader, file.text).second)
            leave(file, italian_ ? "c'è già un altro file per questo termine"
                                 : "another file of this term is there already");
        else
            use(file, "term");
    }

    // A starter brings its terms along, as neutral elements: where none was written, they are not what is handed in.
    void leaveNeutralShaders() {
        for (const auto& [name, text] : submission_.shaders)
            if (isNeutral(name, text))
                submission_.untouched.insert(fs::path(name).stem());
        if (!submission_.lesson || submission_.shaders.empty() || expected_.keepNeutral ||
            submission_.untouched.size() < submission_.shaders.size())
            return;
        for (SubmittedFile& file : submission_.files)
            if (file.role == "term") {
                file.role = "leftOut";
                file.note = italian_ ? "è ancora quello di partenza: si usa quello del laboratorio"
                                     : "still the starter's: the lab's own is used";
            }
        submission_.shaders.clear();
    }
    bool isNeutral(const std::string& name, const std::string& text) const {
        return std::any_of(expected_.starters.begin(), expected_.starters.end(), [&](const auto& starter) {
            const auto found = starter.find(name);
            return found != starter.end() && withoutComments(found->second) == withoutComments(text);
        });
    }

    void use(const NamedText& file, const char* role) { list(file, role, ""); }
    void leave(const NamedText& file, const std::string& note) { list(file, "leftOut", note); }
    void list(const NamedText& file, const char* role, const std::string& note) {
        submission_.files.push_back(
            {file.name, role, note, static_cast<long long>(file.text.size()), sha256(file.text)});
    }

    Submission& submission_;
    const Expectations& expected_;
    bool italian_;
};

// Archives inside a folder or an archive that has nothing else to judge.
Files unpacked(Files files, Language language) {
    for (int depth = 0; depth < 3; ++depth) {
        std::vector<NamedText> archives, others;
        for (NamedText& file : files.taken)
            (isArchive(file.name) ? archives : others).push_back(std::move(file));
        files.taken = std::move(others);
        if (archives.size() == 1 && files.taken.empty()) {
            Files inside = filesInArchive(archives.front().text, language);
            inside.leftOut.insert(inside.leftOut.end(), files.leftOut.begin(), files.leftOut.end());
            files = std::move(inside);
            continue;
        }
        for (const NamedText& archive : archives)
            files.leftOut.push_back(
                {archive.name, "leftOut", "", static_cast<long long>(archive.text.size()), ""});
        return files;
    }
    return files;
}

// Jumps over a comment that begins at `i`; whether there was one.
bool skipComment(const std::string& source, std::size_t& i) {
    if (source.compare(i, 2, "//") == 0)
        i = std::min(source.find('\n', i), source.size());
    else if (source.compare(i, 2, "/*") == 0)
        i = std::min(source.find("*/", i + 2), source.size() - 2) + 2;
    else
        return false;
    return true;
}

// Copies a "..." or '...' that begins at `i`.
void copyQuoted(const std::string& source, std::size_t& i, std::string& result) {
    const char quote = source[i];
    do {
        if (source[i] == '\\' && i + 1 < source.size())
            result += source[i++];
        result += source[i++];
    } while (i < source.size() && source[i] != quote && source[i] != '\n');
    if (i < source.size() && source[i] == quote)
        result += source[i++];
}

}  // namespace

std::string withoutComments(const std::string& source) {
    std::string result;
    bool blank = false, newLine = true,
         directive = false;  // blanks and line ends that are to come; whether a # line is open
    for (std::size_t i = 0; i < source.size();) {
        const char c = source[i];
        if (skipComment(source, i)) {
            blank = true;
        } else if (std::isspace(static_cast<unsigned char>(c)) != 0) {
            blank = true;
            newLine = newLine || c == '\n';
            ++i;
        } else {
            if (newLine && (directive || c == '#') && !result.empty())
                result += '\n';  // a directive ends with its line
            else if (blank && !result.empty() && isWord(result.back()) && isWord(c))
                result += ' ';
            directive = newLine ? c == '#' : directive;
            blank = newLine = false;
            if (c == '"' || c == '\'')
                copyQuoted(source, i, result);
            else
                result += source[i++];
        }
    }
    return result;
}

Submission readSubmission(const fs::path& path, const Expectations& expected, Language language) {
    Submission submission;
    const fs::path clean = (path / "").parent_path();  // without a slash at the end
    submission.name = clean.filename() == "." || clean.filename() == ".." || clean.filename().empty()
                          ? fs::weakly_canonical(clean).filename().string()
                          : clean.filename().string();
    const Files files = unpacked(filesAt(clean, language), language);
    submission.problem = files.problem;
    Sorter(submission, expected, language).sort(files.taken);
    submission.files.insert(submission.files.end(), files.leftOut.begin(), files.leftOut.end());
    std::string all;
    for (const NamedText& file : files.taken)
        all += std::to_string(file.name.size()) + ":" + file.name + std::to_string(file.text.size()) + ":" +
               file.text;
    submission.hash = sha256(all);
    if (submission.problem.empty() && !submission.lesson && submission.shaders.empty())
        submission.problem = language == Language::it
                                 ? "non c'è nessun file da valutare: mi aspetto " + expected.lesson +
                                       ".cpp, o termini di shader (terms/*.glsl)"
                                 : "there is no file to judge: expected " + expected.lesson +
                                       ".cpp, or shader terms (terms/*.glsl)";
    return submission;
}

}  // namespace grader
