// The command line that every lesson and scene_viewer understand.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/terms.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace lab {

enum class Language { it, en };

/// What draws: the graphics driver, or the double-precision evaluation of the same equation on the CPU.
enum class RendererKind { gl, reference };

/// The text in one of the lab's two languages.
inline const char* say(const lighting::Text& text, Language language) {
    return language == Language::it ? text.it : text.en;
}

/// A camera given by hand: where it stands, what it looks at (world space), and perhaps its angle of view in degrees.
struct CameraOption {
    double position[3];
    double target[3];
    std::optional<double> fov;
};

/// Reads --camera's px,py,pz,tx,ty,tz[,fov]. Throws UsageError that says what was expected.
CameraOption readCamera(std::string_view text);

/// Reads --size's WIDTHxHEIGHT, each from 1 to 8192. Throws UsageError.
std::pair<int, int> readSize(std::string_view text);

/// What the command line says.
struct Options {
    std::string lesson;  ///< the program's name
    std::string sceneFile;  ///< scene_viewer's argument, else empty
    std::string frame;  ///< --frame: where to write, or empty
    std::optional<int> width, height;  ///< --size, pixels, 1 to 8192
    double time = 0;  ///< --time, seconds
    lighting::Switches switches;  ///< --terms, --shading, --space, --normal-matrix, --specular
    std::optional<double> decay;
    std::string framesFrom;  ///< --frames-from: a file of option lines, "-" for stdin, or empty
    std::vector<std::string> set;  ///< --set: NAME=VALUE of sliders, which only the App knows
    std::optional<CameraOption> camera;
    std::optional<std::uint64_t> jitter;
    bool skip = true;  ///< --no-skip turns it off
    double lightCut = 0;  ///< --light-cut: what a pixel may lack, 8-bit codes; 0: nothing
    RendererKind renderer = RendererKind::gl;
    std::string shaders;  ///< --shaders, or empty
    std::string state;  ///< --state: a file with a saved state, or empty
    double fontSize = 16;  ///< of the window's text, 16 to 48; --presenter: 28, or what it says
    bool lightTheme = false;  ///< --theme light
    int frames = 0;  ///< --frames: how many to time; 0: none
    bool stats = false;
    std::string dumpScene;  ///< where to write the scene's JSON, or empty
    bool dumpShader = false;
    Language language = Language::en;

    /// Whether a window may open: nothing was asked that a window does not give.
    bool wantsWindow() const {
        return frame.empty() && framesFrom.empty() && frames == 0 && !stats && dumpScene.empty() &&
               !dumpShader;
    }
};

/// Why a program leaves before it begins: what was asked is told on stdout (status 0: --help, --version,
/// --list-terms), or what is wrong with the command line on stderr (status 2).
struct Ending {
    int status;
    std::string out, err;
};

/// Reads a command line, without the program's name; `file` says whether the program takes a scene file.
std::variant<Options, Ending> parseOptions(std::span<const std::string> arguments, const std::string& lesson,
                                           bool file);

/// Reads the words of a line of --frames-from, on top of the command line's options: what the line says replaces what they
/// say, its --set are added. A line has a --frame of its own; what is not about one frame is refused, and so is a scene file.
/// Throws UsageError.
Options parseFrameLine(std::span<const std::string> words, const Options& commandLine);

/// parseOptions for `main`: prints an Ending and leaves with its status (5 if stdout cannot be written).
Options readOptions(int argc, char** argv, const std::string& lesson, bool file);

/// Sends off what was said on stdout. False, with a message on stderr, if it could not be written.
bool flushOutput(const std::string& who);

/// Italian where LC_ALL, LC_MESSAGES or LANG (the first that is set) say so, else English.
Language languageOfLocale();

}  // namespace lab
