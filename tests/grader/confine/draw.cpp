// Lets a program draw, and believes nothing of what comes back but floats in their number.
// SPDX-License-Identifier: MIT
#include "grader/confine/builder.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <sstream>
#include <stdexcept>

namespace grader {

namespace {

constexpr std::uint64_t mostSceneBytes = std::uint64_t{4} << 20;

Job jobOf(const Kit& kit, const Drawing& drawing) {
    Job job;
    job.limits = drawing.limits;
    job.command = {"../lab/bin/program"};
    job.command.insert(job.command.end(), drawing.words.begin(), drawing.words.end());
    job.mounts = {{kit.library, "/lab/lib/lambert-lab/liblambert_lab_kit.so"}};
    job.texts = {{"/lab/bin/program", drawing.program}};
    for (const auto& [name, text] : drawing.shaders) {
        job.texts.emplace_back("/lab/share/lambert-lab/shaders/" + name, text);
    }
    for (const auto& [name, text] : drawing.files) {
        job.texts.emplace_back("/box/in/" + name, text);
    }
    return job;
}

std::string headerOf(const Drawing& drawing) {
    return "PF\n" + std::to_string(drawing.width) + " " + std::to_string(drawing.height) + "\n-1.0\n";
}

const char* inWords(float value) { return std::isnan(value) ? "NaN" : "infinite"; }

// Of the exact size already. Throws std::runtime_error that says what is wrong with it.
std::vector<float> readFloats(const std::string& bytes, const Drawing& drawing) {
    static_assert(std::endian::native == std::endian::little);
    const std::string header = headerOf(drawing);
    if (bytes.compare(0, header.size(), header) != 0) {
        throw std::runtime_error("it is no PFM picture of " + std::to_string(drawing.width) + "x" +
                                 std::to_string(drawing.height) + " pixels");
    }
    const auto width = static_cast<std::size_t>(drawing.width);
    const auto height = static_cast<std::size_t>(drawing.height);
    std::vector<float> floats(width * height * 3);
    for (std::size_t y = 0; y < height; ++y) {  // the format's first row is the lowest
        const char* const row = bytes.data() + header.size() + (height - 1 - y) * width * 3 * sizeof(float);
        std::memcpy(floats.data() + y * width * 3, row, width * 3 * sizeof(float));
    }
    const auto bad =
        std::find_if(floats.begin(), floats.end(), [](float value) { return !std::isfinite(value); });
    if (bad != floats.end()) {
        const auto pixel = static_cast<std::size_t>(bad - floats.begin()) / 3;
        throw std::runtime_error("pixel " + std::to_string(pixel % width) + "," +
                                 std::to_string(pixel / width) + " is " + inWords(*bad));
    }
    return floats;
}

}  // namespace

Frames draw(const Confinement& confinement, const Kit& kit, const Drawing& drawing, int slot) {
    Job job = jobOf(kit, drawing);
    std::string list;
    const auto floats =
        static_cast<std::uint64_t>(drawing.width) * static_cast<std::uint64_t>(drawing.height) * 3;
    for (std::size_t i = 0; i < drawing.lines.size(); ++i) {
        const std::string file = std::to_string(i) + ".pfm";
        list += drawing.lines[i] + " --frame out/" + file + "\n";
        job.wanted.push_back({file, headerOf(drawing).size() + floats * sizeof(float), true});
    }
    const std::string size = std::to_string(drawing.width) + "x" + std::to_string(drawing.height);
    for (const std::string& word :
         {std::string("--size"), size, std::string("--frames-from"), std::string("in/frames.txt")}) {
        job.command.push_back(word);
    }
    job.texts.emplace_back("/box/in/frames.txt", list);
    Frames drawn;
    drawn.outcome = confinement.run(job, slot);
    drawn.frames.resize(drawing.lines.size());
    drawn.problems.resize(drawing.lines.size());
    for (std::size_t i = 0; i < drawing.lines.size(); ++i) {
        const Returned& file = drawn.outcome.files[i];
        const std::string frame = "frame " + std::to_string(i);
        try {
            if (file.problem.empty()) {
                drawn.frames[i] = readFloats(file.bytes, drawing);
            } else {
                drawn.problems[i] = frame + " " + file.problem;
            }
        } catch (const std::runtime_error& error) {
            drawn.problems[i] = frame + ": " + error.what();
        }
    }
    drawn.outcome.files.clear();
    return drawn;
}

Dump dumpScene(const Confinement& confinement, const Kit& kit, const Drawing& drawing, double time,
               int slot) {
    Job job = jobOf(kit, drawing);
    std::ostringstream seconds;
    seconds.precision(17);
    seconds << time;
    for (const std::string& word :
         {std::string("--dump-scene"), std::string("out/scene.json"), std::string("--time"), seconds.str()}) {
        job.command.push_back(word);
    }
    job.wanted = {{"scene.json", mostSceneBytes, false}};
    Dump dump;
    dump.outcome = confinement.run(job, slot);
    dump.scene = std::move(dump.outcome.files[0].bytes);
    dump.problem = dump.outcome.files[0].problem.empty() ? "" : "the scene " + dump.outcome.files[0].problem;
    dump.outcome.files.clear();
    return dump;
}

}  // namespace grader
