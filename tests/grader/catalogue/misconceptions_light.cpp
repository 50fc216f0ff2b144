// Misconceptions about the cosine (A), the direction of the light (B) and the attenuation (D).
// SPDX-License-Identifier: MIT
#include "grader/catalogue/misconception_rows.hpp"

namespace grader::rows {

namespace {

// A: the cosine

dvec3 noClamp(const WrongInput& p) {
    return withCosine(p, [&](const Lamp& lamp) { return glm::dot(p.n, w(p, lamp)); });
}

dvec3 clampOnTheSum(const WrongInput& p) {
    const dvec3 P =
        sum(p, [&](const Lamp& lamp) { return glm::dot(p.n, w(p, lamp)) * attenuation(p, lamp) * lamp.L(); });
    return p.D * glm::max(P, 0.0) + highlights(p) + rest(p);
}

dvec3 absoluteCosine(const WrongInput& p) {
    return withCosine(p, [&](const Lamp& lamp) { return std::abs(glm::dot(p.n, w(p, lamp))); });
}

dvec3 positiveFloor(const WrongInput& p) {
    return withCosine(p, [&](const Lamp& lamp) { return std::max(0.1, glm::dot(p.n, w(p, lamp))); });
}

// B: the direction

// The right equation, w of each lamp from direction(lamp), of whatever length.
template <class Direction>
dvec3 withDirection(const WrongInput& p, const Direction& direction) {
    return sum(p,
               [&](const Lamp& lamp) {
                   const dvec3 to = direction(lamp);
                   return addend(p, lamp, std::max(0.0, glm::dot(p.n, to)), highlight(p, to));
               }) +
           rest(p);
}

dvec3 pointAsDirection(const WrongInput& p) {
    return withDirection(p,
                         [&](const Lamp& lamp) { return unit(lamp.point ? lamp.position : lamp.towards); });
}

dvec3 pointFromTheCentre(const WrongInput& p) {
    return withDirection(
        p, [&](const Lamp& lamp) { return unit(lamp.point ? lamp.position - p.centre() : lamp.towards); });
}

dvec3 directionAsPoint(const WrongInput& p) {
    return withDirection(p, [&](const Lamp& lamp) { return unit(lamp.position - p.Q); });
}

dvec3 awayFromTheLight(const WrongInput& p) {
    return withDirection(p, [&](const Lamp& lamp) { return -w(p, lamp); });
}

dvec3 awayFromTheSunOnly(const WrongInput& p) {
    return withDirection(p, [&](const Lamp& lamp) { return lamp.point ? w(p, lamp) : -w(p, lamp); });
}

dvec3 normalFlipped(const WrongInput& p) { return withNormal(p, -p.n); }

dvec3 directionNotNormalised(const WrongInput& p) {
    return withDirection(p, [&](const Lamp& lamp) { return lamp.point ? w(p, lamp) : lamp.towards; });
}

dvec3 towardsPointNotNormalised(const WrongInput& p) {
    return withDirection(p, [&](const Lamp& lamp) { return lamp.point ? lamp.position - p.Q : w(p, lamp); });
}

dvec3 lightTurnsWithTheObject(const WrongInput& p) { return equation(lampsMovedBy(p.model, p)); }

dvec3 lightTurnsWithTheCamera(const WrongInput& p) { return equation(lampsMovedBy(glm::inverse(p.view), p)); }

// D: the attenuation

dvec3 distanceNotSquared(const WrongInput& p) {
    return withAttenuation(p, [](const Lamp&, double d) { return 1 / d; });
}

dvec3 noAttenuation(const WrongInput& p) {
    return withAttenuation(p, [](const Lamp&, double) { return 1.0; });
}

dvec3 dividesThenMultiplies(const WrongInput& p) {
    return withAttenuation(p, [](const Lamp&, double d) { return 1.0 / d * d; });
}

dvec3 multipliesByThePower(const WrongInput& p) {
    return withAttenuation(p, [](const Lamp& lamp, double d) { return std::pow(d, lamp.decay); });
}

dvec3 distanceToTheCamera(const WrongInput& p) {
    const double d = glm::length(p.eye - p.Q);
    return withAttenuation(p, [d](const Lamp& lamp, double) { return std::pow(d, -lamp.decay); });
}

dvec3 threeConstants(const WrongInput& p) {
    return withAttenuation(p, [](const Lamp&, double d) { return 1 / (1 + 0.09 * d + 0.032 * d * d); });
}

dvec3 onePlusTheSquare(const WrongInput& p) {
    return withAttenuation(p, [](const Lamp&, double d) { return 1 / (1 + d * d); });
}

dvec3 ambientAttenuated(const WrongInput& p) {
    double f = 1;  // what the loop over the lamps leaves behind
    for (const Lamp& lamp : p.lamps)
        if (lamp.point)
            f = attenuation(p, lamp);
    return reflected(p) + f * p.D * p.ambient + p.emitted;
}

}  // namespace

std::vector<Misconception> lightRows() {
    return {
        {"A1", "no clamp", 3, noClamp},
        {"A2", "clamp on the sum, not on each lamp", 3, clampOnTheSum},
        {"A3", "absolute value of the cosine", 2, absoluteCosine},
        {"A8", "cosine clamped to 0.1 instead of 0", 2, positiveFloor},
        {"B1", "point light's position taken for a direction", 3, pointAsDirection},
        {"B1C", "point light's direction taken from the mesh's centre", 3, pointFromTheCentre},
        {"B2", "directional light's position taken for a place", 2, directionAsPoint},
        {"B3", "w points away from the light", 2, awayFromTheLight},
        {"B4", "w points away from directional lights only", 2, awayFromTheSunOnly},
        {"B5", "normal flipped", 2, normalFlipped},
        {"B6", "directional light's direction not normalised", 2, directionNotNormalised},
        {"B7", "direction to a point light not normalised", 3, towardsPointNotNormalised},
        {"B9", "lights turn with the object", 2, lightTurnsWithTheObject},
        {"B10", "lights turn with the camera", 2, lightTurnsWithTheCamera},
        {"D1", "1/d for 1/d^2", 5, distanceNotSquared},
        {"D2", "no attenuation", 5, noAttenuation},
        {"D3", "1.0/d*d", 5, dividesThenMultiplies},
        {"D4", "multiplied by d^k", 5, multipliesByThePower},
        {"D5", "distance to the camera for distance to the light", 5, distanceToTheCamera},
        {"D6", "1/(1 + 0.09 d + 0.032 d^2)", 5, threeConstants},
        {"D6S", "1/(1 + d^2)", 5, onePlusTheSquare},
        {"D8", "ambient attenuated", 5, ambientAttenuated},
    };
}

}  // namespace grader::rows
