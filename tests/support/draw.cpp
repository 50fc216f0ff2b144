// Draws a scene in this process, without a window: what the frame tests look at.
// SPDX-License-Identifier: MIT
#include "support/draw.hpp"

#include "render/context.hpp"
#include "render/shader_source.hpp"
#include "three/object_loader.hpp"
#include "three/validate.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace support {

glm::vec3 Drawn::at(int x, int y) const {
    const auto first = static_cast<std::size_t>((y * frame.width + x) * 3);
    return {floats()[first], floats()[first + 1], floats()[first + 2]};
}

double largestDifference(const Drawn& a, const Drawn& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.floats().size(); ++i)
        largest = std::max(largest, std::abs(static_cast<double>(a.floats()[i]) - b.floats()[i]));
    return largest;
}

render::GlRenderer& renderer() {
    static const render::HeadlessContext context;
    static render::GlRenderer one(render::findShaderDirectory(""));
    return one;
}

namespace {

// The same scene, written as three.js JSON and read again, must give the same bytes.
void expectSameThroughJson(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera,
                           const DrawOptions& options, const image::Frame& expected) {
    THREE::LoadedScene loaded = THREE::ObjectLoader().parse(THREE::toJSON(scene, &camera), "scene.json");
    ASSERT_NE(loaded.camera, nullptr);
    loaded.scene->updateMatrixWorld();
    THREE::validate(*loaded.scene, *loaded.camera);
    const image::Frame found = renderer().render(*loaded.scene, *loaded.camera, options.settings,
                                                 {options.width, options.height, options.floats});
    EXPECT_TRUE(found.pixels == expected.pixels) << "drawn through a scene file, the frame differs";
}

// The same plan with its lights in uniforms, not in constants of the shader, must give the same bytes.
void expectSameWithUniforms(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera,
                            const DrawOptions& options, const Drawn& drawn) {
    lighting::Settings settings = options.settings;
    settings.constantLights = 0;
    const lighting::FramePlan plan = lighting::planFrame(scene, camera, settings);
    const auto differs = [&](const lighting::Draw& draw) {
        return draw.variant.storage == lighting::LightStorage::uniforms &&
               draw.variant.directional + draw.variant.point() > 0;
    };
    if (std::none_of(plan.draws.begin(), plan.draws.end(), differs))
        return;
    const image::Frame found =
        renderer().render(plan, settings, {options.width, options.height, options.floats});
    EXPECT_TRUE(found.pixels == drawn.frame.pixels) << "drawn with lights in uniforms, the frame differs";
}

}  // namespace

Drawn draw(THREE::Scene& scene, THREE::PerspectiveCamera& camera, const DrawOptions& options) {
    camera.aspect = static_cast<double>(options.width) / options.height;
    scene.updateMatrixWorld();
    camera.updateWorldMatrix();
    THREE::validate(scene, camera);
    const render::FrameRequest request{options.width, options.height, options.floats};
    lighting::Settings settings = options.settings;
    settings.countNonfinite = true;
    renderer().render(scene, camera, settings, request);
    EXPECT_EQ(renderer().stats().nonfinite, 0) << "pixels met NaN or infinity";
    settings.countNonfinite = options.settings.countNonfinite;
    Drawn drawn;
    drawn.plan = lighting::planFrame(scene, camera, settings);
    drawn.frame = renderer().render(drawn.plan, settings, request);
    drawn.stats = renderer().stats();
    expectSameWithUniforms(scene, camera, options, drawn);
    expectSameThroughJson(scene, camera, options, drawn.frame);
    return drawn;
}

}  // namespace support
