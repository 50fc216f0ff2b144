// The equation right in other words (R): what must never be punished.
// SPDX-License-Identifier: MIT
#include "grader/catalogue/misconception_rows.hpp"

namespace grader::rows {

namespace {

dvec3 saturatedAtTheEnd(const WrongInput& p) { return glm::min(equation(p), 1.0); }

dvec3 saturatedPerLamp(const WrongInput& p) {
    return sum(p, [&](const Lamp& lamp) { return glm::min(addend(p, lamp), 1.0); }) + rest(p);
}

dvec3 lampsInReverse(const WrongInput& p) {
    dvec3 P = rest(p);
    for (std::size_t i = p.lamps.size(); i-- > 0;)
        P += addend(p, p.lamps[i]);
    return P;
}

dvec3 normalisedByHand(const WrongInput& p) {
    const auto addition = [&](const Lamp& lamp) {
        const dvec3 to = lamp.point ? lamp.position - p.Q : lamp.towards;
        const dvec3 direction = to / std::sqrt(glm::dot(to, to));
        const double c = glm::dot(p.n, direction);
        return addend(p, lamp, c > 0 ? c : 0, highlight(p, direction));
    };
    return sum(p, addition) + rest(p);
}

dvec3 channelByChannel(const WrongInput& p) {
    double P[3];
    for (int i = 0; i < 3; ++i) {
        P[i] = p.D[i] * p.ambient[i] + p.emitted[i];
        for (const Lamp& lamp : p.lamps) {
            const double L = lamp.color[i] * lamp.intensity * attenuation(p, lamp);
            P[i] += p.D[i] * L * cosine(p, lamp) + highlight(p, lamp)[i] * L;
        }
    }
    return {P[0], P[1], P[2]};
}

dvec3 constantInL(const WrongInput& p) {
    WrongInput q = matte(p);
    for (Lamp& lamp : q.lamps)
        lamp.color = lamp.L() * p.D, lamp.intensity = 1;
    q.ambient *= p.D;
    q.D = dvec3(1);
    return equation(q) + highlights(p);
}

dvec3 inViewSpace(const WrongInput& p) { return inSpace(p.view, p); }

dvec3 faceWhereFlat(const WrongInput& p) {
    const bool flat = p.normals[0] == p.normals[1] && p.normals[1] == p.normals[2];
    return withNormal(p, flat ? faceNormal(p) : p.n);
}

dvec3 maxOnceMore(const WrongInput& p) {
    const auto addition = [&](const Lamp& lamp) { return glm::max(addend(p, lamp), 0.0); };
    return glm::max(sum(p, addition), 0.0) + rest(p);
}

// GLSL's
dvec3 reflect(const dvec3& in, const dvec3& n) { return in - 2 * glm::dot(n, in) * n; }

dvec3 reflectOfMinusW(const WrongInput& p) {
    return withHighlight(p, [&](const Lamp& lamp) {
        const dvec3 R = reflect(-w(p, lamp), p.n);
        return cosine(p, lamp) > 0 ? p.specular * power(glm::dot(R, v(p)), p.shininess) : dvec3(0);
    });
}

dvec3 vMirroredForW(const WrongInput& p) {
    return withHighlight(p, [&](const Lamp& lamp) {
        const double c = glm::dot(reflect(-v(p), p.n), w(p, lamp));
        return cosine(p, lamp) > 0 ? p.specular * power(c, p.shininess) : dvec3(0);
    });
}

dvec3 oneIfForBoth(const WrongInput& p) {
    dvec3 P = rest(p);
    for (const Lamp& lamp : p.lamps) {
        const double c = glm::dot(p.n, w(p, lamp));
        if (c <= 0)
            continue;
        const double x = std::max(glm::dot(mirrored(p.n, w(p, lamp)), v(p)), 1e-12);
        P += addend(p, lamp, c, p.specular * std::exp(p.shininess * std::log(x)));
    }
    return P;
}

}  // namespace

std::vector<Misconception> rightRows() {
    return {
        {"R1", "min(1, P) at the end", 2, saturatedAtTheEnd, true},
        {"R2", "min(1, .) on each lamp", 2, saturatedPerLamp, true},
        {"R3", "lamps in another order", 2, lampsInReverse, true},
        {"R4", "v / sqrt(v . v) for normalize(v)", 2, normalisedByHand, true},
        {"R5", "red, green and blue each for itself", 2, channelByChannel, true},
        {"R6", "D folded into the lights' colours", 2, constantInL, true},
        {"R7", "view space for world space", 2, inViewSpace, true},
        {"R8", "the triangle's normal where the mesh is flat", 2, faceWhereFlat, true},
        {"R9", "max(0, .) once more on each lamp and on their sum", 2, maxOnceMore, true},
        {"R10", "reflect(-w, n) for R", 9, reflectOfMinusW, true},
        {"R11", "v mirrored instead of w", 9, vMirroredForW, true},
        {"R12", "one if for cosine and highlight, exp(s ln x) for x^s", 9, oneIfForBoth, true},
    };
}

}  // namespace grader::rows
