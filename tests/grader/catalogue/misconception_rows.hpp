// What the rows of the catalogue share: the slides' equation in the pieces that students get wrong.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/catalogue/misconceptions.hpp"
#include "lighting/reference/geometry.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace grader::rows {

using glm::dmat3;
using glm::dmat4;
using glm::dvec3;
using glm::dvec4;
using lighting::reference::unit;  // the zero vector stays zero

inline dvec3 positionBy(const dmat4& m, const dvec3& v) { return dvec3(m * dvec4(v, 1)); }

/// w: the unit vector towards a lamp.
inline dvec3 w(const WrongInput& p, const Lamp& lamp) {
    return unit(lamp.point ? lamp.position - p.Q : lamp.towards);
}

/// d: the distance to a lamp.
inline double distanceTo(const WrongInput& p, const Lamp& lamp) { return glm::length(lamp.position - p.Q); }

/// three.js's window, 1 where there is none.
inline double window(const Lamp& lamp, double d) {
    if (lamp.distance <= 0)
        return 1;
    const double rest = 1 - std::pow(std::min(d / lamp.distance, 1.0), 4);
    return rest * rest;
}

/// f(d) of a lamp; 1 for a directional one.
inline double attenuation(const WrongInput& p, const Lamp& lamp) {
    const double d = distanceTo(p, lamp);
    return lamp.point ? std::pow(d, -lamp.decay) * window(lamp, d) : 1;
}

/// max(0, n . w)
inline double cosine(const WrongInput& p, const Lamp& lamp) {
    return std::max(0.0, glm::dot(p.n, w(p, lamp)));
}

/// v: the unit vector towards the eye.
inline dvec3 v(const WrongInput& p) { return unit(p.eye - p.Q); }

/// R: a vector mirrored about n.
inline dvec3 mirrored(const dvec3& n, const dvec3& w) { return 2 * glm::dot(n, w) * n - w; }

/// max(0, x)^s, up to a number that no picture can tell from infinity: what is not normalised comes to a high power.
inline double power(double x, double s) { return x > 0 ? std::min(std::pow(x, s), 1e30) : 0; }

/// The highlight of a lamp in the direction w: K_S max(0, R . v)^s where n . w > 0.
inline dvec3 highlight(const WrongInput& p, const dvec3& w) {
    return glm::dot(p.n, w) > 0 ? p.specular * power(glm::dot(mirrored(p.n, w), v(p)), p.shininess)
                                : dvec3(0);
}
inline dvec3 highlight(const WrongInput& p, const Lamp& lamp) { return highlight(p, w(p, lamp)); }

/// The sum over the lamps of what `addend` says.
template <class Addend>
dvec3 sum(const WrongInput& p, const Addend& addend) {
    dvec3 P(0);
    for (const Lamp& lamp : p.lamps)
        P += addend(lamp);
    return P;
}

/// What one lamp adds, from what stands for max(0, n . w) and for the highlight.
inline dvec3 addend(const WrongInput& p, const Lamp& lamp, double clamped, const dvec3& shine) {
    return attenuation(p, lamp) * (clamped * p.D + shine) * lamp.L();
}
inline dvec3 addend(const WrongInput& p, const Lamp& lamp) {
    return addend(p, lamp, cosine(p, lamp), highlight(p, lamp));
}

/// The sum of the slides with its highlights, without ambient.
inline dvec3 reflected(const WrongInput& p) {
    return sum(p, [&](const Lamp& lamp) { return addend(p, lamp); });
}

/// The highlights alone.
inline dvec3 highlights(const WrongInput& p) {
    return sum(p, [&](const Lamp& lamp) { return addend(p, lamp, 0, highlight(p, lamp)); });
}

/// The same point of a material that does not shine.
inline WrongInput matte(WrongInput p) {
    p.specular = dvec3(0);
    return p;
}

/// What is added whatever the lamps do.
inline dvec3 rest(const WrongInput& p) { return p.D * p.ambient + p.emitted; }

/// The whole right equation.
inline dvec3 equation(const WrongInput& p) { return reflected(p) + rest(p); }

/// The right equation but for the factor that stands for max(0, n . w).
template <class Factor>
dvec3 withCosine(const WrongInput& p, const Factor& factor) {
    return sum(p, [&](const Lamp& lamp) { return addend(p, lamp, factor(lamp), highlight(p, lamp)); }) +
           rest(p);
}

/// The right equation but for the highlight of each lamp, shine(lamp).
template <class Shine>
dvec3 withHighlight(const WrongInput& p, const Shine& shine) {
    return sum(p, [&](const Lamp& lamp) { return addend(p, lamp, cosine(p, lamp), shine(lamp)); }) + rest(p);
}

/// The right equation but for the power law of the point lights, law(lamp, d).
template <class Law>
dvec3 withAttenuation(const WrongInput& p, const Law& law) {
    return sum(p,
               [&](const Lamp& lamp) {
                   const double d = distanceTo(p, lamp);
                   const double f = lamp.point ? law(lamp, d) * window(lamp, d) : 1;
                   return f * (cosine(p, lamp) * p.D + highlight(p, lamp)) * lamp.L();
               }) +
           rest(p);
}

/// What takes normals from object space to world space, whatever their length.
inline dmat3 normalMatrix(const WrongInput& p) { return glm::transpose(glm::inverse(dmat3(p.model))); }

/// The triangle's own normal, world space, turned as the smooth one is.
inline dvec3 faceNormal(const WrongInput& p) {
    const dvec3 across = glm::cross(p.corners[1] - p.corners[0], p.corners[2] - p.corners[0]);
    return p.facing * unit(normalMatrix(p) * unit(across));
}

/// The right equation with another normal.
inline dvec3 withNormal(WrongInput p, const dvec3& n) {
    p.n = n;
    return equation(p);
}

/// The right equation with the lamps carried somewhere else by a matrix.
inline WrongInput lampsMovedBy(const dmat4& m, WrongInput p) {
    for (Lamp& lamp : p.lamps) {
        lamp.position = positionBy(m, lamp.position);
        lamp.towards = dmat3(m) * lamp.towards;
    }
    return p;
}

/// The right equation evaluated in another space, everything carried there by a matrix, normals too.
inline dvec3 inSpace(const dmat4& m, const WrongInput& p) {
    WrongInput q = lampsMovedBy(m, p);
    q.Q = positionBy(m, p.Q);
    q.eye = positionBy(m, p.eye);
    q.n = unit(dmat3(m) * p.n);
    return equation(q);
}

/// The rows by their letters.
std::vector<Misconception> lightRows();  ///< A, B, D: cosine, directions, attenuation
std::vector<Misconception> normalRows();  ///< C: normals and spaces
std::vector<Misconception> colorRows();  ///< E, F, G: ambient, colours, the sum
std::vector<Misconception> highlightRows();  ///< H: Phong's highlight
std::vector<Misconception> rightRows();  ///< R: right in other words

}  // namespace grader::rows
