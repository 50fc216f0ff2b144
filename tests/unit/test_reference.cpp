// The reference's rasteriser and probe, on scenes whose answer one can count or write down.
// SPDX-License-Identifier: MIT
#include "lighting/reference/reference.hpp"
#include "three/three.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <mutex>

namespace {

using lighting::Term;
using lighting::TermSet;
using lighting::reference::Probe;
using lighting::reference::Reference;
using lighting::reference::Surface;

// A camera 2 away from the plane z = 0, which sees 2 x 2 units of it.
struct Facing {
    THREE::Scene scene;
    THREE::PerspectiveCamera camera{2 * std::atan(0.5) * 180 / 3.14159265358979323846, 1, 0.1, 10};
    Facing() { camera.position.set(0, 0, 2); }
    Reference<double> seen(int width, int height, const TermSet& terms = TermSet::all()) {
        camera.aspect = static_cast<double>(width) / height;
        return Reference<double>(scene, camera, terms, width, height);
    }
};

std::vector<glm::dvec3> pixels(const Reference<double>& reference) {
    std::vector<glm::dvec3> all(static_cast<std::size_t>(reference.width() * reference.height()),
                                glm::dvec3(-1));
    reference.draw([&](int x, int y, const glm::dvec3& P) {
        all[static_cast<std::size_t>(y * reference.width() + x)] = P;
    });
    return all;
}

TEST(Reference, EveryPixelOnceAndTheBackgroundWhereNothingIs) {
    Facing s;
    s.scene.background = THREE::Color(0.25, 0.5, 0.75);
    for (const auto& P : pixels(s.seen(37, 23)))
        EXPECT_EQ(P, glm::dvec3(0.25, 0.5, 0.75));
}

// A fan of triangles around a pixel's centre, its edges through centres of other pixels: all are covered, none twice.
TEST(Reference, PixelsOnSharedEdgesBelongToOneTriangle) {
    Facing s;
    THREE::BufferGeometry fan;
    std::vector<double> corners;
    for (int i = 0; i < 8; ++i) {
        const double a = i * std::acos(-1.0) / 4, b = (i + 1) * std::acos(-1.0) / 4;
        corners.insert(corners.end(),
                       {0, 0, 0, 2 * std::cos(a), 2 * std::sin(a), 0, 2 * std::cos(b), 2 * std::sin(b), 0});
    }
    fan.setAttribute("position", corners, 3);
    THREE::MeshBasicMaterial material(THREE::Color(1, 1, 1));
    THREE::Mesh mesh(fan, material);
    s.scene.add(mesh);
    for (const auto& P : pixels(s.seen(33, 33)))  // odd, so that the fan's middle is a pixel's centre
        EXPECT_EQ(P, glm::dvec3(1)) << "a hole";
    // Each triangle alone: together they cover as many pixels as there are.
    std::size_t covered = 0;
    for (std::size_t i = 0; i < 8; ++i) {
        fan.setAttribute("position",
                         {corners.begin() + static_cast<std::ptrdiff_t>(9 * i),
                          corners.begin() + static_cast<std::ptrdiff_t>(9 * i + 9)},
                         3);
        for (const auto& P : pixels(s.seen(33, 33)))
            covered += P == glm::dvec3(1) ? 1U : 0U;
    }
    EXPECT_EQ(covered, 33U * 33U);
}

TEST(Reference, TheProbeTellsEveryFactor) {
    Facing s;
    THREE::PlaneGeometry geometry(6, 6);
    THREE::MeshLambertMaterial material(THREE::Color(0.5, 0.25, 1));
    material.emissive = THREE::Color(0, 0, 0.125);
    THREE::Mesh plane(geometry, material);
    THREE::DirectionalLight sun(THREE::Color(1, 0.5, 0.25), 2);
    sun.position.set(3, 0, 4);
    THREE::PointLight bulb(THREE::Color(1, 1, 1), 3, 0, 2);
    bulb.position.set(0, 0, 0.5);
    THREE::AmbientLight ambient(THREE::Color(0.1, 0.1, 0.1));
    s.scene.add(plane, sun, bulb, ambient);
    const Probe<double> p = s.seen(65, 65).probe(32, 32);
    EXPECT_EQ(p.mesh, &plane);
    EXPECT_NEAR(glm::length(p.Q), 0, 1e-15);
    EXPECT_NEAR(p.n.z, 1, 1e-15);
    EXPECT_NEAR(p.depth, 2, 1e-15);
    ASSERT_EQ(p.addends.size(), 2U);
    EXPECT_EQ(p.addends[0].light, &sun);
    EXPECT_NEAR(p.addends[0].w.x, 0.6, 1e-15);
    EXPECT_NEAR(p.addends[0].cosine, 0.8, 1e-15);
    EXPECT_EQ(p.addends[0].f, 1);
    EXPECT_NEAR(p.addends[0].value.g, 0.8 * 0.25 * 1, 1e-15);
    EXPECT_EQ(p.addends[1].light, &bulb);
    EXPECT_NEAR(p.addends[1].d, 0.5, 1e-15);
    EXPECT_NEAR(p.addends[1].f, 4, 1e-14);
    EXPECT_NEAR(p.addends[1].value.b, 12, 1e-13);
    EXPECT_NEAR(p.ambient.r, 0.05, 1e-15);
    EXPECT_EQ(p.emitted.b, 0.125);
    const glm::dvec3 sum = p.addends[0].value + p.addends[1].value + p.ambient + p.emitted;
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(p.P[c], sum[c], 1e-14);
}

TEST(Reference, TheProbeShowsLightFromBehindBeforeAndAfterTheClamp) {
    Facing s;
    THREE::PlaneGeometry geometry(6, 6);
    THREE::MeshLambertMaterial material(THREE::Color(1, 1, 1));
    THREE::Mesh plane(geometry, material);
    THREE::DirectionalLight behind;
    behind.position.set(0, 0, -1);
    s.scene.add(plane, behind);
    const Probe<double> p = s.seen(5, 5).probe(2, 2);
    ASSERT_EQ(p.addends.size(), 1U);
    EXPECT_NEAR(p.addends[0].cosine, -1, 1e-15);
    EXPECT_EQ(p.addends[0].clamped, 0);
    EXPECT_EQ(p.P, glm::dvec3(0));
    EXPECT_NEAR(s.seen(5, 5, TermSet::all().without(Term::clamp)).probe(2, 2).P.r, -1, 1e-15);
}

TEST(Reference, ProbeAndDrawAgreeEverywhere) {
    Facing s;
    THREE::TorusKnotGeometry geometry(0.5, 0.2, 60, 12);
    THREE::MeshLambertMaterial material(THREE::Color(0xFF8855));
    THREE::Mesh knot(geometry, material);
    knot.rotation.set(0.4, 0.2, 0);
    THREE::PointLight bulb(THREE::Color(0xDD6666), 2, 0, 1);
    bulb.position.set(1, 1, 1);
    s.scene.add(knot, bulb);
    const Reference<double> reference = s.seen(40, 30);
    const auto all = pixels(reference);
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x)
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(reference.probe(x, y).P[c], all[static_cast<std::size_t>(y * 40 + x)][c], 1e-15);
}

