// Draws a scene in this process, without a window: what the frame tests look at.
// SPDX-License-Identifier: MIT
#include "support/draw.hpp"

#include "render/context.hpp"
#include "render/gl_renderer.hpp"
#include "render/shader_source.hpp"
#include "three/validate.hpp"

#include <gtest/gtest.h>

namespace support {

glm::vec3 Drawn::at(int x, int y) const {
    const auto first = static_cast<std::size_t>((y * frame.width + x) * 3);
    return {floats()[first], floats()[first + 1], floats()[first + 2]};
}

Drawn draw(THREE::Scene& scene, THREE::PerspectiveCamera& camera, const DrawOptions& options) {
    static const render::HeadlessContext context;
    static render::GlRenderer renderer(render::findShaderDirectory(""));
    camera.aspect = static_cast<double>(options.width) / options.height;
    scene.updateMatrixWorld();
    camera.updateWorldMatrix();
    THREE::validate(scene, camera);
    const render::FrameRequest request{options.width, options.height, options.floats};
    lighting::Settings settings = options.settings;
    settings.countNonfinite = true;
    renderer.render(lighting::planFrame(scene, camera, settings), settings, request);
    EXPECT_EQ(renderer.stats().nonfinite, 0) << "pixels met NaN or infinity";
    settings.countNonfinite = options.settings.countNonfinite;
    Drawn drawn;
    drawn.plan = lighting::planFrame(scene, camera, settings);
    drawn.frame = renderer.render(drawn.plan, settings, request);
    drawn.stats = renderer.stats();
    return drawn;
}

}  // namespace support
