// Misconceptions about Phong's highlight (H): K_S max(0, R . v)^s f(d) (x) L for each lamp with n . w > 0.
// SPDX-License-Identifier: MIT
#include "grader/catalogue/misconception_rows.hpp"

namespace grader::rows {

namespace {

double mirroredTowardsEye(const WrongInput& p, const Lamp& lamp) {
    return glm::dot(mirrored(p.n, w(p, lamp)), v(p));
}

// The right equation with K_S x^s for the highlight where n . w > 0, x = base(lamp).
template <class Base>
dvec3 withBase(const WrongInput& p, const Base& base) {
    return withHighlight(p, [&](const Lamp& lamp) {
        return cosine(p, lamp) > 0 ? p.specular * power(base(lamp), p.shininess) : dvec3(0);
    });
}

// The right equation with other material and lamps in the highlight only.
dvec3 withShineOf(const WrongInput& shiny, const WrongInput& p) {
    return equation(matte(p)) + highlights(shiny);
}

// R and the condition

dvec3 reflectWithoutMinus(const WrongInput& p) {
    return withBase(p, [&](const Lamp& lamp) { return -mirroredTowardsEye(p, lamp); });
}

dvec3 alsoWhereUnlit(const WrongInput& p) {
    return withHighlight(
        p, [&](const Lamp& lamp) { return p.specular * power(mirroredTowardsEye(p, lamp), p.shininess); });
}

dvec3 negativeBase(const WrongInput& p) {
    return withBase(p, [&](const Lamp& lamp) { return std::abs(mirroredTowardsEye(p, lamp)); });
}

dvec3 exponentZero(const WrongInput& p) {
    WrongInput q = p;
    q.shininess = 0;
    return equation(q);
}

dvec3 halfVector(const WrongInput& p) {
    return withBase(p, [&](const Lamp& lamp) { return glm::dot(p.n, unit(w(p, lamp) + v(p))); });
}

dvec3 normalForR(const WrongInput& p) {
    return withBase(p, [&](const Lamp&) { return glm::dot(p.n, v(p)); });
}

// v

// The right equation with v in the place of the unit vector towards the eye.
dvec3 withV(const WrongInput& p, const dvec3& v) {
    return withBase(p, [&](const Lamp& lamp) { return glm::dot(mirrored(p.n, w(p, lamp)), v); });
}

dvec3 vNotNormalised(const WrongInput& p) { return withV(p, p.eye - p.Q); }

dvec3 wForV(const WrongInput& p) {
    return withBase(p, [&](const Lamp& lamp) { return glm::dot(mirrored(p.n, w(p, lamp)), w(p, lamp)); });
}

dvec3 constantV(const WrongInput& p) { return withV(p, p.cameraAxis()); }

dvec3 eyeAtTheOrigin(const WrongInput& p) { return withV(p, unit(-p.Q)); }

// K_S, s, and the factors around

dvec3 specularForgotten(const WrongInput& p) {
    WrongInput q = p;
    q.specular = dvec3(p.shines() ? 1 : 0);
    return withShineOf(q, p);
}

dvec3 shineTimesD(const WrongInput& p) {
    WrongInput q = p;
    q.specular *= p.D;
    return withShineOf(q, p);
}

dvec3 shineTimesCosine(const WrongInput& p) {
    return withHighlight(p, [&](const Lamp& lamp) { return cosine(p, lamp) * highlight(p, lamp); });
}

dvec3 shineNotAttenuated(const WrongInput& p) {
    return equation(matte(p)) + sum(p, [&](const Lamp& lamp) { return highlight(p, lamp) * lamp.L(); });
}

dvec3 shineWithoutL(const WrongInput& p) {
    WrongInput q = p;
    for (Lamp& lamp : q.lamps)
        lamp.color = dvec3(1), lamp.intensity = 1;
    return withShineOf(q, p);
}

dvec3 defaultExponent(const WrongInput& p) {
    WrongInput q = p;
    q.shininess = 30;
    return equation(q);
}

}  // namespace

std::vector<Misconception> highlightRows() {
    return {
        {"H1", "reflect(w, n) for R: it points into the surface", 9, reflectWithoutMinus},
        {"H2", "highlight on the unlit side, too", 9, alsoWhereUnlit},
        {"H3", "negative R . v to an even power", 9, negativeBase},
        {"H3Z", "exponent left at 0", 9, exponentZero},
        {"H4", "v not normalised", 9, vNotNormalised},
        {"H4W", "w in the place of v", 9, wForV},
        {"H5", "half vector with Phong's exponent", 9, halfVector},
        {"H6", "K_S forgotten", 9, specularForgotten},
        {"H7", "highlight times D", 9, shineTimesD},
        {"H8", "highlight times n . w", 9, shineTimesCosine},
        {"H9", "highlight not attenuated", 9, shineNotAttenuated},
        {"H10", "L forgotten in the highlight", 9, shineWithoutL},
        {"H11", "the camera's axis for v", 9, constantV},
        {"H12", "v as if the eye were at the origin", 9, eyeAtTheOrigin},
        {"H13", "n . v for R . v", 9, normalForR},
        {"H14", "exponent left at three.js's 30", 9, defaultExponent},
    };
}

}  // namespace grader::rows
