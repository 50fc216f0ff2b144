// Builds a submission and lets it draw, all of it inside a confinement.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/confine/confine.hpp"

#include <map>
#include <memory>

namespace grader {

/// What submissions are compiled with (tests/grader/kit): all that the compiler sees beside them.
struct Kit {
    std::string compiler;
    std::vector<std::string> flags;
    std::filesystem::path includes;  ///< the lab's headers
    std::filesystem::path compiled;  ///< the folder of lab/lab.hpp.gch
    std::filesystem::path library;  ///< all of the lab
    std::shared_ptr<const void> copy;  ///< what keeps a copy of the three alive, if they had to be copied
};

/// The kit of this lab, in the build tree or installed; a copy of it for all to read, as long as a Kit is left, where we are root and the
/// lab lies where only root may look (/root, say), since submissions are built as another user. Throws std::runtime_error, which says what is not there.
Kit findKit();

/// A submission's source. Names may be anything that came in an archive.
struct Source {
    std::string name;  ///< "lesson_05_attenuation.cpp"
    std::string text;
    std::vector<std::pair<std::string, std::string>>
        headers;  ///< names as the source includes them, and texts
};

struct Built {
    bool ok = false;
    std::string program;  ///< the bytes
    std::string log;  ///< what the compiler says, harmless, paths cut down to file names, at most 60 lines
    Ended how = Ended::notStarted;
    std::string trouble;  ///< the confinement's own
    double seconds = 0;
};

/// What compiling may use.
Limits buildLimits();

/// Compiles and links; `slot`, here and below, as in Confinement::run.
Built build(const Confinement& confinement, const Kit& kit, const Source& source, int slot = 0,
            const Limits& limits = buildLimits());

/// A program, and all that it is given to draw frames with.
struct Drawing {
    std::string program;  ///< the bytes: of a submission (Built) or of the lab's own (programBytes)
    std::vector<std::string> words;  ///< further words of the command line, as "in/scene.json"
    std::map<std::string, std::string>
        shaders;  ///< all of share/lambert-lab/shaders: names from there, and texts
    std::vector<std::pair<std::string, std::string>> files;  ///< in /box/in: names and texts
    std::vector<std::string> lines;  ///< one frame each, as in --frames-from; without --frame and --size
    int width = 0;
    int height = 0;
    Limits limits;
};

struct Frames {
    std::vector<std::vector<float>>
        frames;  ///< of each line: R, G, B, top row first; empty where there is a problem
    std::vector<std::string>
        problems;  ///< of each line: empty, or "frame 3: pixel 12,40 is NaN"; lines count from 0
    Outcome outcome;  ///< without its files
};

/// Draws all lines in one process. A frame is whole, of the size asked for, and finite, or it is none.
Frames draw(const Confinement& confinement, const Kit& kit, const Drawing& drawing, int slot = 0);

struct Dump {
    std::string scene;  ///< three.js JSON, at most 4 MB; whatever the program says it is
    std::string problem;  ///< empty, or why there is none
    Outcome outcome;
};

/// The scene at a time, as the program itself writes it (--dump-scene). Uses program, words, shaders, files and limits.
Dump dumpScene(const Confinement& confinement, const Kit& kit, const Drawing& drawing, double time,
               int slot = 0);

/// The bytes of a file of the lab's own. Throws std::runtime_error that names it.
std::string fileBytes(const std::filesystem::path& path);
/// A program of the lab's own, as "scene_viewer". Throws std::runtime_error if it is not there.
std::string programBytes(const std::string& name);
/// Every file of share/lambert-lab/shaders, for Drawing::shaders.
std::map<std::string, std::string> labShaders();

}  // namespace grader
