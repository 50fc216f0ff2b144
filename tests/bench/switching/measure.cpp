// Frames after a switch, and frames of new shaders.
// SPDX-License-Identifier: MIT
#include "bench/switching/measure.hpp"

#include "bench/report.hpp"
#include "bench/scenes.hpp"
#include "render/context.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>

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

// From all symbols on: each one off, from there each other one off, and back.
void toggle(const std::string& amount) {
    FullStage stage;
    Ours ours(stage, size, size);
    ours.settle();
    const auto& terms = lighting::terms();
    const auto to = [&ours](const char* group, const std::string& name, lighting::TermSet set) {
        ours.settings.terms = set;
        print(group, name, firstBeyondSteady(ours));
    };
    const std::size_t firsts = amount == "--smoke" ? 1 : terms.size(), seconds = amount.empty() ? terms.size()
                                                                                 : firsts == 1  ? 2
                                                                                                : 3;
    for (std::size_t i = 0; i < firsts; ++i) {
        const std::string name = terms[i].name;
        const lighting::TermSet one = lighting::TermSet::all().without(terms[i].term);
        to("first visit", name + " off", one);
        for (std::size_t j = i + 1; j < std::min(i + 1 + seconds, terms.size()); ++j) {
            to("first visit", name + " off then " + terms[j].name + " off", one.without(terms[j].term));
            to("back", std::string(terms[j].name) + " on, " + name + " off", one);
        }
        to("back", name + " on", lighting::TermSet::all());
    }
}

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

}  // namespace

int switchingChild(const std::string& part, const std::string& amount) {
    try {
        const render::HeadlessContext context;
        {
            FullStage stage;
            Ours ours(stage, 8, 8);
            print("driver", ours.renderer.name(), 0);
        }
        part == "toggle" ? toggle(amount) : compile(amount);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_switching: %s\n", error.what());
        return 1;
    }
}

}  // namespace bench
