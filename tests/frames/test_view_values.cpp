// Views by hand: what single pixels must show, and that legends tell the colours that pixels have.
// SPDX-License-Identifier: MIT
#include "lighting/views.hpp"
#include "support/both_ways.hpp"
#include "support/strict_glsl.hpp"
#include "support/strict_glsl_room.hpp"

#include <gtest/gtest.h>
#include <set>

namespace {

using lighting::LegendEntry;
using lighting::Term;
using lighting::TermSet;
using lighting::ViewMode;
using support::Room;

constexpr double code = 1 / 255.0;

// The middle of the plane, seen from straight above: Q = 0, n = +z.
glm::dvec3 middle(Room& room, ViewMode view, TermSet terms = TermSet::all()) {
    support::DrawOptions options{17, 17, true, {}};
    options.settings.view = view;
    options.settings.terms = terms;
    return support::draw(room.scene, room.camera, options).at(8, 8);
}

void expectNear(const glm::dvec3& found, const glm::dvec3& expected, double within, const std::string& what) {
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(found[i], expected[i], within) << what << ", channel " << i;
}

// Towards a light that n . w has this value for, the normal being +z.
THREE::Vector3 towards(double cosine) { return {std::sqrt(1 - cosine * cosine), 0, cosine}; }

TEST(ViewValues, FactorsOfASun) {
    Room room;
    room.sun({3, 0, 4}, 0x3366CC, 1.5);  // w = (0.6, 0, 0.8)
    room.sun({0, 0, 1}, 0xFFFFFF);  // is not asked
    room.ambient(0x404040);
    const glm::dvec3 D = support::channels(room.material.color);
    expectNear(middle(room, ViewMode::albedo), D, 1e-6, "albedo");
    expectNear(middle(room, ViewMode::cosine), glm::dvec3(0.8), 1e-6, "cosine");
    expectNear(middle(room, ViewMode::clamp), glm::dvec3(0.8), 1e-6, "clamp");
    expectNear(middle(room, ViewMode::lightColor), glm::dvec3(0.3, 0.6, 1.2), 1e-6, "light_color");
    expectNear(middle(room, ViewMode::normals), {0.5, 0.5, 1}, 1e-6, "normals");
    expectNear(middle(room, ViewMode::w), {0.8, 0.5, 0.9}, 1e-6, "w");
    expectNear(middle(room, ViewMode::attenuation), lighting::legend(ViewMode::attenuation)[6].color, 1e-6,
               "a sun does not fade: f = 1");
    const TermSet none = TermSet::none();
    expectNear(middle(room, ViewMode::albedo, none), glm::dvec3(1), 0, "albedo off");
    expectNear(middle(room, ViewMode::cosine, none), glm::dvec3(1), 0, "cosine off");
    expectNear(middle(room, ViewMode::lightColor, none), glm::dvec3(1.5), 1e-6, "light_color off");
}

TEST(ViewValues, FactorsOfABulb) {
    Room room;
    room.bulb({0, 1.2, 1.6}, 1);  // d = 2, w = (0, 0.6, 0.8)
    expectNear(middle(room, ViewMode::cosine), glm::dvec3(0.8), 1e-6, "cosine");
    expectNear(middle(room, ViewMode::w), {0.5, 0.8, 0.9}, 1e-6, "w");
    const std::vector<LegendEntry> octaves = lighting::legend(ViewMode::attenuation);
    expectNear(middle(room, ViewMode::attenuation), octaves[5].color, 1e-6, "1 / 2");
    room.bulbs[0]->decay = 2;
    expectNear(middle(room, ViewMode::attenuation), octaves[4].color, 1e-6, "1 / 4");
    room.bulbs[0]->decay = 2.5;
    expectNear(middle(room, ViewMode::attenuation), 0.5 * (octaves[3].color + octaves[4].color), 1e-6,
               "2^-2.5, between two octaves");
    room.bulbs[0]->distance = 1.5;
    expectNear(middle(room, ViewMode::attenuation), octaves[0].color, 1e-6, "beyond its distance");
    expectNear(middle(room, ViewMode::attenuation, TermSet::none()), octaves[6].color, 1e-6, "off: 1");
    room.bulbs[0]->position.set(0, 0.6, -0.8);
    expectNear(middle(room, ViewMode::clamp), glm::dvec3(0), 0, "from behind");
    expectNear(middle(room, ViewMode::cosine), 0.8 * lighting::legend(ViewMode::cosine)[0].color, 1e-6,
               "from behind, with its sign");
}

// One addend of the sum each; light of the surface's own belongs to none.
TEST(ViewValues, Addends) {
    Room room;
    THREE::MeshPhongMaterial shiny(THREE::Color(0x804020));
    shiny.specular.set(0x333333);
    shiny.shininess = 1;
    shiny.emissive.set(0x404040);
    room.plane.material = shiny;
    room.sun({0, 3, 4}, 0xFFFFFF);  // R = (0, -0.6, 0.8), v = (0, 0, 1): R . v = 0.8
    room.bulb({0, 0, 1}, 0);  // R . v = 1
    room.ambient(0x336699);
    const glm::dvec3 D = support::channels(shiny.color), K(0.2),
                     L = support::channels(room.bulbs[0]->radiance());
    expectNear(middle(room, ViewMode::directional), 0.8 * D + 0.8 * K, 1e-6, "directional");
    expectNear(middle(room, ViewMode::point), (D + K) * L, 1e-6, "point");
    expectNear(middle(room, ViewMode::ambient), D * glm::dvec3(0.2, 0.4, 0.6), 1e-6, "ambient");
    expectNear(middle(room, ViewMode::specular), 0.8 * K + K * L, 1e-6, "specular");
    expectNear(middle(room, ViewMode::specular, TermSet::all().without(Term::albedo)), 0.8 * K + K * L, 1e-6,
               "specular, D switched off");
    const glm::dvec3 P = middle(room, ViewMode::final);
    expectNear(middle(room, ViewMode::red), glm::dvec3(P.r), 0, "red");
    expectNear(middle(room, ViewMode::green), glm::dvec3(P.g), 0, "green");
    expectNear(middle(room, ViewMode::blue), glm::dvec3(P.b), 0, "blue");
    expectNear(middle(room, ViewMode::exaggerated),
               P + (lighting::exaggeration - 1) * middle(room, ViewMode::ambient), 1e-6, "exaggerated");
}

TEST(ViewValues, UnlitMeshesAndBackgrounds) {
    for (const lighting::ViewInfo& row : lighting::views()) {
        Room room;
        THREE::MeshBasicMaterial plain(THREE::Color(0x4080C0));
        room.plane.material = plain;
        room.plane.scale.set(0.1, 0.1, 1);
        room.scene.background = THREE::Color(0x336699);
        room.sun({0, 0, 1}, 0xFFFFFF);
        const auto expected = [&row](glm::dvec3 color, const glm::dvec3& data) {
            if (lighting::isData(row.view))
                return data;
            return row.view == ViewMode::red           ? glm::dvec3(color.r)
                   : row.view == ViewMode::green       ? glm::dvec3(color.g)
                   : row.view == ViewMode::blue        ? glm::dvec3(color.b)
                   : row.view == ViewMode::overexposed ? lighting::dimmed * color
                                                       : color;
        };
        expectNear(middle(room, row.view), expected({64 * code, 128 * code, 192 * code}, lighting::noValue),
                   1e-6, std::string(row.name) + ", unlit");
        room.plane.visible = false;
        expectNear(middle(room, row.view), expected({0.2, 0.4, 0.6}, lighting::noSurface), 1e-6,
                   std::string(row.name) + ", background");
    }
}

// A lit mesh has no factor where there is no light to have one.
TEST(ViewValues, WithoutALight) {
    for (const lighting::ViewInfo& row : lighting::views()) {
        Room room;
        room.ambient(0x808080);
        const glm::dvec3 found = middle(room, row.view);
        EXPECT_EQ(glm::length(found - lighting::noValue) < 1e-6, row.needsLight) << row.name;
    }
}

// Every entry of the legends of factors, drawn.
TEST(Legends, TellTheColoursOfPixels) {
    for (const LegendEntry& entry : lighting::legend(ViewMode::cosine)) {
        Room room;
        room.sun(towards(*entry.value), 0xFFFFFF);
        expectNear(middle(room, ViewMode::cosine), entry.color, 1e-6, "cosine");
        if (*entry.value >= 0)
            expectNear(middle(room, ViewMode::clamp), entry.color, 1e-6, "clamp");
    }
    EXPECT_EQ(lighting::legend(ViewMode::clamp).size(), 5U);
    for (const LegendEntry& entry : lighting::legend(ViewMode::attenuation)) {
        Room room;
        room.bulb({0, 0, 1 / *entry.value}, 1);
        room.camera.position.z = 0.2;
        expectNear(middle(room, ViewMode::attenuation), entry.color, 1e-5, "attenuation");
    }
    for (const ViewMode view : {ViewMode::red, ViewMode::green, ViewMode::blue})
        for (const LegendEntry& entry : lighting::legend(view)) {
            Room room;
            room.ambient(0xFFFFFF);
            room.material.color.setRGB(*entry.value, *entry.value, *entry.value);
            expectNear(middle(room, view), entry.color, 1e-6, lighting::info(view).name);
        }
}

TEST(Legends, OfDirections) {
    for (const LegendEntry& entry : lighting::legend(ViewMode::w)) {
        const glm::dvec3 axis = 2.0 * entry.color - 1.0;
        Room room;
        room.sun({axis.x, axis.y, axis.z}, 0xFFFFFF);
        expectNear(middle(room, ViewMode::w), entry.color, 1e-6, entry.text.en);
        Room turned;  // a surface whose vertices say that this is their normal
        std::vector<double> normals;
        for (std::size_t i = 0; i < turned.geometry.vertexCount(); ++i)
            normals.insert(normals.end(), {axis.x, axis.y, axis.z});
        turned.geometry.setAttribute("normal", normals, 3);
        expectNear(middle(turned, ViewMode::normals), entry.color, 1e-6, entry.text.en);
    }
}

// The middle of every band; where the light is behind, two thirds of the pixels have the colour and the rest are black.
TEST(Legends, OfBands) {
    const std::vector<LegendEntry> entries = lighting::legend(ViewMode::bands);
    ASSERT_EQ(entries.size(), 20U);
    for (const LegendEntry& entry : entries) {
        Room room;
        room.sun(towards(*entry.value + 0.05), 0xFFFFFF);
        support::DrawOptions options{18, 18, true, {}};
        options.settings.view = ViewMode::bands;
        const support::Drawn drawn = support::draw(room.scene, room.camera, options);
        int colored = 0, black = 0;
        for (int y = 0; y < 18; ++y)
            for (int x = 0; x < 18; ++x) {
                const glm::dvec3 pixel = drawn.at(x, y);
                colored += glm::length(pixel - entry.color) < 1e-6 ? 1 : 0;
                black += pixel == glm::dvec3(0) ? 1 : 0;
            }
        EXPECT_EQ(colored, *entry.value < 0 ? 216 : 324) << *entry.value;
        EXPECT_EQ(black, *entry.value < 0 ? 108 : 0) << *entry.value;
    }
}

// Stripes of 2, 4 and 6 in 8 pixels where 1, 2 and 3 channels are above 1; what is not above it is dimmed.
TEST(Legends, OfOverexposure) {
    for (const LegendEntry& entry : lighting::legend(ViewMode::overexposed)) {
        Room room;
        room.ambient(0xFFFFFF);
        const double channels = *entry.value;
        room.material.color.setRGB(1.5, channels > 1 ? 1.25 : 1, channels > 2 ? 1.01 : 0.5);
        support::DrawOptions options{16, 16, true, {}};
        options.settings.view = ViewMode::overexposed;
        const support::Drawn drawn = support::draw(room.scene, room.camera, options);
        int marked = 0, dimmed = 0;
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x) {
                const glm::dvec3 pixel = drawn.at(x, y);
                marked += glm::length(pixel - entry.color) < 1e-6 ? 1 : 0;
                dimmed += std::abs(pixel.r - lighting::dimmed) < 1e-6 ? 1 : 0;
            }
        EXPECT_EQ(marked, 64 * static_cast<int>(channels));
        EXPECT_EQ(dimmed, 256 - marked);
    }
    Room room;  // 1 is what a picture can show, and so is what becomes 1
    room.ambient(0xFFFFFF);
    room.material.color.setRGB(1, 1.0019, 0.5);
    expectNear(middle(room, ViewMode::overexposed), lighting::dimmed * glm::dvec3(1, 1, 0.5), 1e-6,
               "not over");
}

