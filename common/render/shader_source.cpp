// Includes, #defines, and error messages that name the real file and line.
// SPDX-License-Identifier: MIT
#include "render/shader_source.hpp"

#include "image/home.hpp"
#include "render/error.hpp"
#include "render/shader_loops.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>

namespace render {

namespace fs = std::filesystem;

namespace {

fs::path ownDirectory() { return image::home() / "share/lambert-lab/shaders"; }

bool isFile(const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

// The name to show for `file`: as it is where `directory` has it, else the full path of the lab's own.
std::string choose(const std::string& directory, const std::string& file) {
    const fs::path own = ownDirectory() / file;
    return isFile(fs::path(directory) / file) || !isFile(own) ? file : own.string();
}

std::vector<std::string> readLines(const fs::path& path, const std::string& askedBy) {
    std::ifstream in(path);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    if (lines.empty())
        throw ShaderError(askedBy + "cannot read shader file " + path.string() +
                          "; expected a text file there. Check --shaders, or restore the file.");
    return lines;
}

// The x of a line `#include "x"`, else empty.
std::string includedFile(const std::string& line) {
    std::istringstream words(line);
    std::string hash, name;
    if (!(words >> hash) || hash.empty() || hash[0] != '#')
        return {};
    if (hash == "#") {  // "# include" is allowed too
        words >> name;
        hash += name;
    }
    words >> name;
    const bool quoted = name.size() > 2 && name.front() == '"' && name.back() == '"';
    return hash == "#include" && quoted ? name.substr(1, name.size() - 2) : std::string();
}

class Reader {
  public:
    Reader(const std::string& directory, const std::string& preamble)
        : directory_(directory), loops_(preamble) {
        own(preamble);
    }

    ShaderSource source;

    void own(const std::string& text) {
        std::istringstream in(text);
        for (std::string line; std::getline(in, line);)
            add(line, {"", 0});
    }

    void include(const std::string& file, const std::string& askedBy) {
        if (!included_.insert(file).second)
            return;  // as with #pragma once; a file that includes itself ends here too
        const std::string name = choose(directory_, file);
        const std::vector<std::string> lines = readLines(fs::path(directory_) / name, askedBy);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            if (const std::string wanted = includedFile(lines[i]); !wanted.empty())
                include(wanted, name + ":" + std::to_string(i + 1) + ": ");
            else if (const std::optional<Loop> loop = loops_.read(lines, i))
                i = write(*loop, lines, name);
            else
                add(lines[i], {name, i + 1});
        }
    }

  private:
    // Writes a loop out, and returns its last line.
    std::size_t write(const Loop& loop, const std::vector<std::string>& lines, const std::string& name) {
        for (const LoopLine& line : loops_.writeOut(loop, lines))
            add(line.text, {name, line.from + 1});
        return loop.last;
    }

    void add(const std::string& line, ShaderLine place) {
        source.text += line + "\n";
        source.lines.push_back(std::move(place));
    }

    const std::string& directory_;
    const LoopWriter loops_;
    std::set<std::string> included_;
};

}  // namespace

std::string findShaderDirectory(const std::string& asked) {
    const fs::path own = ownDirectory();
    if (!isFile(own / "mesh.vert"))
        throw ShaderError(
            "the lab's shaders are gone; expected mesh.vert and others in " + own.string() +
            ". Install or build the lab there again; where it has moved, build this program again.");
    if (asked.empty())
        return own.string();
    std::error_code ignored;
    if (!fs::is_directory(asked, ignored))
        throw ShaderError("--shaders: there is no folder " + asked +
                          "; expected one with shader files such as mesh.frag or terms/cosine.glsl.");
    for (const auto& entry : fs::recursive_directory_iterator(own))
        if (isFile(asked / fs::relative(entry.path(), own)))
            return asked;
    throw ShaderError("--shaders: " + asked +
                      " has none of the lab's shader files; expected one or more of those below " +
                      own.string() + ", such as mesh.frag or terms/cosine.glsl, under the same name.");
}

ShaderSource readShader(const std::string& directory, const std::string& file, const std::string& preamble) {
    Reader reader(directory, preamble);
    reader.include(file, "");
    return std::move(reader.source);
}

namespace {

// A GLSL vector of exactly these floats.
template <int size>
std::string vector(const glm::vec<size, float>& v) {
    std::string out = "vec" + std::to_string(size) + "(";
    for (int i = 0; i < size; ++i) {
        char number[32];
        std::snprintf(number, sizeof number, "%s%.9e", i > 0 ? ", " : "", static_cast<double>(v[i]));
        out += number;
    }
    return out + ")";
}

// A GLSL array of the numbers of all lights, exactly; those that move are not compiled in.
std::string constantArray(const char* name, const std::vector<glm::vec4>& values,
                          const std::vector<bool>& moves) {
    std::string out = std::string("const vec4 ") + name + "[" + std::to_string(values.size()) + "] = vec4[" +
                      std::to_string(values.size()) + "](\n";
    for (std::size_t i = 0; i < values.size(); ++i) {
        out += "    " + vector(moves[i] ? glm::vec4(0) : values[i]) + (i + 1 < values.size() ? ",\n" : "\n");
    }
    return out + ");\n";
}

std::string lightConstants(const LightNumbers& lights) {
    std::string places;
    int moving = 0;
    for (const bool moves : lights.moves) {
        places += places.empty() ? "" : ", ";
        places += std::to_string(moves ? moving++ : -1);
    }
    const std::string count = std::to_string(lights.count());
    return "const int UNIFORM_LIGHT[" + count + "] = int[" + count + "](" + places + ");\n" +
           constantArray("LIGHT_GEOMETRY", lights.geometry, lights.moves) +
           constantArray("LIGHT_RADIANCE", lights.radiance, lights.moves) +
           constantArray("LIGHT_FALLOFF", lights.falloff, lights.moves);
}

}  // namespace

namespace {

std::string upperCase(std::string name) {
    for (char& c : name)
        c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    return name;
}

}  // namespace

std::string preamble(const lighting::Variant& v, const LightNumbers& lights, bool fragment) {
    using lighting::LightStorage;
    std::ostringstream out;
    out << "#version 300 es\nprecision highp float;\nprecision highp int;\n";
    out << "#define " << (fragment ? "FRAGMENT" : "VERTEX") << "_SHADER\n";
    const auto define = [&out](const char* name, int value) {
        out << "#define " << name << ' ' << value << '\n';
    };
    define("DOUBLE_SIDED", v.doubleSided);
    define("COUNT_NONFINITE", v.countNonfinite);
    using lighting::ViewMode;
    define("SHOW_CHANNEL", v.view == ViewMode::red     ? 1
                           : v.view == ViewMode::green ? 2
                           : v.view == ViewMode::blue  ? 3
                                                       : 0);
    define("MARK_OVEREXPOSED", v.view == ViewMode::overexposed);
    if (!v.lit)
        return out.str();
    for (const lighting::TermInfo& row : lighting::terms())
        define(row.define, v.has(row.term));
    for (const lighting::ViewInfo& row : lighting::views())
        if (lighting::isData(v.view) && lighting::isData(row.view))
            define(("VIEW_" + upperCase(row.name)).c_str(), static_cast<int>(row.view));
    if (lighting::isData(v.view))
        define("VIEW", static_cast<int>(v.view));
    define("EMISSIVE", v.emissive);
    define("WINDOW", v.window);
    define("SCALED", v.scaled);
    out << "#define BLINN " << (v.blinn ? "true" : "false") << '\n';
    define("NUM_DIRECTIONAL_LIGHTS", v.directional);
    define("NUM_POINT_LIGHTS", v.point());
    define("END_DECAY_0", v.decay0);
    define("END_DECAY_1", v.decay0 + v.decay1);
    define("END_DECAY_2", v.decay0 + v.decay1 + v.decay2);
    define("CLUSTERED", v.clustered != 0);
    const char* const clustered[] = {"CLUSTERED_DECAY_0", "CLUSTERED_DECAY_1", "CLUSTERED_DECAY_2",
                                     "CLUSTERED_DECAY_OTHER"};
    for (unsigned group = 0; group < 4; ++group)
        out << "#define " << clustered[group] << ((v.clustered >> group & 1U) != 0 ? " true\n" : " false\n");
    define("LONG_LOOPS", v.longLoops);
    define("LIGHTS_IN_TEXTURE", v.storage == LightStorage::texture);
    const bool constants = v.storage == LightStorage::constants && lights.count() > 0;
    define("LIGHTS_ARE_CONSTANTS", constants);
    const auto inUniforms =
        constants ? std::count(lights.moves.begin(), lights.moves.end(), true) : v.directional + v.point();
    define("AMBIENT_IS_CONSTANT", constants && v.ambient && !lights.ambientMoves);
    define("SOME_LIGHTS_MOVE", constants && inUniforms > 0);
    define("NUM_UNIFORM_LIGHTS", static_cast<int>(std::max<std::ptrdiff_t>(inUniforms, 1)));
    if (constants)
        out << lightConstants(lights);
    if (constants && v.ambient && !lights.ambientMoves)
        out << "#define AMBIENT_LIGHT " << vector(lights.ambient) << '\n';
    return out.str();
}

namespace {

struct LogLine {
    std::size_t line;  // of the text that was compiled, from 1
    std::string rest;  // what the driver says of it
};

// One line of a driver's log: Mesa "0:7(3): error", NVIDIA "0(7) : error", ANGLE "ERROR: 0:7: ".
std::optional<LogLine> readLogLine(std::string text) {
    for (const std::string_view prefix : {"ERROR: ", "WARNING: "})
        if (text.starts_with(prefix))
            text.erase(0, prefix.size());
    std::istringstream in(text);
    std::size_t string = 0, line = 0, column = 0;
    char mark = 0;
    if (!(in >> string >> mark) || (mark != ':' && mark != '(') || !(in >> line))
        return std::nullopt;
    in >> mark;
    if (mark == '(' && in >> column)
        in >> mark;  // the column's closing bracket
    if (mark == ')')
        in >> mark;
    std::string rest;
    std::getline(in, rest);
    return mark == ':' ? std::optional(LogLine{line, rest}) : std::nullopt;
}

std::string excerpt(const fs::path& path, std::size_t line) {
    std::ifstream in(path);
    std::string text;
    std::string out;
    for (std::size_t number = 1; std::getline(in, text) && number <= line + 2; ++number)
        if (number + 2 >= line)
            out += (number == line ? "  > " : "    ") + std::to_string(number) + " | " + text + "\n";
    return out;
}

}  // namespace

std::string explain(const std::string& driverMessage, const std::string& directory,
                    const ShaderSource& source) {
    std::istringstream log(driverMessage);
    std::string out;
    std::string lines;
    for (std::string line; std::getline(log, line);) {
        const std::optional<LogLine> entry = readLogLine(line);
        if (entry && entry->line >= 1 && entry->line <= source.lines.size() &&
            source.lines[entry->line - 1].line > 0) {
            const ShaderLine& place = source.lines[entry->line - 1];
            out += place.file + ":" + std::to_string(place.line) + ":" + entry->rest + "\n";
            if (lines.empty())
                lines = excerpt(fs::path(directory) / place.file, place.line);
        } else if (!line.empty()) {
            out += line + "\n";
        }
    }
    return out + lines;
}

}  // namespace render
