// Run time against error: every method of computing the lighting in every scene. Writes tables for charts.gp.
// SPDX-License-Identifier: MIT
#include "bench/error/report.hpp"
#include "support/draw.hpp"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <optional>
#include <unistd.h>

namespace bench::error {

namespace {

constexpr double fullMilliseconds = 7000,
                 quickMilliseconds = 600;  // of processor time for the turns of a case

struct Options {
    std::filesystem::path out;
    std::string scene;  // empty: all
    int size = 0;  // 0: each case's own
    bool quick = false;
};

std::optional<Options> readOptions(int count, char** arguments) {
    Options options;
    for (int i = 1; i < count; ++i) {
        const std::string name = arguments[i];
        if (name == "--quick") {
            options.quick = true;
            continue;
        }
        if (++i == count)
            return std::nullopt;
        const std::string value = arguments[i];
        const bool sceneKnown = std::any_of(sceneTable().begin(), sceneTable().end(),
                                            [&](const SceneInfo& scene) { return value == scene.id; });
        if (name == "--out" && !value.empty())
            options.out = value;
        else if (name == "--scene" && sceneKnown)
            options.scene = value;
        else if (name == "--size" && std::atoi(value.c_str()) >= 16 && std::atoi(value.c_str()) <= 4096)
            options.size = std::atoi(value.c_str());
        else
            return std::nullopt;
    }
    return options.out.empty() ? std::nullopt : std::optional(options);
}

// One method's errors in one case.
Row judge(const Case& which, const World& world, const Truths& truths, std::size_t method, Drawer& drawer,
          int size) {
    Row row{};
    row.scene = which.scene;
    row.name = which.name;
    row.reference = which.reference;
    row.method = method;
    row.size = size;
    row.lights = world.lights().size();
    row.bound = truths.bound;
    const bool doubles = methods()[method].kind == Kind::processor;
    image::Frame floats = doubles ? image::Frame{size, size, truths.doubles} : drawer.draw(true);
    const image::Frame codes =
        doubles ? image::Frame{size, size, image::toBytes(floats)} : drawer.draw(false);
    row.error = floatError(truths.own, std::get<image::Floats>(floats.pixels));
    row.shadingError = floatError(truths.shading, std::get<image::Floats>(floats.pixels)).max;
    row.codes = codeError(truths.own, std::get<image::Bytes>(codes.pixels));
    return row;
}

std::vector<Row> runCase(const Case& which, int size, double milliseconds) {
    const std::unique_ptr<World> world = which.make();
    const std::unique_ptr<World> floor = which.floor ? which.floor() : which.make();
    if (!which.floor)
        floor->makeUnlit();
    const Truths truths = makeTruths(which, *world, size);
    const std::unique_ptr<Drawer> flat = makeDrawer(methods()[defaultMethod], *floor, size);

    std::vector<Row> rows;
    std::vector<std::unique_ptr<Drawer>> drawers;
    std::vector<Drawer*> frames;
    std::vector<std::size_t> frameOf;  // of each method
    for (std::size_t i = 0; i < methods().size(); ++i) {
        if (i != defaultMethod && isDefault(methods()[i], *world)) {  // the same work is measured once
            rows.push_back(rows[defaultMethod]);
            rows.back().method = i;
            frameOf.push_back(frameOf[defaultMethod]);
            continue;
        }
        drawers.push_back(makeDrawer(methods()[i], *world, size));
        rows.push_back(judge(which, *world, truths, i, *drawers.back(), size));
        frameOf.push_back(frames.size());
        frames.push_back(drawers.back().get());
    }
    const std::vector<Cost> costs = measure(*flat, frames, milliseconds);
    for (Row& row : rows) {
        row.cost = costs[frameOf[row.method]];
        row.ratio = row.cost.lighting / costs[frameOf[threeMethod]].lighting;
    }
    return rows;
}

// Says what the issue asks: is the default on the front, did the bound hold? False if it did not.
bool say(const std::vector<Row>& rows, const std::vector<SceneRow>& scenes) {
    std::cout.precision(3);
    for (const SceneRow& row : scenes)
        if (row.method == defaultMethod)
            std::cout << row.scene << ": the default costs " << row.ratio
                      << (countsFromFloor(row.scene) ? " of the flat-colour frame" : " of three.js's order")
                      << ", largest error " << row.error.max << " u S, " << row.codes.max << " codes; "
                      << (row.onFront ? "on the front" : "NOT on the front") << " in floats, "
                      << (row.onFrontCodes ? "on it" : "NOT on it") << " in 8 bits\n";
    for (const Row& row : rows)
        if (row.method == defaultMethod && countsFromFloor(row.scene))
            std::cout << row.scene << ", " << row.name << ": " << row.cost.overFloor
                      << " of the frame that it must fall to (expected at most 1.05)\n";
    bool held = true;
    for (const Row& row : rows)
        if (row.boundBroken()) {
            held = false;
            std::cerr
                << row.scene << ", " << row.name << ": the default method is " << row.shadingError
                << " u S off, expected at most " << row.bound
                << ", the bound that is promised. Look at shaders/terms, or at the bound's derivation.\n";
        }
    if (held)
        std::cout << "the bound held at every sample of " << rows.size() / methods().size() << " cases\n";
    return held;
}

int run(const Options& options) {
    setenv("LP_NUM_THREADS", "0", 1);  // the driver's work in this thread: what is timed is work
    const std::string driver = support::renderer().name();
    std::vector<Case> cases = allCases(options.quick);
    std::erase_if(cases,
                  [&](const Case& which) { return !options.scene.empty() && which.scene != options.scene; });
    std::filesystem::create_directories(options.out);
    std::vector<Row> rows;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        if (isatty(2) != 0)
            std::cerr << "\r\033[K[" << i + 1 << '/' << cases.size() << "] " << cases[i].scene << ", "
                      << cases[i].name << std::flush;
        const int size = options.size > 0 ? options.size : options.quick ? cases[i].size / 2 : cases[i].size;
        const std::vector<Row> more =
            runCase(cases[i], size, options.quick ? quickMilliseconds : fullMilliseconds);
        rows.insert(rows.end(), more.begin(), more.end());
    }
    if (isatty(2) != 0)
        std::cerr << "\r\033[K";
    const std::vector<SceneRow> scenes = sumUp(rows);
    write(options.out, {driver, options.quick}, rows, scenes);
    return say(rows, scenes) ? 0 : 1;
}

}  // namespace

}  // namespace bench::error

int main(int count, char** arguments) {
    const std::optional<bench::error::Options> options = bench::error::readOptions(count, arguments);
    if (!options) {
        std::cerr << "usage: bench_error --out DIR [--quick] [--scene S0...S9] [--size 16...4096]\n"
                     "Measures run time and error of every method of lighting; DIR/error.csv has a row for "
                     "each case\n"
                     "and method. tests/bench/error/charts DIR draws the charts.\n";
        return 2;
    }
    try {
        return bench::error::run(*options);
    } catch (const std::exception& error) {
        std::cerr << "bench_error: " << error.what() << '\n';
        return 1;
    }
}