// A floor that runs from behind the eye to the horizon: no clipping, and perspective-correct all the way.
TEST(Reference, TrianglesThatReachBehindTheEye) {
    Facing s;
    s.camera.position.set(0, 1, 0);
    THREE::PlaneGeometry geometry(40, 40);
    THREE::MeshLambertMaterial material;
    THREE::Mesh floor(geometry, material);
    floor.rotation.x = -std::acos(0.0);
    s.scene.add(floor);
    const Reference<double> reference = s.seen(64, 64);
    int covered = 0;
    for (int y = 0; y < 64; ++y) {
        const std::optional<Surface<double>> hit = reference.surface(20, y);
        if (!hit)
            continue;
        ++covered;
        EXPECT_NEAR(hit->Q.y, -1, 1e-12) << "relative to the eye";
        const double slope = (2 * (y + 0.5) / 64 - 1) * 0.5;  // of the ray, downwards
        EXPECT_NEAR(hit->depth, 1 / slope, 1e-9 / slope);
    }
    EXPECT_GT(covered, 25);
    EXPECT_LT(covered, 33);
}

TEST(Reference, NearAndFarCutOff) {
    Facing s;
    THREE::PlaneGeometry geometry(6, 6);
    THREE::MeshBasicMaterial material(THREE::Color(1, 1, 1));
    THREE::Mesh plane(geometry, material);
    s.scene.add(plane);
    EXPECT_TRUE(s.seen(3, 3).surface(1, 1));
    s.camera.near = 2.001;
    EXPECT_FALSE(s.seen(3, 3).surface(1, 1));
    s.camera.near = 0.1;
    s.camera.far = 1.999;
    EXPECT_FALSE(s.seen(3, 3).surface(1, 1));
}

TEST(Reference, SidesAndMirrors) {
    const auto normal = [](THREE::Side side, double scale, double turn) {
        Facing s;
        THREE::PlaneGeometry geometry(6, 6);
        THREE::MeshLambertMaterial material;
        material.side = side;
        THREE::Mesh plane(geometry, material);
        plane.scale.x = scale;
        plane.rotation.y = turn;
        s.scene.add(plane);
        const std::optional<Surface<double>> hit = s.seen(3, 3).surface(1, 1);
        return hit ? std::round(hit->n.z) : 0.0;
    };
    const double half = std::acos(-1.0);
    EXPECT_EQ(normal(THREE::FrontSide, 1, 0), 1);
    EXPECT_EQ(normal(THREE::FrontSide, -1, 0), 1) << "a mirror keeps the front in front";
    EXPECT_EQ(normal(THREE::FrontSide, 1, half), 0) << "culled";
    EXPECT_EQ(normal(THREE::BackSide, 1, half), 1) << "turned towards the eye";
    EXPECT_EQ(normal(THREE::BackSide, 1, 0), 0);
    EXPECT_EQ(normal(THREE::DoubleSide, 1, half), 1);
}

TEST(Reference, EdgesAreSilhouettesAndCreasesOnly) {
    Facing s;
    THREE::SphereGeometry geometry(0.6, 48, 24);
    THREE::MeshLambertMaterial material;
    THREE::Mesh ball(geometry, material);
    s.scene.add(ball);
    const auto count = [&s] {
        const std::vector<std::uint8_t> mask = s.seen(64, 64).edges();
        return std::count(mask.begin(), mask.end(), 1);
    };
    const auto smooth = count();  // a circle of some 130 pixels, two or three wide
    EXPECT_GT(smooth, 100);
    EXPECT_LT(smooth, 500);
    material.flatShading = true;
    EXPECT_GT(count(), 2 * smooth) << "every edge of a flat triangle is a crease";
}

TEST(Reference, ExceptionsOfThreadsArrive) {
    EXPECT_THROW(lighting::reference::onAllCores(
                     100, [](int i) { i == 57 ? throw std::runtime_error("57") : void(); }),
                 std::runtime_error);
    std::vector<int> seen(1000, 0);
    lighting::reference::onAllCores(1000, [&seen](int i) { ++seen[static_cast<std::size_t>(i)]; });
    EXPECT_EQ(seen, std::vector<int>(1000, 1));
}

}  // namespace
