// Steady frames against hand-written ones: few lights, many, none that matter, and thousands with a reach.
// SPDX-License-Identifier: MIT
//
//   bench_steady DIR [--quick | --smoke]        writes DIR/steady.json, .csv, .benchmark.json
//
// One mesh, 51,200 triangles, 512x512, frames in random turns in one process, each waited for.
#include "bench/report.hpp"
#include "bench/scenes.hpp"
#include "bench/timing.hpp"
#include "render/context.hpp"

#include <functional>
#include <iostream>

namespace {

using bench::Goal;

struct Sizes {
    int pixels, along, around, rounds, manyLights;
};
Sizes sizesFor(const bench::Options& options) {
    if (options.smoke)
        return {48, 60, 12, 2, 64};
    return {512, 400, 64, options.quick ? 9 : 25, 4096};
}

// What all groups share.
struct Bench {
    const Sizes sizes;
    THREE::TorusKnotGeometry knot;
    bench::Report report;
    bench::Timing timing;

    explicit Bench(const bench::Options& options, const std::string& driver)
        : sizes(sizesFor(options)), knot(0.9, 0.34, sizes.along, sizes.around), report("steady", driver) {}
    /// Times ours and the yardstick in turns and reports both and their ratio.
    void compare(const std::string& name, bench::Ours& ours, const std::string& yardstickName,
                 const std::function<void()>& yardstick, double target) {
        ours.settle();
        yardstick();
        const auto ms =
            timing.measure({{name, [&] { ours.draw(); }}, {yardstickName, yardstick}}, sizes.rounds, 3);
        report.add(name, ms.at(name), "ms");
        report.add(yardstickName, ms.at(yardstickName), "ms");
        report.add(name + " to " + yardstickName, ms.at(name) / ms.at(yardstickName), "ratio", Goal::atMost,
                   target);
    }
};

// The lit frames against rows (c) and (d) of the yardsticks: the same picture, within a code.
void litFrames(Bench& b) {
    const THREE::Color orange(0xFF8855);
    for (const bool lecture : {true, false}) {
        bench::progress(lecture ? 1 : 2, 4, lecture ? "the lecture's lights" : "64 point lights");
        THREE::MeshLambertMaterial material(orange);
        bench::Stage stage;
        stage.mesh(b.knot, material);
        if (lecture)
            stage.lectureLights();
        else
            stage.lightsAround(64);
        bench::Ours ours(stage, b.sizes.pixels, b.sizes.pixels);
        bench::Probe probe(stage, b.sizes.pixels, b.sizes.pixels,
                           lecture ? std::string(bench::lectureShader) : bench::loopShader(64));
        bench::setLights(probe, stage);
        const std::string name = lecture ? "lecture's lights" : "64 point lights",
                          row = lecture ? "row (c): uniforms" : "row (d): loop over uniforms";
        ours.settle();
        b.report.add(name + ", codes from " + row, bench::codesApart(ours.frame(), probe.frame()), "codes",
                     Goal::atMost, 1);
        b.compare(
            name, ours, row, [&] { probe.draw(); }, lecture ? 0.85 : 0.35);
        if (lecture)
            b.report.add("pixels covered", 100.0 * ours.covered() / (b.sizes.pixels * b.sizes.pixels), "%");
    }
}

// Lights that stand still may be constants of the shader, moving ones may not: the pictures must be the same.
void stillAndMoving(Bench& b) {
    THREE::MeshLambertMaterial material(THREE::Color(0xFF8855));
    bench::Stage stage;
    stage.mesh(b.knot, material);
    stage.lightsAround(63);
    THREE::PointLight& moved = stage.point({3, 1, 2}, 0.2, 0, 2);
    bench::Ours ours(stage, b.sizes.pixels, b.sizes.pixels);
    ours.settle();
    const image::Frame still = ours.frame();
    const auto stillVariants = ours.renderer.stats().variants;
    moved.position.x = 3.5;
    ours.draw();
    moved.position.x = 3;
    const image::Frame moving = ours.frame();  // as long as it is remembered that it moved
    const bool told = ours.renderer.stats().variants != stillVariants;
    ours.settings.constantLights = 0;
    const image::Frame uniforms = ours.frame();
    const bool uniformsTold = ours.renderer.stats().variants != stillVariants;
    ours.settings.skip = false;
    const image::Frame everything = ours.frame();
    b.report.add("64 lights, codes from still to moving", bench::codesApart(still, moving), "codes",
                 Goal::atMost, 0);
    b.report.add("64 lights, codes from still to --no-skip", bench::codesApart(still, everything), "codes",
                 Goal::atMost, 0);
    b.report.add("64 lights, codes from constants to uniforms", bench::codesApart(still, uniforms), "codes",
                 Goal::atMost, 0);
    b.report.add("64 lights, shaders differ between still and moving", told ? 1 : 0, "yes=1");
    b.report.add("64 lights, shaders differ between constants and uniforms", uniformsTold ? 1 : 0, "yes=1");
}

// What needs no lighting must cost what a flat colour costs.
void unlitFrames(Bench& b) {
    bench::progress(3, 4, "unlit, black, ambient only");
    THREE::MeshBasicMaterial unlit(THREE::Color(0x804020));
    THREE::MeshLambertMaterial black(THREE::Color(0x000000)), orange(THREE::Color(0xFF8855));
    bench::Stage flatStage, blackStage, ambientStage;
    flatStage.mesh(b.knot, unlit);
    flatStage.lightsAround(64);
    blackStage.mesh(b.knot, black);
    blackStage.lightsAround(64);
    ambientStage.mesh(b.knot, orange);
    ambientStage.scene.add(std::make_unique<THREE::AmbientLight>(THREE::Color(0x404040)));
    const int size = b.sizes.pixels;
    bench::Ours flat(flatStage, size, size), dark(blackStage, size, size), ambient(ambientStage, size, size);
    bench::Probe floor(flatStage, size, size, bench::flatShader);
    bench::setLights(floor, flatStage);
    const std::vector<std::pair<std::string, bench::Ours*>> frames = {
        {"unlit", &flat}, {"black under 64 lights", &dark}, {"ambient only", &ambient}};
    std::vector<bench::Case> cases = {{"flat colour, the floor", [&] { floor.draw(); }}};
    for (const auto& [name, ours] : frames) {
        ours->settle();
        cases.push_back({name, [one = ours] { one->draw(); }});
    }
    const auto ms = b.timing.measure(cases, b.sizes.rounds, 3);
    b.report.add(cases[0].name, ms.at(cases[0].name), "ms");
    for (const auto& [name, ours] : frames) {
        b.report.add(name, ms.at(name), "ms");
        b.report.add(name + " to the floor", ms.at(name) / ms.at(cases[0].name), "ratio", Goal::atMost, 1.05);
    }
}

// Thousands of lights that each reach a fortieth of the scene, against 16 that reach all of it.
void manyLights(Bench& b) {
    const std::string many = std::to_string(b.sizes.manyLights) + " lights with a reach of 1/40",
                      few = "16 lights without end, in a texture too";
    bench::progress(4, 4, many);
    THREE::MeshLambertMaterial material(THREE::Color(0xFF8855));
    bench::Stage manyStage, fewStage;
    const THREE::Box3 box = b.knot.boundingBox();
    manyStage.mesh(b.knot, material);
    manyStage.lightsWithin(b.sizes.manyLights, box.max, b.knot.boundingSphere().radius / 20);
    fewStage.mesh(b.knot, material);
    fewStage.lightsAround(16);
    bench::Ours manyFrame(manyStage, b.sizes.pixels, b.sizes.pixels),
        fewFrame(fewStage, b.sizes.pixels, b.sizes.pixels);
    fewFrame.settings.uniformLights = 0;  // the same path
    fewFrame.settle();
    b.compare(
        many, manyFrame, few, [&] { fewFrame.draw(); }, 1.5);
}

void measure(const bench::Options& options) {
    const render::HeadlessContext context;
    std::string driver;
    {
        bench::Stage stage;
        driver = bench::Ours(stage, 8, 8).renderer.name();
    }
    Bench b(options, driver);
    litFrames(b);
    stillAndMoving(b);
    unlitFrames(b);
    manyLights(b);
    b.timing.write(options.out / "steady.benchmark.json");
    b.report.write(options.out);
}

}  // namespace

int main(int count, char** arguments) {
    return bench::guarded("bench_steady", measure, bench::readOptions(count, arguments));
}
