// Which geometries hide their own back faces from an eye outside.
// SPDX-License-Identifier: MIT
#include "three/three.hpp"

#include <gtest/gtest.h>
#include <memory>
#include <numbers>

namespace {

constexpr double pi = std::numbers::pi;

template <class G, class... Arguments>
bool isSolid(Arguments... arguments) {
    return G(arguments...).hidesItsBacks();
}

TEST(Solid, AllParametricGeometries) {
    EXPECT_TRUE((isSolid<THREE::BoxGeometry>(1.0, 2.0, 3.0)));
    EXPECT_TRUE((isSolid<THREE::BoxGeometry>(0.1, 0.3, 0.7, 3.0, 2.0, 5.0)));
    EXPECT_TRUE((isSolid<THREE::SphereGeometry>(1.0, 32.0, 16.0)));
    EXPECT_TRUE((isSolid<THREE::SphereGeometry>(0.3, 3.0, 2.0)));
    EXPECT_TRUE((isSolid<THREE::CylinderGeometry>(1.0, 1.0, 2.0)));
    EXPECT_TRUE((isSolid<THREE::CylinderGeometry>(0.3, 1.0, 2.0, 17.0, 4.0)));
    EXPECT_TRUE((isSolid<THREE::CylinderGeometry>(0.0, 1.0, 2.0, 8.0, 3.0))) << "a cone";
    EXPECT_TRUE((isSolid<THREE::CylinderGeometry>(1.0, 0.0, 2.0))) << "on its tip";
    EXPECT_FALSE((isSolid<THREE::PlaneGeometry>(1.0, 1.0)));
}

TEST(Solid, TubesThatStayClearOfThemselves) {
    EXPECT_TRUE((isSolid<THREE::TorusGeometry>(1.0, 0.4)));
    EXPECT_FALSE((isSolid<THREE::TorusGeometry>(1.0, 1.2))) << "it crosses its own middle";
    EXPECT_TRUE((isSolid<THREE::TorusGeometry>(1.0, -0.4))) << "the same one";
    EXPECT_TRUE((isSolid<THREE::TorusKnotGeometry>(0.9, 0.34, 400.0, 64.0))) << "the lessons' own";
    EXPECT_TRUE((isSolid<THREE::TorusKnotGeometry>(1.0, 0.3, 200.0, 16.0)));
    EXPECT_FALSE((isSolid<THREE::TorusKnotGeometry>(1.0, 0.6, 400.0, 64.0))) << "stretches touch";
    EXPECT_FALSE((isSolid<THREE::TorusKnotGeometry>(1.0, 0.3, 200.0, 16.0, 2.0, 4.0))) << "goes round twice";
    EXPECT_FALSE((isSolid<THREE::TorusKnotGeometry>(1.0, 0.3, 200.0, 16.0, 2.5, 3.0))) << "does not close";
    EXPECT_FALSE((isSolid<THREE::TorusKnotGeometry>(1.0, 0.3, 12.0, 16.0))) << "too coarse to tell";
    THREE::TorusKnotGeometry changed(1.0, 0.3, 200.0, 16.0);
    changed.needsUpdate();
    EXPECT_FALSE(changed.hidesItsBacks()) << "somebody may have moved its vertices";
}

TEST(Solid, PartsOfThemAreOpenOrConcave) {
    EXPECT_FALSE((isSolid<THREE::SphereGeometry>(1.0, 16.0, 8.0, 0.0, pi))) << "half round";
    EXPECT_FALSE((isSolid<THREE::SphereGeometry>(1.0, 16.0, 8.0, 0.0, 2 * pi, 0.0, pi / 2))) << "a dome";
    EXPECT_FALSE((isSolid<THREE::CylinderGeometry>(1.0, 1.0, 2.0, 8.0, 1.0, true))) << "open";
    EXPECT_FALSE((isSolid<THREE::CylinderGeometry>(1.0, 1.0, 2.0, 8.0, 1.0, false, 0.0, pi)));
    EXPECT_FALSE((isSolid<THREE::TorusGeometry>(1.0, 0.4, 8.0, 6.0, pi)));
}

// A geometry of its own, which tests change.
struct Tetrahedron : testing::Test {
    THREE::BufferGeometry geometry;
    Tetrahedron() {
        geometry.setAttribute("position", {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, 3);
        geometry.setIndex({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
    }
    std::vector<double>& positions() { return geometry.attributes.at("position").array; }
};

TEST_F(Tetrahedron, IsOneUntilItIsChanged) {
    EXPECT_TRUE(geometry.hidesItsBacks());
    for (std::size_t i = 0; i < 12; i += 3)
        std::swap(geometry.index[i], geometry.index[i + 1]);
    EXPECT_TRUE(geometry.hidesItsBacks()) << "nobody said that it changed";
    geometry.needsUpdate();
    EXPECT_FALSE(geometry.hidesItsBacks()) << "inside out";
}

TEST_F(Tetrahedron, AFaceTooFewTooManyOrTurned) {
    std::vector<std::uint32_t> index = geometry.index;
    index.resize(9);
    geometry.setIndex(index);
    EXPECT_FALSE(geometry.hidesItsBacks()) << "open";
    geometry.setIndex({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 3, 2});
    EXPECT_FALSE(geometry.hidesItsBacks()) << "one face inwards";
    geometry.setIndex({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3, 1, 2, 3});
    EXPECT_FALSE(geometry.hidesItsBacks()) << "one face twice";
}

TEST_F(Tetrahedron, SeamsAndEmptyTrianglesDoNotMatter) {
    positions().insert(positions().end(), {-0.0, 0, 1});  // vertex 3 again, with another zero
    geometry.setIndex({0, 2, 1, 0, 1, 4, 0, 3, 2, 1, 2, 3, 3, 4, 0});
    EXPECT_TRUE(geometry.hidesItsBacks());
    positions()[14] = 1.001;
    geometry.needsUpdate();
    EXPECT_FALSE(geometry.hidesItsBacks()) << "the seam gapes";
}

TEST_F(Tetrahedron, ADentIsNoneOfIt) {
    // Two of them, base to base, the lower tip pushed in through the base.
    for (const double tip : {-1.0, -0.2, 0.2, 0.5}) {
        positions() = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0.2, 0.2, 1, 0.2, 0.2, tip};
        geometry.setIndex({0, 1, 3, 1, 2, 3, 2, 0, 3, 1, 0, 4, 2, 1, 4, 0, 2, 4});
        EXPECT_EQ(geometry.hidesItsBacks(), tip < 0) << tip;
    }
}

TEST(Solid, NothingIsNone) {
    THREE::BufferGeometry geometry;
    EXPECT_FALSE(geometry.hidesItsBacks());
    geometry.setAttribute("position", {}, 3);
    EXPECT_FALSE(geometry.hidesItsBacks());
    geometry.setAttribute("position", {0, 0, 0, 0, 0, 0, 0, 0, 0}, 3);
    EXPECT_FALSE(geometry.hidesItsBacks());
}

}  // namespace
