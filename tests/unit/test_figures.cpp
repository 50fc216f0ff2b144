// What interludes draw and count with: strokes, diagrams, lobes, and beams of rays.
// SPDX-License-Identifier: MIT
#include "lab/beam.hpp"
#include "lab/lobe.hpp"
#include "lab/strokes.hpp"
#include "three/three.hpp"
#include "three/validate.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <map>

namespace {

using lab::degree;
using THREE::Vector3;

// Where the geometry is not closed, or its normals look inwards: nothing for a good solid.
std::string complaint(const THREE::BufferGeometry& geometry) {
    std::map<std::array<long, 6>, int> edges;  // by the places of their ends
    const THREE::BufferAttribute &position = *geometry.getAttribute("position"),
                                 &normal = *geometry.getAttribute("normal");
    const auto rounded = [](double x) { return std::lround(x * 1e9); };
    for (std::size_t i = 0; i < geometry.triangleCount(); ++i) {
        std::uint32_t v[3];
        geometry.triangle(i, v);
        const Vector3 p[3] = {position.getXYZ(v[0]), position.getXYZ(v[1]), position.getXYZ(v[2])};
        const Vector3 face = Vector3(p[1]).sub(p[0]).cross(Vector3(p[2]).sub(p[0]));
        for (std::size_t k = 0; k < 3; ++k) {
            if (face.length() > 1e-12 && face.dot(normal.getXYZ(v[k])) <= 0)
                return "a normal looks inwards";
            const Vector3 &a = p[k], &b = p[(k + 1) % 3];
            ++edges[{rounded(a.x), rounded(a.y), rounded(a.z), rounded(b.x), rounded(b.y), rounded(b.z)}];
        }
    }
    for (const auto& [edge, count] : edges) {
        const auto back = edges.find({edge[3], edge[4], edge[5], edge[0], edge[1], edge[2]});
        if (back == edges.end() || back->second != count)
            return "an edge has one side only";
    }
    for (std::size_t i = 0; i < normal.count(); ++i)
        if (std::abs(normal.getXYZ(i).length() - 1) > 1e-12)
            return "a normal is not of unit length";
    return "";
}

void expectBox(const THREE::BufferGeometry& geometry, const Vector3& low, const Vector3& high,
               double bound = 1e-9) {
    EXPECT_LT(Vector3(geometry.boundingBox().min).sub(low).length(), bound);
    EXPECT_LT(Vector3(geometry.boundingBox().max).sub(high).length(), bound);
}

TEST(Strokes, EachIsASolidWhereItWasAskedFor) {
    lab::Strokes s;
    expectBox(s.clear().stick({1, 0, 0}, {1, 5, 0}, 0.1), {0.9, 0, -0.1}, {1.1, 5, 0.1});
    EXPECT_EQ(complaint(s), "");
    expectBox(s.clear().ball({1, 2, 3}, 0.5), {0.5, 1.5, 2.5}, {1.5, 2.5, 3.5});
    EXPECT_EQ(complaint(s), "");
    expectBox(s.clear().box({1, 5, 3}, {0, 2, 7}), {0, 2, 3}, {1, 5, 7});
    EXPECT_EQ(complaint(s), "");
    expectBox(s.clear().arrow({0, 0, 0}, {0, 3, 0}, 0.05), {-0.2, 0, -0.2}, {0.2, 3, 0.2});
    EXPECT_EQ(complaint(s), "");
    expectBox(s.clear().circle({0, 1, 0}, {0, 0, 2}, 1, 0.02), {-1.02, -0.02, -0.02}, {1.02, 2.02, 0.02},
              0.01);
    EXPECT_EQ(complaint(s), "");
    for (const Vector3& to : {Vector3(3, 2, 1), Vector3(-1, 0, 0), Vector3(0, 0, -2), Vector3(1, -4, 1)}) {
        EXPECT_EQ(complaint(s.clear().arrow({1, 2, 3}, to, 0.02)), "");
        EXPECT_EQ(complaint(s.clear().circle({1, 2, 3}, to, 0.5, 0.02)), "");
    }
}

TEST(Strokes, WithoutLengthThereIsABallAndNothingIsNothing) {
    lab::Strokes s;
    EXPECT_EQ(s.vertexCount(), 0U);
    expectBox(s.stick({1, 1, 1}, {1, 1, 1}, 0.5), {0.5, 0.5, 0.5}, {1.5, 1.5, 1.5});
    expectBox(s.clear().arrow({1, 1, 1}, {1, 1, 1}, 0.5), {0.5, 0.5, 0.5}, {1.5, 1.5, 1.5});
    const std::uint64_t version = s.version();
    s.clear();
    EXPECT_GT(s.version(), version) << "so that it is uploaded again";
    THREE::Scene scene;
    THREE::Mesh mesh(s);
    scene.add(mesh);
    scene.updateMatrixWorld();
    THREE::PerspectiveCamera camera;
    EXPECT_NO_THROW(THREE::validate(scene, camera)) << "a drawing may be empty";
}

TEST(Directions, AreMeasuredFromYAndAboutIt) {
    EXPECT_LT(lab::direction(0, 123).distanceTo({0, 1, 0}), 1e-15);
    EXPECT_LT(lab::direction(90, 0).distanceTo({1, 0, 0}), 1e-15);
    EXPECT_LT(lab::direction(90, 90).distanceTo({0, 0, -1}), 1e-15);
    EXPECT_LT(lab::along(lab::direction(60, 180), 2).distanceTo({-std::sqrt(3.0), 1, 0}), 1e-14);
}

TEST(Chart, PutsNumbersWhereTheyBelong) {
    const lab::Chart chart{{1, 2, 3}, 4, 2, 0, 180, 50};
    EXPECT_LT(chart.at(90, 25, 0.5).distanceTo({3, 3, 3.5}), 1e-15);
    lab::Strokes bars, curve;
    chart.bars(bars, 3, 0.1,
               [](double x) { return x < 100 ? 50 - x / 2 : 0; });  // at 0, 90 and, none, at 180
    expectBox(bars, {0.9, 2, 2.9}, {3.1, 4, 3.1});
    chart.curve(curve, 5, 0.01, [](double x) { return x / 180 * -50; });
    expectBox(curve, {1, 0, 3}, {5, 2, 3}, 0.05);
}

TEST(Lobe, IsAsFarAsTheFunctionSaysAndSmooth) {
    lab::Lobe lobe(12);
    const auto radius = [](const Vector3& w) { return 0.5 + w.y; };
    EXPECT_EQ(lobe.follow(radius, 2), 1);
    const THREE::BufferAttribute& position = *lobe.getAttribute("position");
    for (std::size_t i = 0; i < position.count(); ++i) {
        const Vector3 p = position.getXYZ(i);
        EXPECT_GE(p.y, 0);
        EXPECT_NEAR(p.length(), radius(Vector3(p).normalize()), 1e-12);
        EXPECT_GT(lobe.getAttribute("normal")->getXYZ(i).dot(p), 0) << "outwards";
    }
    EXPECT_DOUBLE_EQ(lobe.follow(radius, 0.75), 0.5) << "too long: as a whole half as large";
    EXPECT_NEAR(lobe.boundingBox().max.y, 0.75, 1e-12);
    EXPECT_EQ(lobe.follow([](const Vector3&) { return 0; }, 1), 1) << "black: a point";
}

// A patch 2 x 2 in the beam, its back side above a floor.
struct Patch {
    THREE::PlaneGeometry square{2, 2};
    THREE::MeshBasicMaterial front, back;
    THREE::Mesh patch{square, front}, reverse{square, back}, floor{square, front};
    lab::Beam beam{14, 5, 0.2, 0.4, 3};
    Patch() {
        back.side = THREE::BackSide;
        patch.add(reverse);
        floor.rotation.x = -90 * degree;
        floor.scale.setScalar(2);
        floor.position.y = -2;
    }
    int tilted(double alpha) {
        patch.rotation.set(-90 * degree, alpha * degree, 0);
        beam.strike({&patch, &reverse, &floor});
        EXPECT_EQ(beam.hits(patch) + beam.hits(reverse) + beam.hits(floor), 70)
            << "every ray ends somewhere, once";
        return beam.hits(patch);
    }
};

TEST(Beam, CountsWhatTheCosineLawSays) {
    Patch p;
    for (const auto& [alpha, hits] :
         {std::pair{0, 50}, {60, 25}, {90, 0}, {91, 0}, {120, 0}, {180, 0}, {270, 0}, {300, 25}, {360, 50}})
        EXPECT_EQ(p.tilted(alpha), hits) << alpha;
    for (double alpha = 0; alpha <= 180; alpha += 1.7) {
        const double expected = 50 * std::cos(alpha * degree);
        EXPECT_NEAR(p.tilted(alpha), std::max(0.0, expected), 1) << alpha;
        EXPECT_NEAR(p.beam.hits(p.reverse), std::max(0.0, -expected), 1)
            << "the back gets what the front does not";
    }
}

TEST(Beam, ItsRaysEndOnWhatTheyHit) {
    Patch p;
    p.tilted(30);
    const Vector3 n = lab::direction(30, 0);
    EXPECT_EQ(p.beam.raysTo(p.patch).size(), static_cast<std::size_t>(p.beam.hits(p.patch)));
    for (const Vector3& point : p.beam.pointsOn(p.patch))
        EXPECT_NEAR(point.dot(n), 0, 1e-12);
    for (const lab::Segment& ray : p.beam.raysTo(p.floor)) {
        EXPECT_NEAR(ray.to.y, -2, 1e-12);
        EXPECT_EQ(ray.from.y, 3);
        EXPECT_EQ(ray.from.x, ray.to.x);
    }
    p.beam.strike({});
    EXPECT_EQ(p.beam.hits(p.patch), 0);
    p.patch.position.y = 10;
    p.beam.strike({&p.patch});
    EXPECT_EQ(p.beam.hits(p.patch), 0) << "what is above the light is not met";
}

TEST(Beam, IsEvenSeenAlongItsRows) {
    Patch p;
    p.tilted(0);
    std::vector<double> x;
    for (const auto* mesh : {&p.patch, &p.floor})
        for (const lab::Segment& ray : p.beam.raysTo(*mesh))
            x.push_back(ray.from.x);
    std::sort(x.begin(), x.end());
    for (std::size_t i = 1; i < x.size(); ++i)
        EXPECT_NEAR(x[i] - x[i - 1], 0.04, 1e-12);
}

}  // namespace
