// Reads positions and normals from the driver by shaders of its own, and evaluates the equation there.
// SPDX-License-Identifier: MIT
#include "support/shading.hpp"

#include "lighting/reference/equation.hpp"
#include "render/gl_renderer.hpp"
#include "render/shader_source.hpp"
#include "support/program.hpp"

#include <gtest/gtest.h>
#include <map>

namespace support {

namespace {

using Real = long double;
using lighting::reference::Equation;
using Vec = lighting::reference::Vec3<Real>;

// A renderer whose fragments are what `expression` says instead of the lighting; one for each expression.
render::GlRenderer& instead(const std::string& expression) {
    struct Instead {
        TemporaryDirectory directory;
        std::unique_ptr<render::GlRenderer> renderer;
    };
    static std::map<std::string, Instead> all;
    Instead& one = all[expression];
    if (!one.renderer) {
        const std::filesystem::path from = render::findShaderDirectory("");
        std::filesystem::copy(from, one.directory.path(),
                              std::filesystem::copy_options::recursive |
                                  std::filesystem::copy_options::overwrite_existing);
        std::string text = readFile(from / "mesh.frag");
        const std::size_t begin = text.find("write_pixel(");
        const std::size_t end = text.find(";\n", begin);
        EXPECT_NE(begin, std::string::npos);
        writeFile(one.directory.path() / "mesh.frag",
                  text.replace(begin, end - begin, "write_pixel(" + expression + ")"));
        one.renderer = std::make_unique<render::GlRenderer>(one.directory.path().string());
    }
    return *one.renderer;
}

Vec rounded(const glm::dvec3& v) { return Vec(glm::vec3(v)); }

// The lights of the plan as the GPU has them.
Equation<Real> equationOf(const lighting::FramePlan& plan, const lighting::TermSet& terms) {
    Equation<Real> equation;
    equation.terms = terms;
    for (const lighting::DirectionalAddend& light : plan.directional)
        equation.directionalLights.push_back(
            {nullptr, rounded(light.w), rounded(light.color), static_cast<float>(light.intensity), 0, 0});
    for (const lighting::PointAddend& light : plan.point) {
        const Real scale = std::exp2(static_cast<Real>(light.exponent));
        equation.pointLights.push_back({nullptr, rounded(light.position), rounded(light.color) * scale,
                                        static_cast<float>(light.intensity) * scale,
                                        static_cast<float>(light.decay), 0});
    }
    equation.ambientLight = rounded(plan.ambient);
    return equation;
}

}  // namespace

ShadingError shadingError(THREE::Scene& scene, THREE::PerspectiveCamera& camera, const DrawOptions& options) {
    const Drawn drawn = draw(scene, camera, options);
    const auto values = [&](const std::string& expression) {
        const image::Frame frame =
            instead(expression).render(drawn.plan, options.settings, {options.width, options.height, true});
        return std::get<image::Floats>(frame.pixels);
    };
    const image::Floats positions = values("worldPosition"), normals = values("worldNormal"),
                        colors = values("baseColor");
    const lighting::TermSet terms = options.settings.terms;
    const Equation<Real> equation = equationOf(drawn.plan, terms);
    const Equation<Real> strength = equationOf(drawn.plan, terms.without(lighting::Term::cosine));
    bool others = false;
    for (const lighting::PointAddend& light : drawn.plan.point)
        others |= light.decay != 0 && light.decay != 1 && light.decay != 2;

    ShadingError result;
    result.bound =
        (others ? 44 : 18) + static_cast<double>(drawn.plan.directional.size() + drawn.plan.point.size());
    for (std::size_t i = 0; i < normals.size(); i += 3) {
        const auto vector = [i](const image::Floats& f) { return Vec(f[i], f[i + 1], f[i + 2]); };
        const Vec normal = vector(normals);
        if (normal == Vec(0))
            continue;
        const Vec n = normal / std::sqrt(glm::dot(normal, normal));
        const Vec truth = equation.lighting(n, vector(positions), vector(colors));
        const Vec S = strength.lighting(n, vector(positions), vector(colors));
        ++result.pixels;
        for (int channel = 0; channel < 3; ++channel) {
            const Real error =
                std::abs(drawn.floats()[i + static_cast<std::size_t>(channel)] - truth[channel]);
            // Half of the smallest float is always allowed.
            const auto ratio = static_cast<double>(error / (S[channel] * u + 0x1p-150L));
            if (!(ratio <= result.worst)) {
                result.worst = ratio;
                result.x = static_cast<int>(i / 3) % options.width;
                result.y = static_cast<int>(i / 3) / options.width;
            }
        }
    }
    return result;
}

}  // namespace support
