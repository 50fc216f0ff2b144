// Misconceptions about normals and spaces (C).
// SPDX-License-Identifier: MIT
#include "grader/catalogue/misconception_rows.hpp"

namespace grader::rows {

namespace {

// C: normals and spaces

// What reaches the fragment of perCorner(object-space normal), before any normalisation there.
template <class PerCorner>
dvec3 varying(const WrongInput& p, const PerCorner& perCorner) {
    return p.facing * (perCorner(p.normals[0]) * p.weights.x + perCorner(p.normals[1]) * p.weights.y +
                       perCorner(p.normals[2]) * p.weights.z);
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

}  // namespace grader::rows
