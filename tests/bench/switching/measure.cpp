// Frames after a switch, and frames of new shaders.
// SPDX-License-Identifier: MIT
#include "bench/switching/measure.hpp"

#include "bench/report.hpp"
#include "bench/scenes.hpp"
#include "bench/switching/window.hpp"
#include "render/context.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace bench {

namespace {

constexpr int size = 512;

double milliseconds(Ours& ours) {
    const auto start = std::chrono::steady_clock::now();
    ours.draw();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// The first frame's time beyond a steady one's. Below 0 only by noise.
double firstBeyondSteady(Ours& ours) {
    const double first = milliseconds(ours);
    ours.renderer.finishCompiling();
    ours.draw();
    return std::max(0.0, first - median({milliseconds(ours), milliseconds(ours), milliseconds(ours)}));
}

void print(const std::string& group, const std::string& name, double ms) {
    std::printf("%s\t%s\t%.4f\n", group.c_str(), name.c_str(), ms);
}

// Every kind of light and a highlight, so that every key has something to switch.
struct FullStage : Stage {
    FullStage() {
        mesh(knot, material);
        lectureLights();
        point({-3, 2, 1}, 6, 0, 2);
    }
    THREE::TorusKnotGeometry knot{0.9, 0.34, 400, 64};
    THREE::MeshPhongMaterial material{THREE::Color(0xFF8855)};
};

// The first frame of more and more lights, which all have shaders of their own.
void compile(const std::string& amount) {
    const int most = amount == "--smoke" ? 2 : amount == "--quick" ? 64 : 256;
    THREE::TorusKnotGeometry knot(0.9, 0.34, 400, 64);
    THREE::MeshLambertMaterial material(THREE::Color(0xFF8855));
    for (int lights = 0; lights <= most; lights = lights == 0 ? 1 : lights * 2) {
        Stage stage;
        stage.mesh(knot, material);
        stage.lightsAround(lights);
        Ours ours(stage, size, size);
        const double beyond = firstBeyondSteady(ours);
        const std::string name = std::to_string(lights) + " lights";
        print("first frame beyond a steady one", name, beyond);
        print("of which compiling GLSL", name, ours.renderer.stats().compileMilliseconds);
    }
}

// The lessons themselves, each a process: what they compile, and when their first frame is there.
void lessons(const std::string& amount) {
    namespace fs = std::filesystem;
    const fs::path bin = fs::read_symlink("/proc/self/exe").parent_path();
    for (const fs::directory_entry& entry : fs::directory_iterator(bin)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with("lesson_") || (amount == "--smoke" && name != "lesson_04_ambient"))
            continue;
        const nlohmann::json stats =
            nlohmann::json::parse(outputOf("'" + entry.path().string() + "' --stats"), nullptr, false);
        if (!stats.is_object())
            throw std::runtime_error(name + " --stats printed no JSON");
        print("process to first frame", name, stats.at("first_frame_ms"));
        print("of which compiling GLSL", name, stats.at("compile_ms"));
    }
}

}  // namespace

std::string outputOf(const std::string& command) {
    std::FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr)
        throw std::runtime_error("cannot start " + command);
    std::string text;
    char buffer[4096];
    for (std::size_t got = 0; (got = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;)
        text.append(buffer, got);
    if (pclose(pipe) != 0)
        throw std::runtime_error("failed: " + command);
    return text;
}

int switchingChild(const std::string& part, const std::string& amount) {
    try {
        const render::HeadlessContext context;
        {
            FullStage stage;
            Ours ours(stage, 8, 8);
            print("driver", ours.renderer.name(), 0);
        }
        if (part == "toggle" || part == "prepared") {
            changes(amount, part == "prepared");
        } else {
            compile(amount);
            lessons(amount);
        }
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_switching: %s\n", error.what());
        return 1;
    }
}

}  // namespace bench
