// Compiles the files of shaders/ as C++: a stage becomes a class, its uniforms, inputs and outputs are members.
// SPDX-License-Identifier: MIT
#include "support/strict_glsl.hpp"

#include "support/glsl.hpp"
#include "three/vector3.hpp"

#include <algorithm>
#include <glm/mat3x3.hpp>
#include <glm/mat4x3.hpp>
#include <glm/mat4x4.hpp>
#include <limits>

namespace support {

namespace glsl {

namespace {

// In a shader these counts are constants of its variant; here they are variables, so that one class does for all scenes.
struct VariantConstants {
    int NUM_DIRECTIONAL_LIGHTS = 0, NUM_POINT_LIGHTS = 0;
    int END_DECAY_0 = 0, END_DECAY_1 = 0, END_DECAY_2 = 0;
    bool BLINN = false;
    int VIEW = 0;
};
struct VertexBuiltins : VariantConstants {
    vec4 gl_Position;
};
struct FragmentBuiltins : VariantConstants {
    bool gl_FrontFacing = true;
    vec4 gl_FragCoord;
};

// What makes GLSL valid C++, for the includes below only.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"  // a term that is off uses none
#ifdef __clang__
#pragma GCC diagnostic ignored "-Wkeyword-macro"
#endif
#define float Float
#define layout(where)
#define uniform
#define in
#define out
#define inout by_reference::
#define highp
#define invariant friend struct  // a name again, which here says nothing
#define discard return
#define xyz xyz()
#define rgb rgb()

#define DOUBLE_SIDED 1
#define COUNT_NONFINITE 1
#define SHOW_CHANNEL 0
#define MARK_OVEREXPOSED 0
#define WINDOW 1
#define LIGHTS_IN_TEXTURE 1
#define CLUSTERED 0
#define EMISSIVE 1
#define AMBIENT_IS_CONSTANT 0
#define TERM_ALBEDO 1
#define TERM_COSINE 1
#define TERM_CLAMP 1
#define TERM_LIGHT_COLOR 1
#define TERM_ATTENUATION 1
#define TERM_DIRECTIONAL 1
#define TERM_POINT 1
#define TERM_AMBIENT 1
#define TERM_SPECULAR 1

#define VERTEX_SHADER
struct MeshVertex : VertexBuiltins {
#include "../../shaders/mesh.vert"
};
#define SCALED 0
struct PlainGouraudVertex : VertexBuiltins {
#include "../../shaders/gouraud.vert"
};
#undef SCALED
#define SCALED 1
struct ScaledGouraudVertex : VertexBuiltins {
#include "../../shaders/gouraud.vert"
};
#undef SCALED
#undef VERTEX_SHADER

#define FRAGMENT_SHADER
#define SCALED 0
struct PlainFragment : FragmentBuiltins {
#include "../../shaders/mesh.frag"
};
struct PlainGouraudFragment : FragmentBuiltins {
#include "../../shaders/gouraud.frag"
};
#undef SCALED
#define SCALED 1
struct ScaledFragment : FragmentBuiltins {
#include "../../shaders/mesh.frag"
};
struct ScaledGouraudFragment : FragmentBuiltins {
#include "../../shaders/gouraud.frag"
};

#undef SCALED

#define VIEW_ALBEDO 1
#define VIEW_COSINE 2
#define VIEW_CLAMP 3
#define VIEW_LIGHT_COLOR 4
#define VIEW_ATTENUATION 5
#define VIEW_NORMALS 13
#define VIEW_W 14
#define VIEW_BANDS 15
#define SCALED 0
struct PlainView : FragmentBuiltins {
#include "../../shaders/view.frag"
};
#undef SCALED
#define SCALED 1
struct ScaledView : FragmentBuiltins {
#include "../../shaders/view.frag"
};
#undef SHOW_CHANNEL
#undef MARK_OVEREXPOSED
#define SHOW_CHANNEL 2
struct GreenFragment : FragmentBuiltins {
#include "../../shaders/unlit.frag"
};
#undef SHOW_CHANNEL
#define SHOW_CHANNEL 0
#define MARK_OVEREXPOSED 1
struct OverexposedFragment : FragmentBuiltins {
#include "../../shaders/unlit.frag"
};

#undef float
#undef layout
#undef uniform
#undef in
#undef out
#undef inout
#undef highp
#undef invariant
#undef discard
#undef xyz
#undef rgb
#pragma GCC diagnostic pop

// Into GLSL's types and back.
vec3 in3(const glm::vec3& v) { return {v.x, v.y, v.z}; }
vec4 in4(const glm::vec4& v) { return {v.x, v.y, v.z, v.w}; }
glm::vec3 out3(const vec3& v) { return {v.x.value(), v.y.value(), v.z.value()}; }
glm::vec4 out4(const vec4& v) { return {v.x.value(), v.y.value(), v.z.value(), v.w.value()}; }

// As render/gpu_lights.cpp rounds and packs lights. NaN stays NaN.
Float saturated(double x) {
    constexpr double largest = std::numeric_limits<float>::max();
    return std::clamp(x, -largest, largest);
}
vec4 saturated(const glm::dvec3& v, double w) {
    return {saturated(v.x), saturated(v.y), saturated(v.z), saturated(w)};
}

sampler2D packLights(const lighting::FramePlan& plan) {
    sampler2D data{{}, 512 * 3};
    const auto add = [&data](const vec4& geometry, const vec4& radiance, const vec4& falloff) {
        data.texels.insert(data.texels.end(), {geometry, radiance, falloff});
    };
    for (const lighting::DirectionalAddend& light : plan.directional)
        add(saturated(light.w, 0), saturated(light.color, light.intensity), vec4());
    for (const lighting::PointAddend& light : plan.point)
        add(saturated(light.position, light.distance > 0 ? 1 / light.distance : 0),
            saturated(light.color, light.intensity), saturated({light.decay, light.exponent, 0}, 0));
    return data;
}

// What every stage needs that has the equation in it.
template <class Stage>
void setLighting(Stage& stage, const lighting::FramePlan& plan, const lighting::Draw& draw) {
    stage.NUM_DIRECTIONAL_LIGHTS = draw.variant.directional;
    stage.NUM_POINT_LIGHTS = draw.variant.point();
    stage.END_DECAY_0 = draw.variant.decay0;
    stage.END_DECAY_1 = stage.END_DECAY_0 + draw.variant.decay1;
    stage.END_DECAY_2 = stage.END_DECAY_1 + draw.variant.decay2;
    stage.lightData = packLights(plan);
    stage.ambientLight = saturated(plan.ambient, 0).xyz();
    stage.baseColor = in3(glm::vec3(draw.albedo));
    stage.emissive = in3(glm::vec3(draw.emitted));
    stage.BLINN = draw.variant.blinn;
    stage.specularColor = in3(glm::vec3(draw.specular));
    stage.shininess = static_cast<float>(draw.shininess);
    stage.eyePosition = in3(glm::vec3(plan.eye));
}

template <class Stage>
void setVertex(Stage& stage, const lighting::Draw& draw, const glm::dvec3& position,
               const glm::dvec3& normal) {
    const glm::mat4 clip(draw.clip);
    const glm::mat4x3 model{glm::dmat4x3(draw.model)};
    const glm::mat3 normalMatrix(draw.normalMatrix);
    for (int i = 0; i < 4; ++i) {
        stage.modelViewProjectionMatrix.column[i] = in4(clip[i]);
        stage.modelMatrix.column[i] = in3(model[i]);
    }
    for (int i = 0; i < 3; ++i)
        stage.normalMatrix.column[i] = in3(normalMatrix[i]);
    stage.position = in3(glm::vec3(position - draw.origin));
    stage.normal = in3(glm::vec3(glm::dvec3(THREE::Vector3(normal).normalize())));
}

template <class Stage>
StrictFragment run(const lighting::FramePlan& plan, const lighting::Draw& draw, const glm::vec3& position,
                   const glm::vec3& normal, bool front) {
    Stage stage;
    stage.gl_FrontFacing = front || !draw.variant.doubleSided;
    setLighting(stage, plan, draw);
    stage.worldPosition = in3(position);
    stage.worldNormal = in3(normal);
    stage.main();
    return {out3(stage.pixel.rgb()), stage.nonfinite.r > 0};
}

template <class Stage>
StrictFragment runView(const lighting::FramePlan& plan, const lighting::Draw& draw, const glm::vec3& position,
                       const glm::vec3& normal, const glm::vec2& place) {
    Stage stage;
    stage.VIEW = static_cast<int>(draw.variant.view);
    stage.NUM_DIRECTIONAL_LIGHTS = draw.variant.directional;
    stage.NUM_POINT_LIGHTS = draw.variant.point();
    stage.lightData = packLights(plan);
    stage.lightData.texels.resize(std::max<std::size_t>(stage.lightData.texels.size(), 3));  // a uniform is 0
    stage.baseColor = in3(glm::vec3(draw.albedo));
    stage.gl_FragCoord = vec4(place.x, place.y, 0, 1);
    stage.worldPosition = in3(position);
    stage.worldNormal = in3(normal);
    stage.main();
    return {out3(stage.pixel.rgb()), stage.nonfinite.r > 0};
}

template <class Stage>
glm::vec3 runUnlit(const glm::vec3& color, const glm::vec2& place) {
    Stage stage;
    stage.gl_FragCoord = vec4(place.x, place.y, 0, 1);
    stage.baseColor = in3(color);
    stage.main();
    return out3(stage.pixel.rgb());
}

template <class Stage>
StrictGouraudVertex runGouraud(const lighting::FramePlan& plan, const lighting::Draw& draw,
                               const glm::dvec3& position, const glm::dvec3& normal) {
    Stage stage;
    setLighting(stage, plan, draw);
    setVertex(stage, draw, position, normal);
    stage.main();
    return {out4(stage.gl_Position), out3(stage.frontColor), out3(stage.backColor),
            stage.metNonfinite.value()};
}

template <class Stage>
StrictFragment runGouraud(const lighting::Draw& draw, const StrictGouraudVertex& between, bool front) {
    Stage stage;
    stage.gl_FrontFacing = front || !draw.variant.doubleSided;
    stage.frontColor = in3(between.frontColor);
    stage.backColor = in3(between.backColor);
    stage.metNonfinite = between.metNonfinite;
    stage.main();
    return {out3(stage.pixel.rgb()), stage.nonfinite.r > 0};
}

}  // namespace

}  // namespace glsl

StrictVertex strictVertex(const lighting::Draw& draw, const glm::dvec3& position, const glm::dvec3& normal) {
    glsl::MeshVertex stage;
    glsl::setVertex(stage, draw, position, normal);
    stage.main();
    return {glsl::out4(stage.gl_Position), glsl::out3(stage.worldPosition), glsl::out3(stage.worldNormal)};
}

StrictFragment strictFragment(const lighting::FramePlan& plan, const lighting::Draw& draw,
                              const glm::vec3& worldPosition, const glm::vec3& worldNormal, bool front) {
    if (!draw.variant.lit)
        return {glm::vec3(draw.albedo), false};  // unlit.frag
    return draw.variant.scaled
               ? glsl::run<glsl::ScaledFragment>(plan, draw, worldPosition, worldNormal, front)
               : glsl::run<glsl::PlainFragment>(plan, draw, worldPosition, worldNormal, front);
}

StrictFragment strictView(const lighting::FramePlan& plan, const lighting::Draw& draw,
                          const glm::vec3& worldPosition, const glm::vec3& worldNormal,
                          const glm::vec2& place) {
    return draw.variant.scaled
               ? glsl::runView<glsl::ScaledView>(plan, draw, worldPosition, worldNormal, place)
               : glsl::runView<glsl::PlainView>(plan, draw, worldPosition, worldNormal, place);
}

glm::vec3 strictGreen(const glm::vec3& P) { return glsl::runUnlit<glsl::GreenFragment>(P, {0, 0}); }

glm::vec3 strictOverexposed(const glm::vec3& P, const glm::vec2& place) {
    return glsl::runUnlit<glsl::OverexposedFragment>(P, place);
}

StrictGouraudVertex strictGouraudVertex(const lighting::FramePlan& plan, const lighting::Draw& draw,
                                        const glm::dvec3& position, const glm::dvec3& normal) {
    return draw.variant.scaled ? glsl::runGouraud<glsl::ScaledGouraudVertex>(plan, draw, position, normal)
                               : glsl::runGouraud<glsl::PlainGouraudVertex>(plan, draw, position, normal);
}

StrictFragment strictGouraudFragment(const lighting::Draw& draw, const StrictGouraudVertex& between,
                                     bool front) {
    if (!draw.variant.lit)
        return {glm::vec3(draw.albedo), false};
    return draw.variant.scaled ? glsl::runGouraud<glsl::ScaledGouraudFragment>(draw, between, front)
                               : glsl::runGouraud<glsl::PlainGouraudFragment>(draw, between, front);
}

}  // namespace support
