// Frames whose every pixel is a formula: planes under lights whose answer one can write down.
// SPDX-License-Identifier: MIT
#include "render/error.hpp"
#include "support/draw.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace {

using support::draw;
using support::DrawOptions;
using support::u;

// A plane that faces the camera and covers the whole picture; the camera 2 away, seeing 2 x 2 units of it.
struct FacingPlane {
    THREE::Scene scene;
    THREE::PlaneGeometry geometry{6, 6};
    THREE::MeshLambertMaterial material{THREE::Color(0xFF8855)};
    THREE::Mesh plane{geometry, material};
    THREE::PerspectiveCamera camera{53.13010235415598, 1, 0.1, 10};
    glm::dvec3 D{1, 0x88 / 255.0, 0x55 / 255.0};

    FacingPlane() {
        scene.add(plane);
        camera.position.set(0, 0, 2);
    }
    // The point of the plane under a pixel's centre.
    static THREE::Vector3 point(int x, int y, int size) {
        return {(2 * (x + 0.5) / size - 1), 1 - 2 * (y + 0.5) / size, 0};
    }
};

// Every pixel of a frame against a formula; `bound` is absolute.
template <class Formula>
void expectEverywhere(const support::Drawn& drawn, double bound, const Formula& formula) {
    for (int y = 0; y < drawn.frame.height; ++y)
        for (int x = 0; x < drawn.frame.width; ++x) {
            const glm::dvec3 expected = formula(FacingPlane::point(x, y, drawn.frame.width));
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(drawn.at(x, y)[c], expected[c], bound)
                    << "pixel " << x << ',' << y << " channel " << c;
        }
}

TEST(ClosedForm, NoLightIsBlack) {
    FacingPlane s;
    expectEverywhere(draw(s.scene, s.camera), 0, [](auto) { return glm::dvec3(0); });
}

TEST(ClosedForm, FacingLightGivesExactlyDTimesL) {
    FacingPlane s;
    THREE::DirectionalLight light(THREE::Color(0.5, 0.25, 2), 0.5);
    light.position.set(0, 0, 7);
    s.scene.add(light);
    const support::Drawn drawn = draw(s.scene, s.camera);
    const glm::vec3 expected = glm::vec3(s.D) * glm::vec3(0.25F, 0.125F, 1.0F);
    for (int c = 0; c < 3; ++c)
        EXPECT_EQ(drawn.at(10, 20)[c], expected[c]);
}

TEST(ClosedForm, AtSixtyDegreesHalf) {
    FacingPlane s;
    THREE::DirectionalLight light;
    light.position.set(std::sqrt(3.0), 0, 1);
    s.scene.add(light);
    expectEverywhere(draw(s.scene, s.camera), 8 * u, [&s](auto) { return s.D * 0.5; });
}

TEST(ClosedForm, GrazingAndBehindAreZero) {
    for (const double z : {0.0, -1e-8, -1.0}) {
        FacingPlane s;
        THREE::DirectionalLight light;
        light.position.set(1, 0, z);
        s.scene.add(light);
        expectEverywhere(draw(s.scene, s.camera), 0, [](auto) { return glm::dvec3(0); });
    }
}

TEST(ClosedForm, WithoutTheClampLightFromBehindIsNegative) {
    FacingPlane s;
    THREE::DirectionalLight light;
    light.position.set(0, 0, -1);
    s.scene.add(light);
    DrawOptions options;
    options.settings.terms = options.settings.terms.without(lighting::Term::clamp);
    expectEverywhere(draw(s.scene, s.camera, options), 2 * u, [&s](auto) { return -s.D; });
}

TEST(ClosedForm, TwoLightsAreTheSumOfTheSingles) {
    FacingPlane s;
    THREE::DirectionalLight sun(THREE::Color(0x8090A0));
    sun.position.set(1, 2, 3);
    THREE::PointLight bulb(THREE::Color(0xDD6666), 3, 0, 2);
    bulb.position.set(0.5, -0.25, 1);
    s.scene.add(sun);
    const support::Drawn first = draw(s.scene, s.camera);
    s.scene.add(bulb);
    const support::Drawn both = draw(s.scene, s.camera);
    s.scene.remove(sun);
    const support::Drawn second = draw(s.scene, s.camera);
    for (std::size_t i = 0; i < both.floats().size(); ++i)
        ASSERT_EQ(both.floats()[i], first.floats()[i] + second.floats()[i]) << "value " << i;
}

