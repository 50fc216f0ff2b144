// Includes, #defines, and error messages that name the real file and line.
// SPDX-License-Identifier: MIT
#include "render/shader_source.hpp"

#include "render/error.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <regex>
#include <set>
#include <sstream>

namespace render {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> readLines(const std::string& path, const std::string& askedBy) {
    std::ifstream in(path);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    if (lines.empty())
        throw ShaderError(askedBy + "cannot read shader file " + path +
                          "; expected a text file there. Check --shaders, or restore the file.");
    return lines;
}

class Reader {
  public:
    explicit Reader(const std::string& directory) : directory_(directory) {}

    ShaderSource source;

    void own(const std::string& text) {
        std::istringstream in(text);
        for (std::string line; std::getline(in, line);)
            add(line, {"", 0});
    }

    void include(const std::string& file, const std::string& askedBy) {
        if (!included_.insert(file).second)
            return;  // as with #pragma once; a file that includes itself ends here too
        const std::vector<std::string> lines = readLines(directory_ + "/" + file, askedBy);
        static const std::regex pattern(R"rx(^\s*#\s*include\s+"([^"]+)"\s*$)rx");
        for (std::size_t i = 0; i < lines.size(); ++i) {
            std::smatch match;
            if (lines[i].find("include") != std::string::npos && std::regex_match(lines[i], match, pattern))
                include(match[1], file + ":" + std::to_string(i + 1) + ": ");
            else
                add(lines[i], {file, i + 1});
        }
    }

  private:
    void add(const std::string& line, ShaderLine place) {
        source.text += line + "\n";
        source.lines.push_back(std::move(place));
    }

    const std::string& directory_;
    std::set<std::string> included_;
};

}  // namespace

std::string findShaderDirectory(const std::string& asked) {
    std::vector<std::string> candidates;
    if (!asked.empty()) {
        candidates = {asked};
    } else {
        std::error_code ignored;
        const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
        candidates = {(program.parent_path().parent_path() / "share/lambert-lab/shaders").string(),
                      LAMBERT_SHADER_DIR};
    }
    std::string tried;
    for (const std::string& directory : candidates) {
        std::error_code ignored;
        if (fs::exists(fs::path(directory) / "mesh.vert", ignored))
            return directory;
        tried += "\n  " + directory;
    }
    throw ShaderError(
        "no shader files; expected a folder with mesh.vert, mesh.frag and lighting.glsl. Tried:" + tried +
        "\n  Name the folder with --shaders DIR.");
}

ShaderSource readShader(const std::string& directory, const std::string& file, const std::string& preamble) {
    Reader reader(directory);
    reader.own(preamble);
    reader.include(file, "");
    return std::move(reader.source);
}

std::string preamble(const lighting::Variant& v, bool fragment, bool lightsInTexture) {
    std::ostringstream out;
    out << "#version 300 es\nprecision highp float;\nprecision highp int;\n";
    out << "#define " << (fragment ? "FRAGMENT" : "VERTEX") << "_SHADER\n";
    const auto define = [&out](const char* name, int value) {
        out << "#define " << name << ' ' << value << '\n';
    };
    define("DOUBLE_SIDED", v.doubleSided);
    define("COUNT_NONFINITE", v.countNonfinite);
    if (v.lit) {
        for (const lighting::TermInfo& row : lighting::terms())
            define(row.define, static_cast<int>(v.terms >> static_cast<unsigned>(row.term) & 1U));
        define("WINDOW", v.window);
        define("NUM_DIRECTIONAL_LIGHTS", v.directional);
        define("NUM_POINT_LIGHTS", v.point());
        define("END_DECAY_0", v.decay0);
        define("END_DECAY_1", v.decay0 + v.decay1);
        define("END_DECAY_2", v.decay0 + v.decay1 + v.decay2);
        define("LIGHTS_IN_TEXTURE", lightsInTexture);
    }
    return out.str();
}

namespace {

// The line number in one line of a driver's log: Mesa "0:7(3): error", NVIDIA "0(7) : error", ANGLE "ERROR: 0:7: ".
std::optional<std::size_t> lineIn(const std::string& logLine, std::smatch& match) {
    static const std::regex pattern(R"rx(^(?:ERROR: |WARNING: )?\d{1,6}[:(](\d{1,6})(?:\(\d+\))?\)?\s*:)rx");
    if (!std::regex_search(logLine, match, pattern))
        return std::nullopt;
    return std::stoul(match[1]);
}

std::string excerpt(const std::string& path, std::size_t line) {
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
        std::smatch match;
        const std::optional<std::size_t> number = lineIn(line, match);
        if (number && *number >= 1 && *number <= source.lines.size() && source.lines[*number - 1].line > 0) {
            const ShaderLine& place = source.lines[*number - 1];
            out += place.file + ":" + std::to_string(place.line) + ":" + match.suffix().str() + "\n";
            if (lines.empty())
                lines = excerpt(directory + "/" + place.file, place.line);
        } else if (!line.empty()) {
            out += line + "\n";
        }
    }
    return out + lines;
}

}  // namespace render
