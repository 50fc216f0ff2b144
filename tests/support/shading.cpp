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

// An expression of terms/specular.glsl; where a draw does not shine, those names are not there.
std::string ofTheHighlight(const std::string& expression) {
    return "\n#if TERM_SPECULAR\n" + expression + "\n#else\nvec3(0.0)\n#endif\n";
}

// The lights of the plan as the GPU has them, relative to the eye.
Equation<Real> equationOf(const lighting::FramePlan& plan, const lighting::TermSet& terms) {
    Equation<Real> equation;
    equation.terms = terms;
    for (const lighting::DirectionalAddend& light : plan.directional)
        equation.directionalLights.push_back({nullptr, glm::normalize(rounded(light.w)), rounded(light.color),
                                              static_cast<float>(light.intensity), 0, 0});
    for (const lighting::PointAddend& light : plan.point) {
        const Real scale = std::exp2(static_cast<Real>(light.exponent));
        equation.pointLights.push_back(
            {nullptr, rounded(light.position) - rounded(plan.eye), rounded(light.color) * scale,
             static_cast<float>(light.intensity) * scale, static_cast<float>(light.decay), 0});
    }
    equation.ambientLight = rounded(plan.ambient);
    return equation;
}

}  // namespace

Shade shade(const Equation<Real>& equation, const lighting::reference::Lit<Real>& at) {
    Equation<Real> strength = equation;
    strength.terms = equation.terms.without(lighting::Term::cosine);
    lighting::reference::Lit<Real> matt = at;
    matt.gloss = {};
    Vec S = strength.lighting(matt);
    const auto addHighlight = [&](const lighting::reference::Addend<Real>& addend) {
        if (equation.terms.has(lighting::Term::specular))
            S += addend.f * (highlightStrength(at, addend.w) * addend.L);
    };
    return {equation.lighting(at, addHighlight), S};
}

Vec highlightStrength(const lighting::reference::Lit<Real>& at, const Vec& w) {
    const Vec h = w - at.Q / std::sqrt(glm::dot(at.Q, at.Q));
    const Real length = std::sqrt(glm::dot(h, h));
    lighting::reference::Lit<Real> mirror = at;
    mirror.n = h / length;
    mirror.gloss.shininess = 0;
    const auto of = [&](Real specular) {
        mirror.gloss.specular = Vec(specular);
        return Equation<Real>::highlight(mirror, w).r;
    };
    const bool blinn = at.gloss.model == THREE::SpecularModel::blinn;
    const Real cosine = blinn ? glm::dot(mirror.n, w) : 1, lobe = blinn ? at.gloss.shininess / 2 + 1 : 1;
    return length > 0 && cosine > 0 ? (at.gloss.specular * of(1) + of(1e-4000L)) * (lobe / cosine) : Vec(0);
}

ShadingPoints shadingPoints(const lighting::FramePlan& plan, const lighting::Settings& settings, int width,
                            int height) {
    lighting::FramePlan surfaces = plan;  // of lit materials, also where the plan needs one colour only
    for (lighting::Draw& draw : surfaces.draws)
        if (!draw.variant.lit && draw.mesh->material->isLit()) {
            const THREE::Color& D = draw.mesh->material->color;
            draw.variant.lit = true;
            draw.albedo = {D.r, D.g, D.b};
        }
    const auto values = [&](const std::string& expression) {
        const image::Frame frame = instead(expression).render(surfaces, settings, {width, height, true});
        return std::get<image::Floats>(frame.pixels);
    };
    const image::Floats positions = values("worldPosition"), normals = values("worldNormal"),
                        colors = values("baseColor");
    const image::Floats specular = values(ofTheHighlight("specularColor")),
                        shininess = values(ofTheHighlight("vec3(shininess, BLINN ? 1.0 : 0.0, 0.0)"));
    const Vec eye = rounded(plan.eye);
    bool others = false;
    for (const lighting::PointAddend& light : plan.point)
        others |= light.decay != 0 && light.decay != 1 && light.decay != 2;

    ShadingPoints result;
    result.equation = equationOf(plan, settings.terms);
    result.bound = (others ? 44 : 18) + static_cast<double>(plan.directional.size() + plan.point.size());
    result.points.resize(normals.size() / 3);
    for (std::size_t i = 0; i < normals.size(); i += 3) {
        const auto vector = [i](const image::Floats& f) { return Vec(f[i], f[i + 1], f[i + 2]); };
        const Vec normal = vector(normals);
        if (normal == Vec(0))
            continue;
        const Vec n = normal / std::sqrt(glm::dot(normal, normal)), gloss = vector(shininess);
        const auto model = gloss.y > 0 ? THREE::SpecularModel::blinn : THREE::SpecularModel::phong;
        result.points[i / 3] = {
            n, vector(positions) - eye, vector(colors), {vector(specular), gloss.x, model}};
    }
    return result;
}

ShadingError shadingError(THREE::Scene& scene, THREE::PerspectiveCamera& camera, const DrawOptions& options) {
    const Drawn drawn = draw(scene, camera, options);
    const ShadingPoints at = shadingPoints(drawn.plan, options.settings, options.width, options.height);
    ShadingError result;
    result.bound = at.bound;
    for (std::size_t i = 0; i < at.points.size(); ++i) {
        if (!at.points[i])
            continue;
        const auto [truth, S] = shade(at.equation, *at.points[i]);
        ++result.pixels;
        for (int channel = 0; channel < 3; ++channel) {
            const Real error =
                std::abs(drawn.floats()[i * 3 + static_cast<std::size_t>(channel)] - truth[channel]);
            // Half of the smallest float is always allowed.
            const auto ratio = static_cast<double>(error / (S[channel] * u + 0x1p-150L));
            if (!(ratio <= result.worst)) {
                result.worst = ratio;
                result.x = static_cast<int>(i) % options.width;
                result.y = static_cast<int>(i) / options.width;
            }
        }
    }
    return result;
}

}  // namespace support
