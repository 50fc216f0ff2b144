// Misconceptions about normals and spaces (C), and the right ways of writing the equation (R).
// SPDX-License-Identifier: MIT
#include "support/misconception_rows.hpp"

#include <glm/matrix.hpp>

namespace support::rows {

namespace {

// C: normals and spaces

// What reaches the fragment of perCorner(object-space normal), before any normalisation there.
template <class PerCorner>
dvec3 varying(const WrongInput& p, const PerCorner& perCorner) {
    return p.facing * (perCorner(p.normals[0]) * p.weights.x + perCorner(p.normals[1]) * p.weights.y +
                       perCorner(p.normals[2]) * p.weights.z);
}

dmat3 normalMatrix(const WrongInput& p) { return glm::transpose(glm::inverse(dmat3(p.model))); }

dvec3 faceNormal(const WrongInput& p) {
    const dvec3 across = glm::cross(p.corners[1] - p.corners[0], p.corners[2] - p.corners[0]);
    return p.facing * unit(normalMatrix(p) * unit(across));
}

dvec3 normalInObjectSpace(const WrongInput& p) {
    return withNormal(p, unit(varying(p, [](const dvec3& n) { return n; })));
}

dvec3 normalTranslated(const WrongInput& p) {
    return withNormal(p, unit(varying(p, [&](const dvec3& n) { return unit(positionBy(p.model, n)); })));
}

dvec3 normalByTheModelMatrix(const WrongInput& p) {
    return withNormal(p, unit(varying(p, [&](const dvec3& n) { return unit(dmat3(p.model) * n); })));
}

dvec3 viewNormalWorldLight(const WrongInput& p) { return withNormal(p, unit(dmat3(p.view) * p.n)); }

dvec3 inClipSpace(const WrongInput& p) { return inSpace(p.clip, p); }

dvec3 notRenormalised(const WrongInput& p) {
    return withNormal(p, varying(p, [&](const dvec3& n) { return unit(normalMatrix(p) * n); }));
}

dvec3 neverNormalised(const WrongInput& p) {
    return withNormal(p, varying(p, [&](const dvec3& n) { return normalMatrix(p) * n; }));
}

dvec3 faceForSmooth(const WrongInput& p) { return withNormal(p, faceNormal(p)); }

// R: right in other words

dvec3 saturatedAtTheEnd(const WrongInput& p) { return glm::min(lambert(p), 1.0); }

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
    return withCosine(p, [&](const Lamp& lamp) {
        const dvec3 v = lamp.point ? lamp.position - p.Q : lamp.towards;
        const double c = glm::dot(p.n, v) / std::sqrt(glm::dot(v, v));
        return c > 0 ? c : 0.0;
    });
}

dvec3 channelByChannel(const WrongInput& p) {
    double P[3];
    for (int i = 0; i < 3; ++i) {
        P[i] = p.D[i] * p.ambient[i] + p.emitted[i];
        for (const Lamp& lamp : p.lamps)
            P[i] += p.D[i] * lamp.color[i] * lamp.intensity * cosine(p, lamp) * attenuation(p, lamp);
    }
    return {P[0], P[1], P[2]};
}

dvec3 constantInL(const WrongInput& p) {
    WrongInput q = p;
    for (Lamp& lamp : q.lamps)
        lamp.color = lamp.L() * p.D, lamp.intensity = 1;
    q.ambient *= p.D;
    q.D = dvec3(1);
    return lambert(q);
}

dvec3 inViewSpace(const WrongInput& p) { return inSpace(p.view, p); }

dvec3 faceWhereFlat(const WrongInput& p) {
    const bool flat = p.normals[0] == p.normals[1] && p.normals[1] == p.normals[2];
    return withNormal(p, flat ? faceNormal(p) : p.n);
}

}  // namespace

std::vector<Misconception> normalRows() {
    return {
        {"C1", "normal left in object space", 2, normalInObjectSpace},
        {"C2", "normal moved along as if it were a point (w = 1)", 2, normalTranslated},
        {"C3", "normal by the model matrix", 2, normalByTheModelMatrix},
        {"C5", "normal in view space, light in world space", 2, viewNormalWorldLight},
        {"C6", "lighting in clip space", 2, inClipSpace},
        {"C8", "interpolated normal not normalised again", 2, notRenormalised},
        {"C9", "normal never normalised", 2, neverNormalised},
        {"C11", "the triangle's normal for the smooth one", 2, faceForSmooth},
    };
}

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
    };
}

}  // namespace support::rows
