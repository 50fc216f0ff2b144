// Compares pixel by pixel.
// SPDX-License-Identifier: MIT
#include "support/judge.hpp"

#include "lighting/reference/reference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace support {

namespace {

using lighting::reference::Reference;
using lighting::reference::Vec3;

std::vector<double> pixels(const Reference<double>& reference) {
    std::vector<double> out(static_cast<std::size_t>(reference.width() * reference.height() * 3));
    reference.draw([&](int x, int y, const Vec3<double>& P) {
        constexpr double largest = std::numeric_limits<float>::max();
        for (int channel = 0; channel < 3; ++channel)
            out[static_cast<std::size_t>((y * reference.width() + x) * 3 + channel)] =
                std::clamp(P[channel], -largest, largest);
    });
    return out;
}

}  // namespace

void lookAt(THREE::PerspectiveCamera& camera, const THREE::Vector3& target, DrawOptions& options) {
    camera.lookAt(target);
    options.settings.focus = target;
    options.settings.focusDistance = THREE::Vector3(camera.position).sub(target).length();
}

Judgement judge(THREE::Scene& scene, THREE::PerspectiveCamera& camera, const DrawOptions& options) {
    DrawOptions codes = options;
    codes.floats = false;
    const Drawn drawn = draw(scene, camera, options);
    const Drawn drawnCodes = draw(scene, camera, codes);
    const auto& bytes = std::get<image::Bytes>(drawnCodes.frame.pixels);

    const lighting::Switches& switches = options.settings;
    lighting::Switches cosinesOne = switches;
    cosinesOne.terms = switches.terms.without(lighting::Term::cosine);
    const Reference<double> reference(scene, camera, switches, options.width, options.height);
    const Reference<double> strength(scene, camera, cosinesOne, options.width, options.height);
    const std::vector<double> truth = pixels(reference);
    const std::vector<double> strengths = pixels(strength);
    const std::vector<std::uint8_t> edges = reference.edges();
    image::Frame truthFrame{options.width, options.height, image::Floats(truth.begin(), truth.end())};
    const image::Bytes truthBytes = image::toBytes(truthFrame);

    Judgement result;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const int difference = std::abs(bytes[i] - truthBytes[i]);
        if (edges[i / 3] != 0) {
            result.masked += i % 3 == 0 ? 1 : 0;
            result.outside += difference > 1 ? 1 : 0;
            continue;
        }
        result.judged += i % 3 == 0 ? 1 : 0;
        const double error =
            std::abs(static_cast<double>(drawn.floats()[i]) - truth[i]) / std::max(strengths[i], 1 / 255.0);
        result.mean += error;
        result.codes = std::max(result.codes, difference);
        if (error > result.worst) {
            result.worst = error;
            result.x = static_cast<int>(i / 3) % options.width;
            result.y = static_cast<int>(i / 3) / options.width;
        }
    }
    result.mean /= static_cast<double>(std::max(result.judged * 3, 1LL));
    return result;
}

std::string describe(const Judgement& j) {
    std::ostringstream out;
    out.precision(3);
    out << "worst " << j.worst << " at " << j.x << ',' << j.y << ", mean " << j.mean << ", 8 bit " << j.codes
        << (j.codes == 1 ? " code, " : " codes, ") << 100 * j.maskedShare() << " % masked, of which "
        << j.outside << " values more than 1 code off";
    return out.str();
}

}  // namespace support
