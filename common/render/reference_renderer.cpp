// From the reference's doubles to a frame.
// SPDX-License-Identifier: MIT
#include "render/reference_renderer.hpp"

#include "lighting/reference/reference.hpp"

#include <atomic>

namespace render {

image::Frame ReferenceRenderer::render(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera,
                                       const lighting::Settings& settings, const FrameRequest& request) {
    using lighting::reference::Reference;
    using lighting::reference::Vec3;
    const Reference<double> reference(scene, camera, settings, request.width, request.height,
                                      {settings.view, settings.only});
    image::Floats floats(static_cast<std::size_t>(request.width) * static_cast<std::size_t>(request.height) *
                         3);
    std::atomic<long long> nonfinite = 0;
    const auto store = [&](int x, int y, const Vec3<double>& P) {
        constexpr double largest = std::numeric_limits<float>::max();
        float* const pixel = &floats[(static_cast<std::size_t>(y) * static_cast<std::size_t>(request.width) +
                                      static_cast<std::size_t>(x)) *
                                     3];
        for (int channel = 0; channel < 3; ++channel)
            pixel[channel] = static_cast<float>(std::clamp(P[channel], -largest, largest));
        if (!std::isfinite(P.x + P.y + P.z))
            ++nonfinite;
    };
    reference.draw(store, progress_);

    stats_ = FrameStats{};
    for (const auto& body : reference.bodies()) {
        stats_.triangles += static_cast<long long>(body.triangles());
        stats_.shiny |= body.gloss.shines();
    }
    stats_.meshesDrawn = static_cast<int>(reference.bodies().size());
    const auto& equation = reference.equation();
    stats_.lightsUsed = equation.ambientLights +
                        static_cast<int>(equation.directionalLights.size() + equation.pointLights.size());
    stats_.nonfinite = nonfinite;
    image::Frame frame{request.width, request.height, std::move(floats)};
    if (!request.floats)
        frame.pixels = image::toBytes(frame);
    return frame;
}

}  // namespace render
