// Deliberately other equations, small, evaluated in support/glsl.hpp's strict float so that NaN shows as NaN.
// SPDX-License-Identifier: MIT
#include "stability/peers.hpp"

#include "stability/rows.hpp"
#include "support/glsl.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <utility>

namespace stability {

namespace {

namespace glsl = support::glsl;
using glsl::dot;
using glsl::Float;
using glsl::vec3;

vec3 in(const glm::dvec3& v) { return {Float(v.x), Float(v.y), Float(v.z)}; }
glm::vec3 out(const vec3& v) { return {v.x.value(), v.y.value(), v.z.value()}; }

Float length(vec3 v) { return sqrt(dot(v, v)); }
vec3 normalize(vec3 v) { return v * (Float(1) / length(v)); }
Float saturate(Float x) { return clamp(x, 0, 1); }
Float pow2(Float x) { return x * x; }
Float pow4(Float x) { return x * x * x * x; }

// The attenuation that three.js had by default until r154.
Float legacyFalloff(Float d, Float distance, Float decay) {
    return distance > 0 && decay > 0 ? pow(saturate(-d / distance + 1), decay) : Float(1);
}

Float physicalFalloff(Float d, Float distance, Float decay) {
    Float falloff = Float(1) / max(pow(d, decay), 0.01);
    if (distance > 0)
        falloff *= pow2(saturate(Float(1) - pow4(d / distance)));
    return falloff;
}

Float naiveFalloff(Float d, Float distance, Float decay) {
    const Float window = distance > 0 ? pow2(saturate(Float(1) - pow4(d / distance))) : Float(1);
    return Float(1) / pow(d, decay) * window;
}

glm::dvec3 turned(const Setup& setup, const glm::dvec3& v) { return glm::dquat(setup.turn) * v; }

// Highlights by the book: R whatever n . w is, and three.js's, which asks.
vec3 highlight(const Gloss& gloss, vec3 n, vec3 w, vec3 v) {
    const vec3 K = in(gloss.specular);
    const Float s = gloss.shininess;
    if (gloss.model == THREE::SpecularModel::phong)
        return K * pow(max(dot(n * (Float(2) * dot(n, w)) - w, v), 0), s);
    const vec3 h = normalize(w + v);
    const Float vh = saturate(dot(v, h)), grazing = exp2((Float(-5.55473) * vh - 6.98316) * vh);
    const Float lobe = Float(0.25) * (s * 0.5 + 1) * pow(saturate(dot(n, h)), s);
    return (K * (Float(1) - grazing) + vec3(grazing)) * (saturate(dot(n, w)) * lobe);
}

// The sum over the lights, for a unit normal (or what should be one) at a point. Only `falloff` differs.
template <class Falloff>
glm::vec3 sum(const Setup& setup, const glm::dvec3& point, vec3 n, const Falloff& falloff) {
    const vec3 D = in(setup.albedo), Q = in(point);
    const vec3 v = normalize(in(setup.centre + turned(setup, setup.eye * setup.size)) - Q);
    vec3 P = D * Float(setup.ambient);
    for (const Lamp& lamp : setup.lamps) {
        const vec3 L = in(lamp.color * lamp.intensity);
        const vec3 l = lamp.kind == Lamp::sun ? in(lamp.place) : in(setup.centre + lamp.place) - Q;
        const vec3 w = normalize(l);
        const Float f = lamp.kind == Lamp::sun ? Float(1) : falloff(length(l), lamp.distance, lamp.decay);
        P = P + saturate(dot(n, w)) * f * D * L;
        if (setup.gloss)
            P = P + highlight(*setup.gloss, n, w, v) * f * L;
    }
    return out(P);
}

// The attribute as the rasteriser interpolates it halfway between two opposite corners.
vec3 middle(const vec3& a, const vec3& b) { return a * Float(0.5) + b * Float(0.5); }

vec3 cross(vec3 a, vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

// A corner of the plane as its vertex buffer holds it.
glm::dvec3 corner(const Setup& setup, double x, double y) {
    const glm::dvec3 own(3 * setup.size * x, 3 * setup.size * y, 0);
    const glm::vec3 held(setup.placeInVertices ? turned(setup, own) + setup.centre : own);
    return held;
}

// The two edges of a triangle that span its normal.
std::pair<glm::dvec3, glm::dvec3> edges(const Setup& setup) {
    const glm::dvec3 a = corner(setup, -1, 1);
    return {corner(setup, -1, -1) - a, corner(setup, 1, 1) - a};
}

vec3 intoWorld(const Setup& setup, const glm::dvec3& n) {
    return in(setup.generatedNormals && setup.placeInVertices ? n : turned(setup, n));
}

vec3 naiveVertex(const Setup& setup, std::size_t vertex) {
    if (!setup.generatedNormals)
        return intoWorld(setup, setup.normals[vertex]);
    const auto [e, f] = edges(setup);
    return intoWorld(setup, glm::dvec3(out(normalize(cross(in(e), in(f))))));
}

// three.js's computeVertexNormals, in double; what has no length stays zero.
vec3 threeVertex(const Setup& setup, std::size_t vertex) {
    glm::dvec3 n = setup.normals[vertex];
    if (setup.generatedNormals) {
        const auto [e, f] = edges(setup);
        n = glm::cross(e, f);
        n /= glm::length(n) > 0 ? glm::length(n) : 1.0;
    }
    return normalize(intoWorld(setup, n));
}

vec3 threeMiddle(const Setup& setup) {
    return normalize(middle(threeVertex(setup, 1), threeVertex(setup, 2)));
}

struct Matrix {
    vec3 a, b, c;  // columns
};

}  // namespace

glm::vec3 naiveGlsl(const Setup& setup) {
    if (!setup.perVertex)
        return sum(setup, setup.centre, normalize(middle(naiveVertex(setup, 1), naiveVertex(setup, 2))),
                   naiveFalloff);
    const auto at = [&](std::size_t vertex, double sign) {
        const glm::dvec3 place = setup.centre + turned(setup, corner(setup, sign, sign));
        return sum(setup, place, normalize(naiveVertex(setup, vertex)), naiveFalloff);
    };
    return 0.5F * at(1, 1) + 0.5F * at(2, -1);
}
glm::vec3 threeLegacy(const Setup& setup) {
    return sum(setup, setup.centre, threeMiddle(setup), legacyFalloff);
}
glm::vec3 threePhysical(const Setup& setup) {
    return sum(setup, setup.centre, threeMiddle(setup), physicalFalloff);
}

glm::vec3 naiveNormal(const glm::dmat4& model, const glm::dvec3& normal) {
    const vec3 a = in(model[0]), b = in(model[1]), c = in(model[2]), n = in(normal);
    const Float determinant = dot(a, cross(b, c));
    // the inverse's rows are the cofactors' columns over the determinant; transposed, they are columns again
    const Matrix m{cross(b, c) / determinant, cross(c, a) / determinant, cross(a, b) / determinant};
    return out(normalize(m.a * n.x + m.b * n.y + m.c * n.z));
}

glm::vec3 threeNormal(const glm::dmat4& model, const glm::dvec3& normal) {
    const glm::dmat3 linear(model);
    const double determinant = glm::determinant(linear);
    const glm::dmat3 matrix = determinant == 0 ? glm::dmat3(0) : glm::transpose(glm::inverse(linear));
    const vec3 n = in(normal);
    return out(normalize(in(matrix[0]) * n.x + in(matrix[1]) * n.y + in(matrix[2]) * n.z));
}

glm::vec3 naiveTriangleNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    return out(normalize(cross(in(b)-in(a), in(c)-in(a))));
}

double naiveSpunLength(int turns, double step) {
    const Float c(std::cos(step)), s(std::sin(step));
    Float x(1), y(0);  // the first column; the third stays
    for (int i = 0; i < turns; ++i) {
        const Float turned = c * x - s * y;
        y = s * x + c * y;
        x = turned;
    }
    return sqrt(x * x + y * y).value();
}

float mediump(double d, double L) {
    const float d2 = half(half(static_cast<float>(d)) * half(static_cast<float>(d)));
    const float cosine = half(half(static_cast<float>(d)) / half(std::sqrt(d2)));
    return half(half(static_cast<float>(A)) +
                half(half(half(cosine) * half(1 / d2)) * half(static_cast<float>(L))));
}

float halfTruncated(float x) {
    if (!(std::abs(x) < 65536))
        return std::copysign(std::isnan(x) ? x : 65504.0F, x);
    const float step = std::ldexp(1.0F, std::max(std::ilogb(x == 0 ? 1 : x), -14) - 10);
    return std::trunc(x / step) * step;
}

float half(float x) {
    const float step = std::ldexp(1.0F, std::max(std::ilogb(x == 0 ? 1 : x), -14) - 10);
    const float rounded = std::nearbyint(x / step) * step;
    return std::abs(rounded) > 65504 ? std::copysign(INFINITY, x) : rounded;
}

void askPeers(const Setup& setup, double expected, Outcome& outcome) {
    const auto ask = [&](const glm::vec3& found) {
        const double value = found[setup.channel];
        // Where the scene is refused there is no right number: one that came out finite was accepted in silence.
        return std::isnan(expected) && std::isfinite(value) ? Peer{number(value), Peer::wrong}
                                                            : peer(value, expected);
    };
    outcome.naive = ask(naiveGlsl(setup));
    // three.js knows no R, and nothing per vertex since 2022.
    if (setup.perVertex || (setup.gloss && setup.gloss->model == THREE::SpecularModel::phong))
        return;
    outcome.legacy = ask(threeLegacy(setup));
    outcome.physical = ask(threePhysical(setup));
}

}  // namespace stability
