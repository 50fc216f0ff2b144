// From the reference's doubles to a frame.
// SPDX-License-Identifier: MIT
#include "render/reference_renderer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace render {

namespace {

struct Stopped {};

}  // namespace

std::optional<image::Frame> drawReference(const lighting::reference::Reference<double>& reference,
                                          bool floats, const Progress& progress,
                                          const std::atomic<bool>* stop, long long* nonfinite) {
    const auto width = static_cast<std::size_t>(reference.width());
    image::Floats numbers(width * static_cast<std::size_t>(reference.height()) * 3);
    std::atomic<long long> bad = 0;
    const auto store = [&](int x, int y, const lighting::reference::Vec3<double>& P) {
        if (stop != nullptr && stop->load(std::memory_order_relaxed))
            throw Stopped();
        constexpr double largest = std::numeric_limits<float>::max();
        float* const pixel =
            &numbers[(static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)) * 3];
        for (int channel = 0; channel < 3; ++channel)
            pixel[channel] = static_cast<float>(std::clamp(P[channel], -largest, largest));
        if (!std::isfinite(P.x + P.y + P.z))
            ++bad;
    };
    try {
        reference.draw(store, progress);
    } catch (const Stopped&) {
        return std::nullopt;
    }
    if (stop != nullptr && *stop)
        return std::nullopt;
    if (nonfinite != nullptr)
        *nonfinite = bad;
    image::Frame frame{reference.width(), reference.height(), std::move(numbers)};
    if (!floats)
        frame.pixels = image::toBytes(frame);
    return frame;
}

image::Frame ReferenceRenderer::render(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera,
                                       const lighting::Settings& settings, const FrameRequest& request) {
    const lighting::reference::Reference<double> reference(scene, camera, settings, request.width,
                                                           request.height, {settings.view, settings.only});
    long long nonfinite = 0;
    image::Frame frame = *drawReference(reference, request.floats, progress_, nullptr, &nonfinite);

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
    return frame;
}

}  // namespace render
