// Fuzz target: any bytes as a command line, one argument per line; and each line as a line of --frames-from.
// SPDX-License-Identifier: MIT
#include "fuzz/property.hpp"
#include "lab/failure.hpp"
#include "lab/frame_lines.hpp"
#include "lab/options.hpp"

#include <cmath>
#include <vector>

namespace {

using fuzz::require;

std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string line = text.substr(begin, end - begin);
        lines.push_back(line.substr(0, line.find('\0')));  // an argument of main ends at a NUL
        begin = end + 1;
    }
    return lines;
}

bool isNumber(double x) { return std::abs(x) <= 1e36; }

void checkCamera(const lab::CameraOption& camera) {
    bool differ = false;
    for (int i = 0; i < 3; ++i) {
        require(isNumber(camera.position[i]) && isNumber(camera.target[i]), "--camera took no number");
        differ |= camera.position[i] != camera.target[i];
    }
    require(differ, "--camera took the same point twice");
    require(!camera.fov || (*camera.fov > 0 && *camera.fov < 180), "--camera took an impossible angle");
}

void checkOptions(const lab::Options& options, bool file) {
    require(options.lesson == "lesson", "the program has lost its name");
    require(options.sceneFile.empty() != file, "a scene file only, and always, where one is read");
    require(options.width.has_value() == options.height.has_value(), "--size took one number");
    for (const int side : {options.width.value_or(1), options.height.value_or(1)})
        require(side >= 1 && side <= 8192, "--size took a side out of range");
    require(isNumber(options.time), "--time took no number");
    require(!options.decay || (isNumber(*options.decay) && *options.decay >= 0), "--decay took no exponent");
    require(options.frames >= 0 && options.frames <= 1'000'000, "--frames took a number out of range");
    require(options.switches.terms.bits() >> lighting::termCount == 0,
            "--terms took a term that does not exist");
    require(options.framesFrom.empty() || options.frame.empty(), "--frames-from took a --frame beside it");
    if (options.camera)
        checkCamera(*options.camera);
}

void checkFrameLine(const std::string& line) {
    lab::Options commandLine;
    commandLine.lesson = "lesson";
    try {
        const lab::Options options = lab::parseFrameLine(lab::splitWords(line), commandLine);
        checkOptions(options, false);
        require(!options.frame.empty() && options.framesFrom.empty(), "a line of frames is one frame");
        require(options.frames == 0 && options.dumpScene.empty() && !options.dumpShader,
                "a line of frames took what is not about one frame");
    } catch (const lab::UsageError& error) {
        require(*error.what() != '\0', "an error without a message");
    }
}

void checkEnding(const lab::Ending& ending) {
    require(ending.status == 0 || ending.status == 2, "left with a status that was not promised");
    require(ending.out.empty() == (ending.status == 2), "stdout is for what was asked, and never empty then");
    require(ending.err.empty() == (ending.status == 0), "stderr is for what is wrong, and never empty then");
    require(ending.status == 0 || ending.err.starts_with("lesson: "), "an error does not name the program");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::vector<std::string> arguments = split(std::string(reinterpret_cast<const char*>(data), size));
    for (const bool file : {false, true}) {
        const auto parsed = lab::parseOptions(arguments, "lesson", file);
        if (const auto* options = std::get_if<lab::Options>(&parsed))
            checkOptions(*options, file);
        else
            checkEnding(std::get<lab::Ending>(parsed));
    }
    for (const std::string& line : arguments)
        checkFrameLine(line);
    return 0;
}
