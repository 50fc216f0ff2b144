// Draws a scene with and without what lighting/frame_plan.hpp leaves out: the frames must be the same bytes.
// SPDX-License-Identifier: MIT
#include "support/both_ways.hpp"

#include "render/shader_source.hpp"
#include "three/validate.hpp"

#include <algorithm>
#include <cstring>
#include <gtest/gtest.h>
#include <sstream>

namespace support {

namespace {

constexpr int mostBeyondSilhouettes = 3;  // measured: 16 in 120 frames of 256 x 256

template <class Values>
std::string differenceOf(const image::Frame& a, const Values& x, const Values& y) {
    int pixels = 0;
    std::ostringstream first;
    first.precision(9);
    for (std::size_t i = 0; i < x.size(); i += 3) {
        if (std::memcmp(&x[i], &y[i], 3 * sizeof x[i]) == 0)
            continue;
        const auto pixel = static_cast<int>(i / 3);
        if (pixels++ == 0)
            for (std::size_t c = 0; c < 3; ++c)
                first << (c == 0 ? "" : ", ") << +x[i + c] << " is " << +y[i + c];
        if (pixels == 1)
            first << " at " << pixel % a.width << ',' << pixel / a.width;
    }
    return pixels == 0 ? "" : std::to_string(pixels) + " pixels differ, the first: " + first.str();
}

}  // namespace

std::string difference(const image::Frame& a, const image::Frame& b) {
    if (a.width != b.width || a.height != b.height || a.pixels.index() != b.pixels.index())
        return "sizes or kinds differ";
    if (const auto* const floats = std::get_if<image::Floats>(&a.pixels))
        return differenceOf(a, *floats, std::get<image::Floats>(b.pixels));
    return differenceOf(a, std::get<image::Bytes>(a.pixels), std::get<image::Bytes>(b.pixels));
}

std::string difference(const Frames& a, const Frames& b) {
    const std::string floats = difference(a.floats, b.floats);
    const std::string codes = difference(a.codes, b.codes);
    return (floats.empty() ? "" : "floats: " + floats + "\n") + (codes.empty() ? "" : "codes: " + codes);
}

void makeReady(THREE::Scene& scene, THREE::PerspectiveCamera& camera, const DrawOptions& options) {
    camera.aspect = static_cast<double>(options.width) / options.height;
    scene.updateMatrixWorld();
    camera.updateWorldMatrix();
    THREE::validate(scene, camera);
}

Frames drawFrames(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera,
                  const DrawOptions& options) {
    return drawFrames(lighting::planFrame(scene, camera, options.settings), options);
}

Frames drawFrames(lighting::FramePlan plan, const DrawOptions& options, render::GlRenderer& with) {
    Frames out;
    out.plan = std::move(plan);
    out.codes = with.render(out.plan, options.settings, {options.width, options.height, false});
    out.floats = with.render(out.plan, options.settings, {options.width, options.height, true});
    out.stats = with.stats();
    return out;
}

bool BothWays::tells(const THREE::Object3D& object, const std::string& why) const {
    return std::any_of(skipped.plan.skipped.begin(), skipped.plan.skipped.end(), [&](const auto& s) {
        return s.object == &object && (s.share + s.why.en).find(why) != std::string::npos;
    });
}

lighting::FramePlan withFacesAndOrderOf(const lighting::FramePlan& skipped, lighting::FramePlan whole) {
    const auto place = [&skipped](const lighting::Draw& draw) {
        return std::find_if(skipped.draws.begin(), skipped.draws.end(),
                            [&draw](const lighting::Draw& other) { return other.mesh == draw.mesh; });
    };
    for (lighting::Draw& draw : whole.draws)
        if (const auto other = place(draw); other != skipped.draws.end()) {
            draw.side = other->side;
            draw.variant.doubleSided = other->variant.doubleSided;
        }
    std::stable_sort(
        whole.draws.begin(), whole.draws.end(),
        [&place](const lighting::Draw& a, const lighting::Draw& b) { return place(a) < place(b); });
    return whole;
}

std::unique_ptr<render::GlRenderer> freshRenderer() {
    renderer();  // makes the context
    return std::make_unique<render::GlRenderer>(render::findShaderDirectory(""));
}

int differingPixels(const image::Frame& a, const image::Frame& b) {
    const std::string text = difference(a, b);
    return text.empty() ? 0 : std::stoi(text);
}

BothWays drawBothWays(THREE::Scene& scene, THREE::PerspectiveCamera& camera, const DrawOptions& options) {
    makeReady(scene, camera, options);
    DrawOptions other = options;
    other.settings.skip = true;
    BothWays both{drawFrames(scene, camera, other), {}};
    other.settings.skip = false;
    both.whole = drawFrames(scene, camera, other);
    if (both.skipped.plan.sidesSkipped == 0) {
        EXPECT_EQ(difference(both.skipped, both.whole), "");
        return both;
    }
    const Frames oneSided = drawFrames(withFacesAndOrderOf(both.skipped.plan, both.whole.plan), other);
    EXPECT_EQ(difference(both.skipped, oneSided), "");
    EXPECT_LE(differingPixels(both.skipped.floats, both.whole.floats), mostBeyondSilhouettes);
    return both;
}

}  // namespace support