// The ramp of attenuation grows by equal steps of lightness (CIE L*), so it needs no hues.
TEST(Legends, AttenuationIsReadWithoutHue) {
    const auto linear = [](double c) {
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    double before = 2;
    for (const LegendEntry& entry : lighting::legend(ViewMode::attenuation)) {
        const double Y =
            0.2126 * linear(entry.color.r) + 0.7152 * linear(entry.color.g) + 0.0722 * linear(entry.color.b);
        const double lightness = 116 * std::cbrt(Y) - 16;
        EXPECT_NEAR(lightness - before, 10, 0.5);
        before = lightness;
    }
}

TEST(Views, TableAndNames) {
    std::set<std::string> names;
    int number = 0;
    for (const lighting::ViewInfo& row : lighting::views()) {
        EXPECT_EQ(static_cast<int>(row.view), number++);
        EXPECT_EQ(lighting::parseView(row.name), row.view);
        EXPECT_EQ(lighting::legend(row.view).empty(), row.legend == lighting::LegendKind::none) << row.name;
        names.insert(row.name);
        EXPECT_NE(row.meaning.it, nullptr);
        EXPECT_NE(row.meaning.en, nullptr);
    }
    EXPECT_EQ(names.size(), static_cast<std::size_t>(lighting::viewCount));
    EXPECT_THROW(lighting::parseView("Cosine"), std::invalid_argument);
    EXPECT_THROW(lighting::parseView(""), std::invalid_argument);
}

// The shaders' text in strict floats, at places where a driver might hide a NaN: no normal, a light in the very point.
TEST(StrictViews, AreFiniteEverywhere) {
    for (const lighting::ViewInfo& row : lighting::views()) {
        if (!lighting::isData(row.view))
            continue;
        for (const double far : {1.0, 1e-12, 1e20}) {
            Room room;
            room.bulb({0, 0, far}, 2, far * 4);
            lighting::Settings settings;
            settings.view = row.view;
            const lighting::FramePlan plan = room.plan(settings);
            const lighting::Draw& draw = plan.draws.at(0);
            for (const glm::vec3& Q :
                 {glm::vec3(0), glm::vec3(0, 0, static_cast<float>(far)), glm::vec3(2, 1, 0)})
                for (const glm::vec3& n : {glm::vec3(0, 0, 1), glm::vec3(0), glm::vec3(0, 0, -0.5)}) {
                    const support::StrictFragment pixel = support::strictView(plan, draw, Q, n);
                    EXPECT_FALSE(pixel.nonfinite) << row.name << ", " << far;
                    for (int i = 0; i < 3; ++i)
                        EXPECT_TRUE(pixel.P[i] >= 0 && pixel.P[i] <= 2) << row.name << ", " << far;
                }
        }
    }
}

TEST(StrictViews, PresentChannelsAndMarks) {
    EXPECT_EQ(support::strictGreen({0.25F, 0.5F, 3}), glm::vec3(0.5F));
    EXPECT_EQ(support::strictOverexposed({2, 0.5F, -1}, {3.5F, 0.5F}), 0.35F * glm::vec3(1, 0.5F, 0));
    EXPECT_EQ(support::strictOverexposed({2, 2, 2}, {3.5F, 2.5F}), glm::vec3(1));
    EXPECT_EQ(support::strictOverexposed({2, 2, 2}, {3.5F, 3.5F}), glm::vec3(0.35F));
}

}  // namespace
