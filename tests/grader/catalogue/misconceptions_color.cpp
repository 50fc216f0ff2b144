// Misconceptions about the ambient term (E), colours (F) and the sum over the lamps (G).
// SPDX-License-Identifier: MIT
#include "grader/catalogue/misconception_rows.hpp"

#include <numbers>

namespace grader::rows {

namespace {

// E: the ambient term

dvec3 ambientWithoutD(const WrongInput& p) { return reflected(p) + p.ambient + p.emitted; }

dvec3 ambientWithDTwice(const WrongInput& p) { return reflected(p) + p.D * p.D * p.ambient + p.emitted; }

dvec3 ambientPerLamp(const WrongInput& p) {
    return sum(p, [&](const Lamp& lamp) { return addend(p, lamp) + p.D * p.ambient; }) + p.emitted;
}

dvec3 largerOfDiffuseAndAmbient(const WrongInput& p) {
    return glm::max(reflected(p), p.D * p.ambient) + p.emitted;
}

// F: colours

dvec3 swapped(const dvec3& c) { return {c.b, c.g, c.r}; }

WrongInput swappedD(WrongInput p) {
    p.D = swapped(p.D);
    p.emitted = swapped(p.emitted);
    p.specular = swapped(p.specular);
    return p;
}

WrongInput swappedL(WrongInput p) {
    for (Lamp& lamp : p.lamps)
        lamp.color = swapped(lamp.color);
    p.ambient = swapped(p.ambient);
    return p;
}

// The sRGB curve, a channel to the screen and back.
double encoded(double x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055; }
double decoded(double x) { return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); }
dvec3 encoded(const dvec3& c) { return {encoded(c.r), encoded(c.g), encoded(c.b)}; }
dvec3 decoded(const dvec3& c) { return {decoded(c.r), decoded(c.g), decoded(c.b)}; }

dvec3 colorsAdded(const WrongInput& p) {
    return sum(p,
               [&](const Lamp& lamp) { return cosine(p, lamp) * attenuation(p, lamp) * (p.D + lamp.L()); }) +
           highlights(p) + rest(p);
}

dvec3 noD(const WrongInput& p) {
    WrongInput white = p;
    white.D = dvec3(1);
    return reflected(white) + rest(p);
}

dvec3 twiceD(const WrongInput& p) { return p.D * reflected(matte(p)) + highlights(p) + rest(p); }

dvec3 bgr(const WrongInput& p) { return equation(swappedL(swappedD(p))); }

dvec3 bgrD(const WrongInput& p) { return equation(swappedD(p)); }

dvec3 bgrL(const WrongInput& p) { return equation(swappedL(p)); }

dvec3 colorsTo255(const WrongInput& p) {
    WrongInput q = p;
    q.D *= 255.0;
    q.specular *= 255.0;
    return equation(q);
}

dvec3 encodedResult(const WrongInput& p) { return encoded(equation(p)); }

dvec3 decodedColors(const WrongInput& p) {
    WrongInput q = p;
    q.D = decoded(p.D);
    q.emitted = decoded(p.emitted);
    q.specular = decoded(p.specular);
    q.ambient = decoded(p.ambient);
    for (Lamp& lamp : q.lamps)
        lamp.color = decoded(lamp.color);
    return equation(q);
}

dvec3 dividedByPi(const WrongInput& p) {
    WrongInput q = p;
    q.D /= std::numbers::pi;
    return equation(q);
}

// G: the sum

dvec3 lampsMultiplied(const WrongInput& p) {
    dvec3 P = p.D;
    for (const Lamp& lamp : p.lamps)
        P *= cosine(p, lamp) * attenuation(p, lamp) * lamp.L();
    return P + highlights(p) + rest(p);
}

dvec3 averageOfTheLamps(const WrongInput& p) {
    return p.lamps.empty() ? rest(p) : reflected(p) / static_cast<double>(p.lamps.size()) + rest(p);
}

dvec3 lastLampOnly(const WrongInput& p) {
    return p.lamps.empty() ? rest(p) : addend(p, p.lamps.back()) + rest(p);
}

dvec3 bytesWrap(const WrongInput& p) {
    const dvec3 codes = 255.0 * equation(p);
    return (codes - 256.0 * glm::floor(codes / 256.0)) / 255.0;
}

}  // namespace

std::vector<Misconception> colorRows() {
    return {
        {"E1", "ambient without D", 4, ambientWithoutD},
        {"E2", "ambient with D twice", 4, ambientWithDTwice},
        {"E3", "ambient once per lamp", 4, ambientPerLamp},
        {"E4", "larger of diffuse and ambient", 4, largerOfDiffuseAndAmbient},
        {"F1", "colours added, not multiplied", 2, colorsAdded},
        {"F2", "D forgotten", 2, noD},
        {"F2T", "D twice", 2, twiceD},
        {"F5", "red and blue swapped in D and L", 2, bgr},
        {"F5D", "red and blue swapped in D", 2, bgrD},
        {"F5L", "red and blue swapped in L", 3, bgrL},
        {"F7", "colours from 0 to 255", 2, colorsTo255},
        {"F9", "sRGB applied to the result", 2, encodedResult},
        {"F10", "colours linearised first", 2, decodedColors},
        {"F11", "divided by pi", 2, dividedByPi},
        {"G1", "lamps multiplied", 3, lampsMultiplied},
        {"G2", "average of the lamps", 3, averageOfTheLamps},
        {"G4", "last lamp only", 3, lastLampOnly},
        {"G5", "8 bits wrap round", 3, bytesWrap},
    };
}

}  // namespace grader::rows
