// The parametric geometries: three.js's vertices, hand-derived values, closedness, refused parameters.
// SPDX-License-Identifier: MIT
#include "three/geometries.hpp"

#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>

using namespace THREE;

namespace {

constexpr double pi = std::numbers::pi;

std::map<std::string, std::unique_ptr<BufferGeometry>> threejsExamples() {
    std::map<std::string, std::unique_ptr<BufferGeometry>> examples;
    examples["BoxGeometry(1,2,3,2,3,4)"] = std::make_unique<BoxGeometry>(1, 2, 3, 2, 3, 4);
    examples["SphereGeometry(1,16,12)"] = std::make_unique<SphereGeometry>(1, 16, 12);
    examples["PlaneGeometry(2,1,3,2)"] = std::make_unique<PlaneGeometry>(2, 1, 3, 2);
    examples["TorusGeometry(1,0.4,8,24)"] = std::make_unique<TorusGeometry>(1, 0.4, 8, 24);
    examples["TorusKnotGeometry(1,0.3,48,8,2,3)"] = std::make_unique<TorusKnotGeometry>(1, 0.3, 48, 8, 2, 3);
    examples["CylinderGeometry(0.5,1,2,12,2)"] = std::make_unique<CylinderGeometry>(0.5, 1, 2, 12, 2);
    return examples;
}

/// Equal after rounding to float, up to its last bit, or to 1e-7 near 0.
void expectSameFloats(const std::vector<double>& ours, const std::vector<double>& theirs) {
    ASSERT_EQ(ours.size(), theirs.size());
    for (std::size_t i = 0; i < ours.size(); ++i) {
        const auto a = static_cast<float>(ours[i]);
        const auto b = static_cast<float>(theirs[i]);
        const bool isSame = std::fabs(a - b) <= 1e-7F || std::nextafterf(a, b) == b;
        EXPECT_TRUE(isSame) << "number " << i << ": " << a << " instead of " << b;
    }
}

using Point = std::tuple<double, double, double>;
using Edge = std::pair<Point, Point>;

Point pointOf(const BufferGeometry& geometry, std::uint32_t vertex) {
    const Vector3 p = geometry.getAttribute("position")->getXYZ(vertex);
    return {p.x, p.y, p.z};
}

/// How often each directed edge occurs, in terms of points: vertices in the same place count as one.
/// Triangles that have two corners in one place (the tip of a cone) have no area and count nothing.
std::map<Edge, int> directedEdges(const BufferGeometry& geometry) {
    std::map<Edge, int> edges;
    std::uint32_t v[3];
    for (std::size_t t = 0; t < geometry.triangleCount(); ++t) {
        geometry.triangle(t, v);
        const Point a = pointOf(geometry, v[0]), b = pointOf(geometry, v[1]), c = pointOf(geometry, v[2]);
        if (a == b || b == c || c == a)
            continue;
        ++edges[{a, b}];
        ++edges[{b, c}];
        ++edges[{c, a}];
    }
    return edges;
}

std::size_t openEdges(const BufferGeometry& geometry) {
    const std::map<Edge, int> edges = directedEdges(geometry);
    std::size_t open = 0;
    for (const auto& [edge, count] : edges) {
        const auto opposite = edges.find({edge.second, edge.first});
        if (count != 1 || opposite == edges.end() || opposite->second != 1)
            ++open;
    }
    return open;
}

/// The enclosed volume: positive if the triangles face outwards.
double volume(const BufferGeometry& geometry) {
    double sum = 0;
    std::uint32_t v[3];
    for (std::size_t t = 0; t < geometry.triangleCount(); ++t) {
        geometry.triangle(t, v);
        const BufferAttribute& p = *geometry.getAttribute("position");
        sum += p.getXYZ(v[0]).dot(p.getXYZ(v[1]).cross(p.getXYZ(v[2])));
    }
    return sum / 6;
}

void expectUnitNormals(const BufferGeometry& geometry) {
    const BufferAttribute& normals = *geometry.getAttribute("normal");
    ASSERT_EQ(normals.count(), geometry.vertexCount());
    for (std::size_t i = 0; i < normals.count(); ++i)
        EXPECT_NEAR(normals.getXYZ(i).length(), 1, 1e-14) << geometry.type() << " vertex " << i;
}

/// The normals at a triangle's corners look to its front side.
void expectFacingNormals(const BufferGeometry& geometry) {
    BufferGeometry faces;
    geometry.toFaces(faces);
    const BufferAttribute& normals = *geometry.getAttribute("normal");
    const BufferAttribute& faceNormals = *faces.getAttribute("normal");
    std::uint32_t v[3];
    for (std::size_t t = 0; t < geometry.triangleCount(); ++t) {
        geometry.triangle(t, v);
        const Vector3 face = faceNormals.getXYZ(3 * t);
        if (face.length() == 0)
            continue;
        for (const std::uint32_t vertex : v)
            EXPECT_GT(face.dot(normals.getXYZ(vertex)), 0.5) << geometry.type() << " triangle " << t;
    }
}

void expectVertex(const BufferGeometry& geometry, std::size_t vertex, const Vector3& position,
                  const Vector3& normal, double u, double v) {
    const std::string where = std::string(geometry.type()) + " vertex " + std::to_string(vertex);
    EXPECT_LT(geometry.getAttribute("position")->getXYZ(vertex).distanceTo(position), 1e-14) << where;
    EXPECT_LT(geometry.getAttribute("normal")->getXYZ(vertex).distanceTo(normal), 1e-14) << where;
    EXPECT_NEAR(geometry.getAttribute("uv")->getX(vertex), u, 1e-15) << where;
    EXPECT_NEAR(geometry.getAttribute("uv")->getY(vertex), v, 1e-15) << where;
}

std::string refusal(const std::function<void()>& construct) {
    try {
        construct();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST(Geometries, MatchThreejs) {
    std::ifstream file(LAMBERT_SOURCE_DIR "/tests/threejs/geometries.json");
    ASSERT_TRUE(file) << "tests/threejs/geometries.json is missing";
    const nlohmann::json data = nlohmann::json::parse(file);
    const auto examples = threejsExamples();
    ASSERT_EQ(data.size(), examples.size());
    for (const auto& [call, ours] : examples) {
        SCOPED_TRACE(call);
        const nlohmann::json& theirs = data.at(call);
        expectSameFloats(ours->getAttribute("position")->array, theirs.at("positions"));
        expectSameFloats(ours->getAttribute("normal")->array, theirs.at("normals"));
        EXPECT_EQ(ours->index, theirs.at("indices").get<std::vector<std::uint32_t>>());
    }
}

TEST(Geometries, HaveThreejsDefaults) {
    using Parameters = std::vector<std::pair<std::string, double>>;
    EXPECT_EQ(BoxGeometry().parameters(), (Parameters{{"width", 1},
                                                      {"height", 1},
                                                      {"depth", 1},
                                                      {"widthSegments", 1},
                                                      {"heightSegments", 1},
                                                      {"depthSegments", 1}}));
    EXPECT_EQ(SphereGeometry().parameters(), (Parameters{{"radius", 1},
                                                         {"widthSegments", 32},
                                                         {"heightSegments", 16},
                                                         {"phiStart", 0},
                                                         {"phiLength", 2 * pi},
                                                         {"thetaStart", 0},
                                                         {"thetaLength", pi}}));
    EXPECT_EQ(PlaneGeometry().parameters(),
              (Parameters{{"width", 1}, {"height", 1}, {"widthSegments", 1}, {"heightSegments", 1}}));
    EXPECT_EQ(
        TorusGeometry().parameters(),
        (Parameters{
            {"radius", 1}, {"tube", 0.4}, {"radialSegments", 8}, {"tubularSegments", 6}, {"arc", 2 * pi}}));
    EXPECT_EQ(TorusKnotGeometry().parameters(), (Parameters{{"radius", 1},
                                                            {"tube", 0.4},
                                                            {"tubularSegments", 64},
                                                            {"radialSegments", 8},
                                                            {"p", 2},
                                                            {"q", 3}}));
    EXPECT_EQ(CylinderGeometry().parameters(), (Parameters{{"radiusTop", 1},
                                                           {"radiusBottom", 1},
                                                           {"height", 1},
                                                           {"radialSegments", 8},
                                                           {"heightSegments", 1},
                                                           {"openEnded", 0},
                                                           {"thetaStart", 0},
                                                           {"thetaLength", 2 * pi}}));
    EXPECT_EQ(SphereGeometry().vertexCount(), 33u * 17u);
    EXPECT_EQ(SphereGeometry().triangleCount(), 2u * 32u * 15u);
    EXPECT_EQ(CylinderGeometry().vertexCount(), 9u * 2u + 2u * (8u + 9u));
}

TEST(Geometries, HandDerivedVertices) {
    const PlaneGeometry plane(4, 2);
    expectVertex(plane, 0, {-2, 1, 0}, {0, 0, 1}, 0, 1);
    expectVertex(plane, 3, {2, -1, 0}, {0, 0, 1}, 1, 0);
    const BoxGeometry box(2, 4, 6);
    expectVertex(box, 0, {1, 2, 3}, {1, 0, 0}, 0, 1);
    expectVertex(box, 4, {-1, 2, -3}, {-1, 0, 0}, 0, 1);
    expectVertex(box, 8, {-1, 2, -3}, {0, 1, 0}, 0, 1);
    expectVertex(box, 23, {-1, -2, -3}, {0, 0, -1}, 1, 0);
    // Rows go from the north pole down; columns start on -x and turn towards +z.
    const SphereGeometry sphere(2, 4, 2);
    expectVertex(sphere, 0, {0, 2, 0}, {0, 1, 0}, 0.125, 1);
    expectVertex(sphere, 5, {-2, 0, 0}, {-1, 0, 0}, 0, 0.5);
    expectVertex(sphere, 6, {0, 0, 2}, {0, 0, 1}, 0.25, 0.5);
    expectVertex(sphere, 14, {0, -2, 0}, {0, -1, 0}, 0.875, 0);
    const TorusGeometry torus(3, 1, 4, 4);
    expectVertex(torus, 0, {4, 0, 0}, {1, 0, 0}, 0, 0);
    expectVertex(torus, 5, {3, 0, 1}, {0, 0, 1}, 0, 0.25);
    expectVertex(torus, 11, {0, 2, 0}, {0, -1, 0}, 0.25, 0.5);
    // A cone of 45 degrees: its side looks half outwards, half upwards.
    const CylinderGeometry cone(0, 1, 1, 4);
    expectVertex(cone, 5, {0, -0.5, 1}, {0, std::sqrt(0.5), std::sqrt(0.5)}, 0, 0);
    expectVertex(cone, 6, {1, -0.5, 0}, {std::sqrt(0.5), std::sqrt(0.5), 0}, 0.25, 0);
    expectVertex(cone, 10, {0, -0.5, 0}, {0, -1, 0}, 0.5, 0.5);
    expectVertex(cone, 15, {1, -0.5, 0}, {0, -1, 0}, 0.5, 0);
    EXPECT_EQ(cone.vertexCount(), 10u + 9u) << "a cone has no cap at its tip";
}

TEST(Geometries, ClosedOnesAreClosed) {
    // Segments such as 49, whose share of a size does not add up to it in doubles.
    EXPECT_EQ(openEdges(BoxGeometry(1, 2, 3, 49, 3, 7)), 0u);
    EXPECT_EQ(openEdges(BoxGeometry(0.1, 0.7, 1e9, 3, 10, 11)), 0u);
    EXPECT_EQ(openEdges(SphereGeometry(1.3, 49, 13)), 0u);
    EXPECT_EQ(openEdges(SphereGeometry(1, 3, 2, 0.3)), 0u);
    EXPECT_EQ(openEdges(TorusGeometry(1, 0.4, 13, 49)), 0u);
    EXPECT_EQ(openEdges(TorusKnotGeometry(1, 0.4, 100, 9)), 0u);
    EXPECT_EQ(openEdges(TorusKnotGeometry(0.7, 0.1, 199, 7, -3, 5)), 0u);
    EXPECT_EQ(openEdges(CylinderGeometry(0.7, 1.1, 2, 49, 7)), 0u);
    EXPECT_EQ(openEdges(CylinderGeometry(1, 0.1, 0.3, 12, 3, false, 0.5)), 0u);
    EXPECT_EQ(openEdges(CylinderGeometry(0, 1, 2, 12, 3)), 0u);
}

TEST(Geometries, OpenOnesAreOpen) {
    EXPECT_EQ(openEdges(PlaneGeometry(1, 1, 3, 2)), 10u);
    EXPECT_EQ(openEdges(CylinderGeometry(1, 1, 1, 8, 1, true)), 16u);
    EXPECT_EQ(openEdges(SphereGeometry(1, 8, 4, 0, 2 * pi, 0, pi / 2)), 8u);
    EXPECT_GT(openEdges(TorusGeometry(1, 0.4, 8, 6, pi)), 0u);
    EXPECT_GT(openEdges(TorusKnotGeometry(1, 0.4, 64, 8, 2.5, 3)), 0u);
}

TEST(Geometries, FaceOutwards) {
    EXPECT_NEAR(volume(BoxGeometry(1, 2, 3, 2, 3, 4)), 6, 1e-12);
    EXPECT_NEAR(volume(SphereGeometry(1, 200, 100)), 4 * pi / 3, 0.01);
    EXPECT_NEAR(volume(TorusGeometry(1, 0.4, 100, 200)), 2 * pi * pi * 0.16, 0.01);
    EXPECT_NEAR(volume(CylinderGeometry(1, 1, 2, 200)), 2 * pi, 0.01);
    EXPECT_NEAR(volume(CylinderGeometry(0, 1, 3, 200)), pi, 0.01);
    EXPECT_GT(volume(TorusKnotGeometry()), 0);
    for (const auto& [call, geometry] : threejsExamples()) {
        expectUnitNormals(*geometry);
        expectFacingNormals(*geometry);
    }
}

TEST(Geometries, AllHaveUvsInTheUnitSquareAndIndicesInside) {
    for (const auto& [call, geometry] : threejsExamples()) {
        const BufferAttribute& uv = *geometry->getAttribute("uv");
        EXPECT_EQ(uv.itemSize, 2);
        EXPECT_EQ(uv.count(), geometry->vertexCount()) << call;
        // At the poles of a sphere three.js goes half a column beyond the square.
        for (const double number : uv.array)
            EXPECT_TRUE(number >= -1.0 / 32 && number <= 1 + 1.0 / 32) << call << ": " << number;
        for (const std::uint32_t vertex : geometry->index)
            EXPECT_LT(vertex, geometry->vertexCount()) << call;
    }
}

TEST(Geometries, SegmentsAreWholeAndAtLeastTheMinimum) {
    EXPECT_EQ(SphereGeometry(1, 1, -7).vertexCount(), 4u * 3u);
    EXPECT_EQ(SphereGeometry(1, 5.9, 4.9).vertexCount(), 6u * 5u);
    EXPECT_EQ(PlaneGeometry(1, 1, 0, 2.9).vertexCount(), 2u * 3u);
    EXPECT_EQ(BoxGeometry(1, 1, 1, 0, -1, 0.5).vertexCount(), 24u);
    EXPECT_EQ(TorusGeometry(1, 0.4, 0, 0).vertexCount(), 4u);
    EXPECT_EQ(TorusKnotGeometry(1, 0.4, -1e300, 1).vertexCount(), 4u);
    EXPECT_EQ(CylinderGeometry(1, 1, 1, 0, 0, true).vertexCount(), 4u);
    EXPECT_EQ(PlaneGeometry(1, 1, 2.5).parameters()[2].second, 2.5) << "as given, for JSON";
}

TEST(Geometries, ExtremeSizesStayFinite) {
    std::vector<std::unique_ptr<BufferGeometry>> geometries;
    for (const double s : {0.0, -1.0, 1e-300, 1e-100, 1e100, 1e300, -1e300}) {
        geometries.push_back(std::make_unique<BoxGeometry>(s, s, s, 3, 3, 3));
        geometries.push_back(std::make_unique<SphereGeometry>(s, 8, 4));
        geometries.push_back(std::make_unique<SphereGeometry>(1, 8, 4, s, s, s, s));
        geometries.push_back(std::make_unique<PlaneGeometry>(s, s, 3, 3));
        geometries.push_back(std::make_unique<TorusGeometry>(s, s));
        geometries.push_back(std::make_unique<TorusGeometry>(1, s, 8, 6, s));
        geometries.push_back(std::make_unique<TorusKnotGeometry>(s, s));
        geometries.push_back(std::make_unique<TorusKnotGeometry>(1, s, 16, 4, 1, s));
        geometries.push_back(std::make_unique<CylinderGeometry>(s, -s, s));
        geometries.push_back(std::make_unique<CylinderGeometry>(1, 2, s, 8, 2, false, s, s));
    }
    for (const auto& geometry : geometries)
        for (const auto& [name, attribute] : geometry->attributes)
            for (const double number : attribute.array)
                ASSERT_TRUE(std::isfinite(number)) << geometry->type() << ' ' << name;
    for (const double s : {1e-100, 1e100, -1e300}) {
        expectUnitNormals(SphereGeometry(s, 8, 4));
        expectUnitNormals(TorusGeometry(1, s));
        expectUnitNormals(TorusKnotGeometry(s, s));
        expectUnitNormals(TorusKnotGeometry(1, 1e-30));
        expectUnitNormals(CylinderGeometry(1, 2, s));
    }
    expectUnitNormals(CylinderGeometry(1, 1, 0));
}

TEST(Geometries, RefuseNumbersThatAreNone) {
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity, 1.5e308}) {
        const auto box = refusal([&] { BoxGeometry(1, bad); });
        EXPECT_TRUE(box.starts_with("BoxGeometry: height: expected")) << box;
        EXPECT_NE(refusal([&] { SphereGeometry{bad}; }), "");
        EXPECT_NE(refusal([&] { SphereGeometry(1, bad); }).find("widthSegments"), std::string::npos);
        EXPECT_NE(refusal([&] { SphereGeometry(1, 8, 8, 0, 1, 0, bad); }).find("thetaLength"),
                  std::string::npos);
        EXPECT_NE(refusal([&] { PlaneGeometry(1, 1, 1, bad); }).find("heightSegments"), std::string::npos);
        EXPECT_NE(refusal([&] { TorusGeometry(1, 1, 8, 8, bad); }).find("arc"), std::string::npos);
        EXPECT_NE(refusal([&] { TorusKnotGeometry(1, bad); }).find("tube"), std::string::npos);
        EXPECT_NE(refusal([&] { CylinderGeometry(1, 1, 1, 8, 1, true, bad); }).find("thetaStart"),
                  std::string::npos);
    }
    EXPECT_NE(refusal([] { BoxGeometry(std::nan("")); }).find("found nan"), std::string::npos);
    const auto knot = refusal([] { TorusKnotGeometry(1, 0.4, 64, 8, 0, 3); });
    EXPECT_TRUE(knot.starts_with("TorusKnotGeometry: p: expected") && knot.ends_with("found 0")) << knot;
    EXPECT_NE(refusal([] { TorusKnotGeometry(1, 0.4, 64, 8, 1e-300, 1e20); }), "");
}

TEST(Geometries, RefuseTooManyVerticesBeforeMakingThem) {
    for (const double many : {6e7, 1e9, 1e18, 1e300}) {
        EXPECT_NE(refusal([&] { BoxGeometry(1, 1, 1, 1, 1, many); }).find("depthSegments"),
                  std::string::npos);
        EXPECT_NE(refusal([&] { SphereGeometry(1, many, many); }).find("at most 5000000"), std::string::npos);
        EXPECT_NE(refusal([&] { PlaneGeometry(1, 1, many); }), "");
        EXPECT_NE(refusal([&] { TorusGeometry(1, 1, many); }), "");
        EXPECT_NE(refusal([&] { TorusKnotGeometry(1, 1, 8, many); }), "");
        EXPECT_NE(refusal([&] { CylinderGeometry(1, 1, 1, many); }), "");
    }
    const auto plane = refusal([] { PlaneGeometry(1, 1, 9999, 500); });
    EXPECT_EQ(
        plane,
        "PlaneGeometry: widthSegments 9999, heightSegments 500: expected at most 5000000 vertices in all, "
        "found 5010000; use fewer segments");
    // Only the caps take this one beyond the limit.
    EXPECT_NE(refusal([] { CylinderGeometry(1, 1, 1, 1.5e6, 1); }), "");
}
