// BufferGeometry: normals of degenerate and extreme triangles, faces, bounds, and indices that point nowhere.
// SPDX-License-Identifier: MIT
#include "three/buffer_geometry.hpp"
#include "three/geometries.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <stdexcept>
#include <string>

using namespace THREE;

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

void setPositions(BufferGeometry& geometry, const std::vector<Vector3>& points) {
    std::vector<double> numbers;
    for (const Vector3& p : points)
        numbers.insert(numbers.end(), {p.x, p.y, p.z});
    geometry.setAttribute("position", numbers, 3);
}

Vector3 normalOf(const BufferGeometry& geometry, std::size_t vertex) {
    return geometry.getAttribute("normal")->getXYZ(vertex);
}

void expectNear(const Vector3& found, const Vector3& expected, double tolerance = 1e-15) {
    EXPECT_LE(found.distanceTo(expected), tolerance)
        << found.x << ", " << found.y << ", " << found.z << " instead of " << expected.x << ", " << expected.y
        << ", " << expected.z;
}

/// The normal that computeVertexNormals gives to a triangle on its own; toFaces must agree.
Vector3 normalOfTriangle(const Vector3& a, const Vector3& b, const Vector3& c) {
    BufferGeometry geometry, faces;
    setPositions(geometry, {a, b, c});
    geometry.computeVertexNormals();
    geometry.toFaces(faces);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(normalOf(geometry, i), normalOf(geometry, 0));
        EXPECT_EQ(normalOf(faces, i), normalOf(geometry, 0));
    }
    return normalOf(geometry, 0);
}

template <class Error, class Action>
std::string failure(Action action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST(BufferGeometry, StartsEmpty) {
    BufferGeometry geometry;
    EXPECT_EQ(geometry.vertexCount(), 0u);
    EXPECT_EQ(geometry.triangleCount(), 0u);
    EXPECT_EQ(geometry.getAttribute("position"), nullptr);
    EXPECT_TRUE(geometry.computeBoundingBox().isEmpty());
    EXPECT_LT(geometry.computeBoundingSphere().radius, 0);
    EXPECT_STREQ(geometry.type(), "BufferGeometry");
    EXPECT_TRUE(geometry.parameters().empty());
    BufferGeometry faces;
    geometry.toFaces(faces);
    EXPECT_EQ(faces.triangleCount(), 0u);
    geometry.computeVertexNormals();
    EXPECT_EQ(geometry.getAttribute("normal"), nullptr);
}

TEST(BufferGeometry, EachHasItsOwnId) {
    BufferGeometry a, b;
    const std::uint64_t first = a.id();
    EXPECT_NE(first, b.id());
    EXPECT_EQ(a.id(), first);
    std::uint64_t gone = 0;
    {
        BufferGeometry c;
        gone = c.id();
    }
    EXPECT_NE(BufferGeometry().id(), gone);
}

TEST(BufferGeometry, VersionGrowsWithEveryChange) {
    BufferGeometry geometry;
    std::uint64_t last = geometry.version();
    const auto expectGrown = [&](const char* what) {
        EXPECT_GT(geometry.version(), last) << what;
        last = geometry.version();
    };
    setPositions(geometry, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    expectGrown("setAttribute");
    geometry.setIndex({0, 1, 2});
    expectGrown("setIndex");
    geometry.computeVertexNormals();
    expectGrown("computeVertexNormals");
    geometry.needsUpdate();
    expectGrown("needsUpdate");
    geometry.computeBoundingSphere();
    EXPECT_EQ(geometry.version(), last);
}

TEST(BufferGeometry, TrianglesWithAndWithoutIndex) {
    BufferGeometry geometry;
    setPositions(geometry, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 0, 0}, {2, 2, 0}, {3, 3, 3}});
    std::uint32_t v[3];
    EXPECT_EQ(geometry.triangleCount(), 2u) << "the seventh vertex is none";
    geometry.triangle(1, v);
    EXPECT_TRUE(v[0] == 3 && v[1] == 4 && v[2] == 5);
    EXPECT_THROW(geometry.triangle(2, v), std::out_of_range);
    geometry.setIndex({2, 1, 0, 6, 5, 4, 3});
    EXPECT_EQ(geometry.triangleCount(), 2u);
    geometry.triangle(1, v);
    EXPECT_TRUE(v[0] == 6 && v[1] == 5 && v[2] == 4);
    EXPECT_THROW(geometry.triangle(2, v), std::out_of_range);
}

