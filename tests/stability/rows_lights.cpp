// Rows L1 to L23: where lights stand and how strong they are.
// SPDX-License-Identifier: MIT
#include "stability/rows.hpp"

#include <cmath>
#include <limits>

namespace stability {

namespace {

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double brightest = std::numeric_limits<float>::max();

Setup plain(Lamp lamp, double expected, Bound bound = {}) {
    Setup s{{lamp}};
    s.expected = expected;
    s.bound = bound;
    return s;
}

// Nearer than floats reach: the plane shrinks with the light, so that rounding of the point itself does not count.
Setup near(double d, double k, double expected, Bound bound = {}) {
    Setup s = plain(bulb(d, k), expected, bound);
    s.size = d;
    return s;
}

Setup dark(Setup s) {
    s.ambient = 0;
    return s;
}

Setup refused(Lamp lamp, std::vector<std::string> words) {
    Setup s{{lamp}};
    s.refused = std::move(words);
    return s;
}

Setup colored(Setup s, const glm::dvec3& color, int shown) {
    s.lamps[0].color = color;
    s.channel = shown;
    return s;
}

Setup blackAlbedo(Setup s) {
    s.albedo = glm::dvec3(0);
    s.ambient = A;
    return s;
}

// From one end of the world to the other: the plane at -z, the light at +z.
Setup acrossTheWorld(double z, double size) {
    Setup s = dark(plain(bulb(2 * z, 0), 1));
    s.centre = {0, 0, -z};
    s.size = size;
    s.focus = glm::dvec3(0);
    return s;
}

Setup tooBrightASum() {
    Setup s = dark(plain(sun({0, 0, 1}, 1e36), brightest, exactly));
    s.lamps.push_back(s.lamps[0]);
    s.albedo = glm::dvec3(300);
    return s;
}

// Where skips are off, the light of no intensity is really computed; both frames are those without it.
void asWithoutTheLight(Outcome& outcome) {
    Setup with = plain(bulb(0, 2, 0), A, exactly), without = with;
    without.lamps.clear();
    for (const bool skip : {true, false}) {
        Stage lit(with, 1), unlit(without, 1);
        lit.options.settings.skip = unlit.options.settings.skip = skip;
        require(outcome,
                support::draw(lit.scene, lit.camera, lit.options).floats() ==
                    support::draw(unlit.scene, unlit.camera, unlit.options).floats(),
                std::string("a light of intensity 0 changes the frame") + (skip ? "" : " with --no-skip"));
        const Twin strict = twin(lit);
        require(outcome, strict.P == glm::vec3(static_cast<float>(A)) && !strict.nonfinite,
                "strict IEEE gives " + number(strict.P.r) + (skip ? "" : " with --no-skip"));
    }
}

// In 8 bits, what the screen shows.
void whiteInCodes(const Setup& setup, Outcome& outcome) {
    Stage stage(setup, setup.size);
    stage.options.floats = false;
    const auto codes =
        std::get<image::Bytes>(support::draw(stage.scene, stage.camera, stage.options).frame.pixels);
    const int code = codes[codes.size() / 2 - 1];  // of the middle pixel
    require(outcome, code == 255, "the 8-bit frame holds " + std::to_string(code) + ", expected 255");
}

std::vector<Row> nearRows() {
    return {
        {"L1", "light on the point, k = 2", "P = Q", Kind::shading, {plain(bulb(0, 2), A, exactly)}},
        {"L2",
         "the same, intensity 0",
         "P = Q, L = 0",
         Kind::shading,
         {plain(bulb(0, 2, 0), A, exactly)},
         {},
         asWithoutTheLight},
        {"L3", "the same, k = 0", "P = Q", Kind::shading, {plain(bulb(0, 0), A, exactly)}},
        {"L4", "very near", "d = 1e-3, k = 2", Kind::shading, {plain(bulb(1e-3, 2), 1e6 + A)}},
        {"L5", "near", "d = 0.05, k = 2", Kind::shading, {plain(bulb(0.05, 2), 400 + A)}},
        {"L6",
         "lower end of the plain formula",
         "d = 1e-13, k = 2",
         Kind::shading,
         {near(1e-13, 2, 1e26, {Bound::ulp, 8}), colored(near(1e-13, 2, 0.25e26), {0, 1, 0.25}, 2)}},
        {"L7",
         "result overflows",
         "d = 1e-20, k = 2",
         Kind::shading,
         {near(1e-20, 2, brightest, exactly)},
         {},
         [](Outcome& o) { whiteInCodes(near(1e-20, 2, brightest), o); }},
        {"L8", "d^2 underflows, k = 0", "d = 1e-30", Kind::shading, {near(1e-30, 0, A + 1)}},
        {"L9",
         "black channel of a too near light",
         "d = 1e-20, green = 0",
         Kind::shading,
         {colored(near(1e-20, 2, A, exactly), {1, 0, 0}, 1)}},
        {"L10",
         "black albedo, too near light",
         "d = 1e-20, D = 0",
         Kind::shading,
         {blackAlbedo(near(1e-20, 2, 0, exactly))}},
    };
}

std::vector<Row> farRows() {
    return {
        {"L11",
         "upper end of the plain formula",
         "d = 1e13, L = 1e26, k = 2",
         Kind::shading,
         {dark(plain(bulb(1e13, 2, 1e26), 1)),
          dark(colored(plain(bulb(1e13, 2, 1e26), 0.25), {0, 1, 0.25}, 2))}},
        {"L12", "far point light, k = 0", "d = 1e20", Kind::shading, {dark(plain(bulb(1e20, 0), 1))}},
        {"L13",
         "far, strong",
         "d = 1e19, L = 1e36 (1e38: refused)",
         Kind::shading,
         {dark(plain(bulb(1e19, 2, 1e36), 0.01)),
          refused(bulb(1e20, 2, 1e38), {"PointLight 'lampada0'", "intensity"})}},
        {"L14", "far, k = 1", "d = 1e30, L = 1e30", Kind::shading, {dark(plain(bulb(1e30, 1, 1e30), 1))}},
        {"L15",
         "difference overflows",
         "9e35 - (-9e35) (3e38: refused)",
         Kind::shading,
         {acrossTheWorld(9e35, 1e30), refused(bulb(3e38, 0), {"PointLight 'lampada0'", "position.z"})}},
        {"L16",
         "light at infinity",
         "P = Inf",
         Kind::refused,
         {refused(bulb(infinite, 0), {"PointLight 'lampada0'", "position.z"})}},
        {"L17",
         "NaN position",
         "P = NaN",
         Kind::refused,
         {refused({Lamp::bulb, {NaN, 0, 1}, 1, 0, 0, glm::dvec3(1)},
                  {"PointLight 'lampada0'", "position.x"})}},
    };
}

std::vector<Row> strengthRows() {
    return {
        {"L18",
         "NaN colour",
         "green = NaN",
         Kind::refused,
         {colored(refused(bulb(1, 0), {"PointLight 'lampada0'", "color.g"}), {1, NaN, 1}, 1)}},
        {"L19",
         "infinite colour, black albedo",
         "L = Inf, D = 0",
         Kind::refused,
         {blackAlbedo(
             colored(refused(bulb(1, 0), {"PointLight 'lampada0'", "color.r"}), {infinite, 1, 1}, 0))}},
        {"L20",
         "negative intensity",
         "L = -1",
         Kind::refused,
         {refused(bulb(1, 0, -1), {"PointLight 'lampada0'", "intensity"})}},
        {"L21",
         "sum overflows",
         "3e38 + 3e38",
         Kind::shading,
         {tooBrightASum()},
         {},
         [](Outcome& o) { whiteInCodes(tooBrightASum(), o); }},
        {"L22",
         "denormal light",
         "L = 1e-44",
         Kind::shading,
         {dark(plain(sun({0, 0, 1}, 1e-44), 1e-44, {Bound::code, 0.5}))}},
        {"L23",
         "no direction",
         "directional light at (0, 0, 0)",
         Kind::refused,
         {refused(sun({0, 0, 0}), {"DirectionalLight 'sole0'", "position"})}},
    };
}

}  // namespace

std::vector<Row> lightRows() {
    std::vector<Row> all = nearRows();
    for (const auto& part : {farRows(), strengthRows()})
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

}  // namespace stability