TEST(ClosedForm, AmbientAloneIsExactlyDTimesLA) {
    FacingPlane s;
    THREE::AmbientLight ambient(0x101010);
    s.scene.add(ambient);
    const support::Drawn drawn = draw(s.scene, s.camera);
    const glm::vec3 expected = glm::vec3(s.D) * static_cast<float>(16 / 255.0);
    for (int c = 0; c < 3; ++c)
        EXPECT_EQ(drawn.at(31, 31)[c], expected[c]);
}

TEST(ClosedForm, AmbientDoesNotDependOnTheNormalAndEmissiveOnNoLight) {
    FacingPlane s;
    s.material.emissive.set(0.25, 0.5, 0.75);
    s.material.emissiveIntensity = 2;
    s.plane.rotation.y = 0.7;
    THREE::AmbientLight ambient(0xFFFFFF, 0.5);
    s.scene.add(ambient);
    const support::Drawn drawn = draw(s.scene, s.camera);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(drawn.at(32, 32)[c], s.D[c] * 0.5 + 0.5 * (c + 1), 4 * u);
}

TEST(ClosedForm, UnlitMaterialsKeepTheirColour) {
    FacingPlane s;
    THREE::MeshBasicMaterial basic(THREE::Color(0.1, 0.6, 3));
    s.plane.material = THREE::Handle<THREE::Material>(basic);
    THREE::DirectionalLight light;
    s.scene.add(light);
    const support::Drawn drawn = draw(s.scene, s.camera);
    EXPECT_EQ(drawn.at(5, 5), glm::vec3(0.1F, 0.6F, 3.0F));
}

// Slide 31: f(d) = 1 / d^k, at every pixel of the plane, for all kinds of exponents and a window.
struct Falloff {
    double decay;
    double distance;
    double bound;  // in u of the light's strength there
};
class PointLight : public testing::TestWithParam<Falloff> {};

TEST_P(PointLight, FollowsTheSlideAtEveryPixel) {
    FacingPlane s;
    const Falloff& p = GetParam();
    THREE::PointLight bulb(THREE::Color(0xDD6666), 2, p.distance, p.decay);
    bulb.position.set(0.3, -0.4, 0.75);
    s.scene.add(bulb);
    const glm::dvec3 L = 2.0 * glm::dvec3(0xDD / 255.0, 0x66 / 255.0, 0x66 / 255.0);
    const auto formula = [&](const THREE::Vector3& Q) {
        const THREE::Vector3 v = THREE::Vector3(bulb.position).sub(Q);
        const double d = v.length();
        const double rest = p.distance > 0 ? std::max(0.0, 1 - std::pow(d / p.distance, 4)) : 1;
        return s.D * L * (v.z / d * std::pow(d, -p.decay) * rest * rest);
    };
    // Q itself is interpolated in float: some 4 u of the picture's extent, beside the shading's own roundings.
    expectEverywhere(draw(s.scene, s.camera), p.bound * u * 2 * std::pow(0.75, -p.decay), formula);
}

INSTANTIATE_TEST_SUITE_P(Exponents, PointLight,
                         testing::Values(Falloff{0, 0, 40}, Falloff{1, 0, 40}, Falloff{2, 0, 40},
                                         Falloff{1.5, 0, 70}, Falloff{0.3, 0, 70}, Falloff{3, 0, 80},
                                         Falloff{0, 1.25, 60}, Falloff{2, 1.25, 60}));

TEST(ClosedForm, TwiceAsFarIsAHalfOrAQuarter) {
    for (const double k : {1.0, 2.0}) {
        FacingPlane s;
        THREE::PointLight bulb(THREE::Color(0xFFFFFF), 1, 0, k);
        s.scene.add(bulb);
        bulb.position.set(0, 0, 1);
        const support::Drawn near = draw(s.scene, s.camera, {65, 65, true, {}});
        bulb.position.set(0, 0, 2);
        const support::Drawn far = draw(s.scene, s.camera, {65, 65, true, {}});
        EXPECT_NEAR(far.at(32, 32).r, near.at(32, 32).r * std::pow(2, -k), 8 * u);
    }
}

TEST(ClosedForm, EightBitFramesHoldTheNearestCode) {
    FacingPlane s;
    THREE::DirectionalLight light;
    light.position.set(0, 0, 1);
    s.scene.add(light);
    const support::Drawn drawn = draw(s.scene, s.camera, {8, 8, false, {}});
    const auto& codes = std::get<image::Bytes>(drawn.frame.pixels);
    EXPECT_EQ(codes[0], 0xFF);
    EXPECT_EQ(codes[1], 0x88);
    EXPECT_EQ(codes[2], 0x55);
}