TEST(BufferGeometry, RefusesAttributesOfBrokenVertices) {
    BufferGeometry geometry;
    EXPECT_THROW(geometry.setAttribute("uv", {1, 2, 3}, 2), std::invalid_argument);
    EXPECT_THROW(geometry.setAttribute("uv", {1, 2}, 0), std::invalid_argument);
    EXPECT_THROW(geometry.setAttribute("uv", {1, 2}, -2), std::invalid_argument);
    EXPECT_EQ(geometry.getAttribute("uv"), nullptr);
    // By hand, past setAttribute.
    geometry.attributes["position"] = {{1, 2, 3, 4, 5, 6}, 0};
    EXPECT_EQ(geometry.vertexCount(), 0u);
    geometry.attributes["position"].itemSize = 2;
    BufferGeometry faces;
    EXPECT_THROW(geometry.computeVertexNormals(), std::invalid_argument);
    EXPECT_THROW(geometry.toFaces(faces), std::invalid_argument);
    EXPECT_THROW(geometry.computeBoundingBox(), std::invalid_argument);
    EXPECT_THROW(geometry.computeBoundingSphere(), std::invalid_argument);
}

TEST(BufferGeometry, NormalsAreCounterClockwiseAndWeightedByArea) {
    expectNear(normalOfTriangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), {0, 0, 1});
    expectNear(normalOfTriangle({0, 0, 0}, {0, 1, 0}, {1, 0, 0}), {0, 0, -1});
    // Two right triangles share the corner 0: one of area 1/2 facing +z, one of area 2 facing +x.
    BufferGeometry geometry;
    setPositions(geometry, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 2, 0}, {0, 0, 2}});
    geometry.setIndex({0, 1, 2, 0, 3, 4});
    geometry.computeVertexNormals();
    expectNear(normalOf(geometry, 0), {4 / std::sqrt(17), 0, 1 / std::sqrt(17)});
    expectNear(normalOf(geometry, 1), {0, 0, 1});
    expectNear(normalOf(geometry, 3), {1, 0, 0});
}

TEST(BufferGeometry, AreaCountsAlikeWhateverTheScale) {
    // The same two triangles, each scale with the same answer: squares of these areas leave the doubles.
    for (const double s : {1e-300, 1e-100, 1e-20, 1.0, 1e13, 1e100, 1e300}) {
        BufferGeometry geometry;
        setPositions(geometry, {{0, 0, 0}, {s, 0, 0}, {0, s, 0}, {0, 2 * s, 0}, {0, 0, 2 * s}});
        geometry.setIndex({0, 1, 2, 0, 3, 4});
        geometry.computeVertexNormals();
        expectNear(normalOf(geometry, 0), {4 / std::sqrt(17), 0, 1 / std::sqrt(17)});
    }
    // A minute triangle beside a giant one: scaled by the larger, it would vanish.
    BufferGeometry geometry;
    setPositions(geometry, {{0, 0, 0}, {1e-100, 0, 0}, {0, 1e-100, 0}, {0, 1e100, 0}, {0, 0, 1e100}});
    geometry.setIndex({0, 1, 2, 0, 3, 4});
    geometry.computeVertexNormals();
    expectNear(normalOf(geometry, 0), {1, 0, 0});
    expectNear(normalOf(geometry, 1), {0, 0, 1});
    expectNear(normalOf(geometry, 4), {1, 0, 0});
}

// accuracy.md G8
TEST(BufferGeometry, CollinearTrianglesCountNothing) {
    EXPECT_EQ(normalOfTriangle({0, 0, 0}, {1, 1, 1}, {2, 2, 2}), Vector3());
    EXPECT_EQ(normalOfTriangle({0, 0, 0}, {0.1, 0.2, 0.3}, {1, 2, 3}), Vector3()) << "rounded to doubles";
    EXPECT_EQ(normalOfTriangle({1, 2, 3}, {1, 2, 3}, {1, 2, 3}), Vector3());
    EXPECT_EQ(normalOfTriangle({1, 2, 3}, {1, 2, 3}, {4, 5, 7}), Vector3());
    BufferGeometry with, without;
    const std::vector<Vector3> points{{0, 0, 0}, {1, 0, 0.25}, {0, 1, 0}, {2, 0, 0.5}, {1, 1, 0.5}};
    setPositions(with, points);
    setPositions(without, points);
    without.setIndex({0, 1, 2, 1, 4, 2});
    with.setIndex({0, 1, 2, 0, 3, 1, 1, 4, 2});
    with.computeVertexNormals();
    without.computeVertexNormals();
    EXPECT_EQ(with.getAttribute("normal")->array, without.getAttribute("normal")->array);
    EXPECT_EQ(normalOf(with, 3), Vector3()) << "a vertex of no other triangle";
    EXPECT_NEAR(normalOf(with, 1).length(), 1, 1e-15);
}

