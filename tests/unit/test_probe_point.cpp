// Points of surfaces in the reference: pinned ones, hidden ones, and what a single pixel costs no picture
// for.
// SPDX-License-Identifier: MIT
#include "lighting/reference/reference.hpp"
#include "three/three.hpp"

#include <gtest/gtest.h>
#include <memory>

namespace {

using lighting::TermSet;
using lighting::reference::Probe;
using lighting::reference::Reference;
using lighting::reference::Sight;
using lighting::reference::Surface;

struct Stage {
    THREE::Scene scene;
    THREE::PerspectiveCamera camera{60, 1, 0.1, 50};
    THREE::TorusKnotGeometry shape{0.9, 0.34, 100, 16};
    THREE::MeshLambertMaterial material{THREE::Color(0xFF8855)};
    THREE::Mesh knot{shape, material};
    THREE::DirectionalLight sun;
    Stage() {
        sun.position.set(0, 3, -2);
        scene.add(knot, sun);
        camera.position.set(0, 0.5, 4);
        camera.lookAt(0, 0, 0);
    }
    Reference<double> seen(int size = 61) const { return {scene, camera, TermSet::all(), size, size}; }
};

TEST(ReferencePoint, APixelAloneIsWhatThePictureHasThere) {
    Stage s;
    const Reference<double> reference = s.seen(97);
    std::vector<std::optional<Surface<double>>> all(97 * 97);
    reference.surfaces([&](int x, int y, const std::optional<Surface<double>>& surface) {
        all[static_cast<std::size_t>(y * 97 + x)] = surface;
    });
    int seen = 0;
    for (int y = 0; y < 97; ++y)
        for (int x = 0; x < 97; ++x) {
            const auto& expected = all[static_cast<std::size_t>(y * 97 + x)];
            const auto found = reference.surface(x, y);
            ASSERT_EQ(found.has_value(), expected.has_value()) << x << " " << y;
            if (!found)
                continue;
            ++seen;
            ASSERT_EQ(found->triangle, expected->triangle);
            ASSERT_EQ(found->depth, expected->depth);
            ASSERT_EQ(found->Q, expected->Q);
        }
    EXPECT_GT(seen, 1000);
}

TEST(ReferencePoint, APointGivenByItsWeightsIsThePointThatWasSeen) {
    Stage s;
    const Reference<double> reference = s.seen();
    int seen = 0;
    for (int y = 0; y < 61; y += 3)
        for (int x = 0; x < 61; x += 3) {
            const auto hit = reference.surface(x, y);
            if (!hit)
                continue;
            ++seen;
            const auto again = reference.surfaceAt(&s.knot, hit->triangle, hit->weights);
            ASSERT_TRUE(again);
            EXPECT_NEAR(glm::length(again->Q - hit->Q), 0, 1e-13);
            EXPECT_NEAR(glm::length(again->n - hit->n), 0, 1e-13);
            EXPECT_NEAR(again->depth, hit->depth, 1e-12);
            EXPECT_EQ(again->front, hit->front);
            const auto place = reference.picture(*again);
            ASSERT_TRUE(place);
            EXPECT_NEAR(place->x, x + 0.5, 1e-9);
            EXPECT_NEAR(place->y, y + 0.5, 1e-9);
            EXPECT_EQ(reference.sight(*again), Sight::visible);
        }
    EXPECT_GT(seen, 50);
}

// Slide 13: the same colour from every angle, also where it is not seen.
TEST(ReferencePoint, APinnedPointKeepsItsColourWhereverTheCameraGoes) {
    Stage s;
    const auto hit = s.seen().surface(30, 14);
    ASSERT_TRUE(hit);
    const Probe<double> before = s.seen().probe(*hit);
    bool sights[4] = {};
    for (int i = 0; i < 40; ++i) {
        s.camera.position.setFromCylindricalCoords(4, 0.16 * i, 0.5 + 0.05 * i);
        s.camera.lookAt(0, i % 7 == 0 ? 9 : 0, 0);
        const Reference<double> reference = s.seen();
        const auto again = reference.surfaceAt(&s.knot, hit->triangle, hit->weights);
        ASSERT_TRUE(again);
        const Probe<double> now = reference.probe(*again);
        EXPECT_NEAR(glm::length(now.P - before.P), 0, 1e-12);
        EXPECT_NEAR(glm::length(now.Q - before.Q), 0, 1e-12);
        EXPECT_NEAR(glm::length(now.n - before.n), 0, 1e-12);
        sights[static_cast<int>(reference.sight(*again))] = true;
    }
    EXPECT_TRUE(sights[static_cast<int>(Sight::visible)]);
    EXPECT_TRUE(sights[static_cast<int>(Sight::turnedAway)]);
    EXPECT_TRUE(sights[static_cast<int>(Sight::outside)]);
}

TEST(ReferencePoint, WhatStandsInFrontHides) {
    Stage s;
    const auto hit = s.seen().surface(30, 14);
    ASSERT_TRUE(hit);
    // In a picture where the sheet is smaller than a pixel and between centres, the point's own ray still meets it.
    const int coarse = 30;
    THREE::PlaneGeometry sheet(0.004, 0.004);
    THREE::MeshBasicMaterial black(THREE::Color(0, 0, 0));
    THREE::Mesh screen(sheet, black);
    const Probe<double> probe = s.seen().probe(*hit);
    screen.position = probe.Q + probe.v * 1.5;
    screen.lookAt(s.camera.position);
    const Surface<double> pinned = *s.seen(coarse).surfaceAt(&s.knot, hit->triangle, hit->weights);
    EXPECT_EQ(s.seen(coarse).sight(pinned), Sight::visible);
    s.scene.add(screen);
    int covered = 0;
    for (int pixel = 0; pixel < coarse * coarse; ++pixel) {
        const auto seen = s.seen(coarse).surface(pixel % coarse, pixel / coarse);
        covered += seen && seen->body == 1 ? 1 : 0;
    }
    ASSERT_EQ(covered, 0);
    EXPECT_EQ(s.seen(coarse).sight(pinned), Sight::hidden);
    screen.position = probe.Q - probe.v * 0.01;
    EXPECT_EQ(s.seen(coarse).sight(pinned), Sight::visible) << "behind it";
    s.camera.far = 1;
    EXPECT_EQ(s.seen(coarse).sight(pinned), Sight::outside);
}

TEST(ReferencePoint, ThePointOfTheSideThatIsDrawn) {
    Stage s;
    THREE::PlaneGeometry sheet(2, 2);
    THREE::MeshLambertMaterial paint;
    THREE::Mesh plane(sheet, paint);
    s.scene.remove(s.knot);
    s.scene.add(plane);
    const glm::dvec3 middle(0.25, 0.25, 0.5);
    const auto normal = [&](THREE::Side side, double z) {
        paint.side = side;
        s.camera.position.set(0, 0, z);
        s.camera.lookAt(0, 0, 0);
        const Reference<double> reference = s.seen();
        const Surface<double> point = *reference.surfaceAt(&plane, 0, middle);
        return std::pair(std::round(point.n.z), reference.sight(point));
    };
    EXPECT_EQ(normal(THREE::FrontSide, 3), std::pair(1.0, Sight::visible));
    EXPECT_EQ(normal(THREE::FrontSide, -3), std::pair(1.0, Sight::turnedAway));
    EXPECT_EQ(normal(THREE::BackSide, -3), std::pair(-1.0, Sight::visible));
    EXPECT_EQ(normal(THREE::BackSide, 3), std::pair(-1.0, Sight::turnedAway));
    EXPECT_EQ(normal(THREE::DoubleSide, 3), std::pair(1.0, Sight::visible));
    EXPECT_EQ(normal(THREE::DoubleSide, -3), std::pair(-1.0, Sight::visible));
}

TEST(ReferencePoint, MeshesThatAreNotDrawnHaveNoPoints) {
    Stage s;
    const glm::dvec3 middle(0.25, 0.25, 0.5);
    EXPECT_TRUE(s.seen().surfaceAt(&s.knot, 3, middle));
    EXPECT_FALSE(s.seen().surfaceAt(&s.knot, s.shape.triangleCount(), middle));
    EXPECT_FALSE(s.seen().surfaceAt(nullptr, 3, middle));
    s.knot.visible = false;
    EXPECT_FALSE(s.seen().surfaceAt(&s.knot, 3, middle));
}

// What is drawn does not look at the scene any more, so that another thread may draw it.
TEST(ReferencePoint, DrawingNeedsNoScene) {
    auto s = std::make_unique<Stage>();
    const Reference<double> reference = s->seen();
    std::vector<glm::dvec3> first(61 * 61), second = first;
    const auto into = [](std::vector<glm::dvec3>& all) {
        return [&all](int x, int y, const glm::dvec3& P) { all[static_cast<std::size_t>(y * 61 + x)] = P; };
    };
    reference.draw(into(first));
    const auto hit = reference.surface(30, 14);
    ASSERT_TRUE(hit);
    const glm::dvec3 P = reference.probe(*hit).P;
    s.reset();
    reference.draw(into(second));
    EXPECT_EQ(first, second);
    EXPECT_EQ(reference.probe(*hit).P, P);
    EXPECT_EQ(reference.sight(*hit), Sight::visible);
}

TEST(ReferencePoint, PerVertexTheCornersAreTold) {
    Stage s;
    lighting::Switches switches;
    switches.shading = lighting::Shading::vertex;
    s.material.emissive = THREE::Color(0.125, 0, 0);
    const Reference<double> reference(s.scene, s.camera, switches, 61, 61);
    const Probe<double> p = reference.probe(30, 14);
    ASSERT_TRUE(p.corners);
    glm::dvec3 sum = p.emitted;
    for (int i = 0; i < 3; ++i)
        sum += (*p.corners)[static_cast<std::size_t>(i)] * p.weights[i];
    EXPECT_NEAR(glm::length(sum - p.P), 0, 1e-15);
    EXPECT_FALSE(s.seen().probe(30, 14).corners);
}

}  // namespace