TEST(ClosedForm, ALightInThePointItselfAddsNothing) {
    FacingPlane s;
    THREE::PointLight bulb(THREE::Color(0xFFFFFF), 1, 0, 2);
    s.scene.add(bulb);  // on the plane: grazing everywhere, and 0/0 at one point
    expectEverywhere(draw(s.scene, s.camera, {65, 65, true, {}}), 0, [](auto) { return glm::dvec3(0); });
}

TEST(ClosedForm, WhatIsTooBrightForFloatsSaturates) {
    FacingPlane s;
    THREE::PointLight bulb(THREE::Color(1, 1, 0), 1, 0, 40);  // 0.1^-40 = 1e40
    bulb.position.set(0, 0, 0.1);
    s.scene.add(bulb);
    const support::Drawn drawn = draw(s.scene, s.camera, {65, 65, false, {}});
    const auto& codes = std::get<image::Bytes>(drawn.frame.pixels);
    const std::size_t middle = (32 * 65 + 32) * 3;
    EXPECT_EQ(codes[middle], 255);
    EXPECT_EQ(codes[middle + 1], 255);
    EXPECT_EQ(codes[middle + 2], 0);
}

TEST(ClosedForm, ManyLightsGoThroughATexture) {
    FacingPlane s;
    std::vector<std::unique_ptr<THREE::PointLight>> bulbs;
    for (int i = 0; i < 700; ++i) {
        auto& bulb = bulbs.emplace_back(
            std::make_unique<THREE::PointLight>(THREE::Color(0x806040), 0.01, i % 5 == 0 ? 3 : 0, i % 4));
        bulb->position.set(std::cos(i), std::sin(i * 0.7), 1 + i * 0.001);
        s.scene.add(*bulb);
    }
    const glm::dvec3 L = 0.01 * glm::dvec3(0x80 / 255.0, 0x60 / 255.0, 0x40 / 255.0);
    const auto formula = [&](const THREE::Vector3& Q) {
        double sum = 0;
        for (const auto& bulb : bulbs) {
            const THREE::Vector3 v = THREE::Vector3(bulb->position).sub(Q);
            const double d = v.length();
            const double rest = bulb->distance > 0 ? std::max(0.0, 1 - std::pow(d / bulb->distance, 4)) : 1;
            sum += v.z / d * std::pow(d, -bulb->decay) * rest * rest;
        }
        return s.D * L * sum;
    };
    expectEverywhere(draw(s.scene, s.camera, {16, 16, true, {}}), 3000 * u, formula);
}

// The most that are promised: loops of 65,536 turns, at which software drivers end them unless four lights share a turn.
TEST(ClosedForm, AsManyLightsAsDriversWouldNotCount) {
    FacingPlane s;
    std::vector<std::unique_ptr<THREE::PointLight>> bulbs;
    constexpr int count = 65'536;
    for (int i = 0; i < count; ++i) {
        bulbs.push_back(std::make_unique<THREE::PointLight>(THREE::Color(1, 1, 1), 1.0 / count, 0, 0));
        bulbs.back()->position.set(0, 0, 1);
        s.scene.add(*bulbs.back());
    }
    s.scene.updateMatrixWorld();
    s.camera.updateWorldMatrix();
    const lighting::Settings settings;
    const image::Frame frame =
        support::renderer().render(s.scene, s.camera, settings, {8, 8, true});  // once: it takes a second
    EXPECT_EQ(support::renderer().stats().lightsUsed, count);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) {
            const THREE::Vector3 Q = FacingPlane::point(x, y, 8);
            const double cosine = 1 / std::sqrt(Q.x * Q.x + Q.y * Q.y + 1);
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(
                    std::get<image::Floats>(frame.pixels)[static_cast<std::size_t>((y * 8 + x) * 3 + c)],
                    s.D[c] * cosine, (18 + count) * u * s.D[c]);
        }
}

// Beyond that, software drivers would leave lights out without a word.
TEST(ClosedForm, MoreLightsThanDriversCountAreRefused) {
    FacingPlane s;
    THREE::DirectionalLight sun;
    s.scene.add(sun);
    s.scene.updateMatrixWorld();
    s.camera.updateWorldMatrix();
    const lighting::Settings settings;
    lighting::FramePlan plan = lighting::planFrame(s.scene, s.camera, settings);
    plan.directional.resize(200'001, plan.directional.at(0));
    try {
        support::renderer().render(plan, settings, {4, 4, true});
        FAIL() << "expected a refusal";
    } catch (const render::NoRenderer& refused) {
        EXPECT_NE(std::string(refused.what()).find("200001 lights"), std::string::npos) << refused.what();
        EXPECT_NE(std::string(refused.what()).find("--renderer reference"), std::string::npos)
            << refused.what();
    }
}

}  // namespace