// accuracy.md G9, G10
TEST(BufferGeometry, MinuteAndGiantTrianglesHaveUnitNormals) {
    const double third = 1 / std::sqrt(3);
    for (const double s : {5e-324, 1e-320, 1e-300, 1e-200, 1e-100, 1e-20, 1e13, 1e100, 1e200, 1e308})
        expectNear(normalOfTriangle({s, 0, 0}, {0, s, 0}, {0, 0, s}), {third, third, third});
    // A needle: its sharp angle vanishes in doubles, its area does not.
    expectNear(normalOfTriangle({0, 0, 0}, {1e100, 0, 0}, {0, 1e-100, 0}), {0, 0, 1});
    expectNear(normalOfTriangle({1e100, 0, 0}, {0, 1e-100, 0}, {0, 0, 0}), {0, 0, 1});
    expectNear(normalOfTriangle({0, 0, 0}, {1, 0, 0}, {1, 1e-17, 0}), {0, 0, 1});
    // Edges that are longer than any double.
    expectNear(normalOfTriangle({-1.7e308, 0, 0}, {1.7e308, 0, 0}, {0, 1.7e308, 0}), {0, 0, 1});
}

TEST(BufferGeometry, BadCoordinatesCountNothing) {
    for (const double bad : {notANumber, infinity, -infinity}) {
        BufferGeometry geometry;
        setPositions(geometry, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, bad, 0}});
        geometry.setIndex({0, 1, 2, 1, 3, 2});
        geometry.computeVertexNormals();
        expectNear(normalOf(geometry, 1), {0, 0, 1});
        EXPECT_EQ(normalOf(geometry, 3), Vector3());
        geometry.computeBoundingSphere();
    }
}

TEST(BufferGeometry, OppositeTrianglesCancel) {
    BufferGeometry geometry;
    setPositions(geometry, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    geometry.setIndex({0, 1, 2, 2, 1, 0});
    geometry.computeVertexNormals();
    EXPECT_EQ(normalOf(geometry, 0), Vector3());
}

TEST(BufferGeometry, ComputedNormalsOfASphereAreRadial) {
    SphereGeometry sphere(2, 64, 32);
    const BufferAttribute exact = *sphere.getAttribute("normal");
    sphere.computeVertexNormals();
    // No triangle uses the last vertex of the upper pole and the first of the lower one.
    const std::size_t unused[] = {64, 32 * 65};
    for (const std::size_t i : unused)
        EXPECT_EQ(normalOf(sphere, i), Vector3());
    for (std::size_t i = 0; i < sphere.vertexCount(); ++i)
        if (i != unused[0] && i != unused[1]) {
            EXPECT_GT(normalOf(sphere, i).dot(exact.getXYZ(i)), 0.99) << i;
        }
}

TEST(BufferGeometry, FacesHaveVerticesOfTheirOwn) {
    BufferGeometry geometry, faces;
    setPositions(geometry, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 0}});
    geometry.setAttribute("uv", {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, 2);
    geometry.setAttribute("normal", std::vector<double>(15, 0.5), 3);
    geometry.setAttribute("weight", {10, 11, 12, 13, 14}, 1);
    geometry.setIndex({0, 1, 2, 0, 2, 3, 0, 1, 4});
    faces.setIndex({9, 9, 9});
    const std::uint64_t version = faces.version();
    geometry.toFaces(faces);
    EXPECT_GT(faces.version(), version);
    EXPECT_TRUE(faces.index.empty());
    EXPECT_EQ(faces.vertexCount(), 9u);
    EXPECT_EQ(faces.attributes.size(), 4u);
    EXPECT_EQ(faces.getAttribute("uv")->array,
              (std::vector<double>{0, 1, 2, 3, 4, 5, 0, 1, 4, 5, 6, 7, 0, 1, 2, 3, 8, 9}));
    EXPECT_EQ(faces.getAttribute("weight")->array, (std::vector<double>{10, 11, 12, 10, 12, 13, 10, 11, 14}));
    EXPECT_EQ(faces.getAttribute("position")->getXYZ(5), Vector3(0, 0, 1));
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(normalOf(faces, i), Vector3(0, 0, 1));
        EXPECT_EQ(normalOf(faces, 3 + i), Vector3(1, 0, 0));
        EXPECT_EQ(normalOf(faces, 6 + i), Vector3()) << "degenerate";
    }
    EXPECT_EQ(geometry.vertexCount(), 5u);
}

