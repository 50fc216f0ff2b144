// Rows F1 to F6: how pixels reach the frame.
// SPDX-License-Identifier: MIT
#include "stability/grid.hpp"
#include "stability/peers.hpp"
#include "stability/rows.hpp"
#include "stability/shader_text.hpp"

#include "render/gl_renderer.hpp"
#include "render/shader_source.hpp"
#include "support/program.hpp"

#include <cmath>
#include <limits>

namespace stability {

namespace {

Setup lit(double intensity) {
    Setup s{{sun({0, 0, 1}, intensity)}};
    s.ambient = 0;
    s.expected = intensity;
    return s;
}

// A NaN or an infinity that is put into the plan by hand, past all refusals, is noticed; in what passes them there is none.
void counter(Outcome& outcome) {
    Stage stage(lit(1), 1);
    const support::Drawn drawn = support::draw(stage.scene, stage.camera, stage.options);
    render::GlRenderer renderer(render::findShaderDirectory(""));
    lighting::Settings settings = stage.options.settings;
    settings.countNonfinite = true;
    const auto counted = [&](double bad, bool scaled = false) {
        lighting::FramePlan plan = drawn.plan;
        plan.draws.at(0).variant.countNonfinite = true;
        plan.draws[0].variant.scaled = scaled;
        plan.draws[0].albedo.g = bad;
        renderer.render(plan, settings, {stage.options.width, stage.options.height, true});
        return renderer.stats().nonfinite.value_or(-1);
    };
    const long long pixels = stage.options.width * stage.options.height;
    const double infinite = std::numeric_limits<double>::infinity();
    for (const double bad : {std::nan(""), infinite, -infinite})
        require(outcome, counted(bad) == pixels,
                number(bad) + " is counted in " + std::to_string(counted(bad)) + " pixels of " +
                    std::to_string(pixels));
    // Where numbers are scaled, infinity is limited on purpose; NaN must not hide behind that.
    require(outcome, counted(std::nan(""), true) == pixels, "the scaled text does not count NaN");
    for (const bool scaled : {false, true})
        require(outcome, counted(0.5, scaled) == 0, "an ordinary frame counts pixels");
    outcome.naive = outcome.legacy = outcome.physical = {"0, 255, 0 stored", Peer::notFinite};
    outcome.expected = outcome.twin = outcome.gl = "none stored";
    outcome.bound = "counter 0";
}

// Exactly between two codes as far as a float can be, and the floats beside.
void ties(Outcome& outcome) {
    std::vector<glm::vec3> values;
    for (int c = 0; c < 255; ++c) {
        const float tie = static_cast<float>((c + 0.5) / 255);
        values.emplace_back(std::nextafter(tie, 0.0F), tie, std::nextafter(tie, 1.0F));
    }
    const Grid grid = drawGrid(values);
    int differ = 0;
    const image::Bytes cpu = image::toBytes(grid.floats);
    for (std::size_t i = 0; i < values.size() * 3; ++i) {
        const float value = values[i / 3][static_cast<int>(i % 3)];
        require(outcome, std::get<image::Floats>(grid.floats.pixels)[i] == value,
                "the float frame does not hold " + number(value));
        differ += cpu[i] != grid.codes[i] ? 1 : 0;
    }
    require(outcome, differ == 0, std::to_string(differ) + " of 765 codes differ between driver and CPU");
    outcome.expected = outcome.twin = outcome.gl = "same codes";
    outcome.bound = "exact";
}

// All codes come back as they are: no curve, no blending, no dithering.
void everyCode(Outcome& outcome) {
    std::vector<glm::vec3> values;
    for (int c = 0; c < 256; ++c)
        values.emplace_back(c / 255.0, (255 - c) / 255.0, c / 2 / 255.0);
    const Grid grid = drawGrid(values);
    for (int c = 0; c < 256; ++c) {
        const auto i = static_cast<std::size_t>(c) * 3;
        require(outcome, grid.codes[i] == c && grid.codes[i + 1] == 255 - c && grid.codes[i + 2] == c / 2,
                "code " + std::to_string(c) + " comes back as " + std::to_string(grid.codes[i]));
    }
    // An sRGB target's curve, for 0.5: what a frame would hold with it.
    outcome.naive = {"188", Peer::wrong};
    outcome.legacy = outcome.physical = {"128", Peer::ok};  // r146 writes no curve by default
    outcome.expected = outcome.twin = outcome.gl = "128";
    outcome.bound = "exact";
}

// Beyond 16 bits from y = 16 on.
void wideInts(Outcome& outcome) {
    requireHighp(outcome);
    Stage stage(lit(1), 1);
    const support::Drawn drawn = support::draw(stage.scene, stage.camera, stage.options);
    const std::string index = "(int(gl_FragCoord.y) * 4096 + int(gl_FragCoord.x))";
    const image::Floats found =
        drawExpression(drawn.plan, stage.options,
                       "vec3(float(" + index + " >> 12), float(" + index + " & 4095), float(" + index + "))");
    int wrong = 0, wrongIn16 = 0;
    const int width = stage.options.width;
    for (int y = 0; y < width; ++y)
        for (int x = 0; x < width; ++x) {
            const auto i = static_cast<std::size_t>((width - 1 - y) * width + x) * 3;
            wrong += found[i] != static_cast<float>(y) || found[i + 1] != static_cast<float>(x) ||
                             found[i + 2] != static_cast<float>(y * 4096 + x)
                         ? 1
                         : 0;
            wrongIn16 +=
                static_cast<short>(static_cast<unsigned short>(y * 4096 + x)) != y * 4096 + x ? 1 : 0;
        }
    require(outcome, wrong == 0, std::to_string(wrong) + " pixels hold another index");
    outcome.naive = {number(100.0 * wrongIn16 / (width * width)) + " % wrong", Peer::wrong};
    outcome.expected = outcome.gl = "0 % wrong";
    outcome.twin = "highp declared";
    outcome.bound = "exact";
}

void noHalf(Outcome& outcome) {
    outcome.naive = peer(halfTruncated(65520), 65520);
    const Measured fine = measure(lit(1.00049));  // half holds 1 and 1.000977
    outcome.failures.insert(outcome.failures.end(), fine.failures.begin(), fine.failures.end());
}

// A lesson's frame, drawn in one thread, in two, and in as many as the driver likes.
void threads(Outcome& outcome) {
    const support::TemporaryDirectory directory;
    std::vector<std::string> frames;
    for (const std::string count : {"0", "1", "2", "7"}) {
        const std::string file = "threads" + count + ".exr";
        const support::Outcome ran = support::run({"lesson_04_ambient", "--frame", file, "--size", "131x97"},
                                                  directory.path(), {{"LP_NUM_THREADS", count}});
        require(outcome, ran.status == 0, "with LP_NUM_THREADS=" + count + ": " + ran.err);
        frames.push_back(support::readFile(directory.path() / file));
        require(outcome, !frames[0].empty() && frames.back() == frames[0],
                "LP_NUM_THREADS=" + count + " gives another frame");
    }
    outcome.expected = outcome.gl = "identical";
    outcome.bound = "exact";
}

}  // namespace

std::vector<Row> frameRows() {
    return {
        {"F1", "NaN stored", "RGBA8", Kind::frame, {lit(1)}, {}, counter},
        {"F2", "ties", "(c + 0.5) / 255", Kind::frame, {}, {}, ties},
        {"F3", "sRGB target", "all codes, 0.5 shown", Kind::frame, {}, {}, everyCode},
        {"F4", "16-bit int", "y * 4096 + x", Kind::frame, {}, {}, wideInts},
        {"F5", "half overflow", "65520", Kind::frame, {lit(65520)}, {}, noHalf},
        {"F6", "threads", "LP_NUM_THREADS = 0, 1, 2, 7", Kind::frame, {}, {}, threads},
    };
}

}  // namespace stability