TEST(BufferGeometry, FacesMayReplaceTheirOrigin) {
    BoxGeometry box(1, 2, 3), faces;
    box.toFaces(faces);
    box.toFaces(box);
    EXPECT_EQ(box.vertexCount(), 36u);
    for (const char* name : {"position", "normal", "uv"})
        EXPECT_EQ(box.getAttribute(name)->array, faces.getAttribute(name)->array);
}

TEST(BufferGeometry, IndicesBeyondTheVerticesAreNamed) {
    BufferGeometry geometry, faces;
    geometry.name = "roccia";
    setPositions(geometry, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    for (const std::uint32_t bad : {3u, 99u, 0xFFFFFFFFu}) {
        geometry.setIndex({0, 1, 2, 0, bad, 2});
        const auto expected =
            "BufferGeometry 'roccia': index[4]: expected less than 3, the number of vertices, found " +
            std::to_string(bad);
        EXPECT_EQ(failure<std::out_of_range>([&] { geometry.computeVertexNormals(); }), expected);
        EXPECT_EQ(failure<std::out_of_range>([&] { geometry.toFaces(faces); }), expected);
        EXPECT_EQ(geometry.getAttribute("normal"), nullptr) << "nothing half done";
        EXPECT_TRUE(faces.attributes.empty());
        EXPECT_EQ(geometry.computeBoundingBox().max, Vector3(1, 1, 0)) << "reads no index";
    }
    geometry.setIndex({});
    geometry.setAttribute("uv", {0, 0, 1, 1}, 2);
    const auto message = failure<std::invalid_argument>([&] { geometry.toFaces(faces); });
    EXPECT_NE(message.find("'uv': expected 3 vertices"), std::string::npos) << message;
    BufferGeometry noPositions;
    noPositions.setIndex({0, 0, 0});
    EXPECT_THROW(noPositions.toFaces(faces), std::out_of_range);
    EXPECT_NO_THROW(noPositions.computeVertexNormals());
}

TEST(BufferGeometry, Bounds) {
    BufferGeometry geometry;
    setPositions(geometry, {{-1, 2, 3}, {5, -2, 3}, {1, 0, 9}});
    geometry.setIndex({0, 1, 1});
    EXPECT_EQ(geometry.computeBoundingBox().min, Vector3(-1, -2, 3));
    EXPECT_EQ(geometry.computeBoundingBox().max, Vector3(5, 2, 9));
    EXPECT_EQ(geometry.computeBoundingSphere().center, Vector3(2, 0, 6));
    EXPECT_DOUBLE_EQ(geometry.computeBoundingSphere().radius, std::sqrt(9 + 4 + 9));
    EXPECT_EQ(geometry.boundingSphere().radius, geometry.computeBoundingSphere().radius);
    setPositions(geometry, {{7, 8, 9}});
    EXPECT_EQ(geometry.boundingSphere().center, Vector3(7, 8, 9));
    EXPECT_EQ(geometry.boundingSphere().radius, 0);
    EXPECT_DOUBLE_EQ(SphereGeometry(3).computeBoundingSphere().radius, 3);
}

TEST(BufferGeometry, BoundsPassOverWhatIsNoNumber) {
    BufferGeometry geometry;
    setPositions(geometry, {{notANumber, 1, 2}, {0, notANumber, 4}, {6, 3, notANumber}});
    EXPECT_EQ(geometry.computeBoundingBox().min, Vector3(0, 1, 2));
    EXPECT_EQ(geometry.computeBoundingBox().max, Vector3(6, 3, 4));
    EXPECT_TRUE(std::isfinite(geometry.computeBoundingSphere().radius));
    setPositions(geometry, {{notANumber, notANumber, notANumber}, {1, notANumber, notANumber}});
    EXPECT_TRUE(geometry.computeBoundingBox().isEmpty());
    EXPECT_LT(geometry.computeBoundingSphere().radius, 0);
    setPositions(geometry, {{1.7e308, 1.7e308, 1.7e308}, {1.6e308, 1.7e308, 1.7e308}});
    EXPECT_TRUE(std::isfinite(geometry.computeBoundingSphere().center.x));
}
