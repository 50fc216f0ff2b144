// Unit tests of Euler angles and quaternions: the six orders, gimbal lock, and numbers near the ends of double.
// SPDX-License-Identifier: MIT
#include "three/rotation.hpp"

#include <array>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <ostream>
#include <string>

namespace {

using THREE::Euler;
using THREE::EulerOrder;
using THREE::Quaternion;
using THREE::Vector3;

constexpr double pi = std::numbers::pi;

struct OrderCase {
    const char* name;
    EulerOrder order;
    int axes[3];  // leftmost factor of the product first
    Vector3 imageOf123;  // of (1,2,3) after a quarter turn about each axis
};

void PrintTo(const OrderCase& c, std::ostream* out) { *out << c.name; }

// Quarter turns only permute and negate: Rx (x,y,z) = (x,-z,y), Ry (x,y,z) = (z,y,-x), Rz (x,y,z) = (-y,x,z).
// XYZ, for one: Rz (1,2,3) = (-2,1,3), then Ry gives (3,1,2), then Rx gives (3,-2,1).
const OrderCase orders[] = {
    {"XYZ", EulerOrder::XYZ, {0, 1, 2}, {3, -2, 1}}, {"YXZ", EulerOrder::YXZ, {1, 0, 2}, {1, -3, 2}},
    {"ZXY", EulerOrder::ZXY, {2, 0, 1}, {-1, 3, 2}}, {"ZYX", EulerOrder::ZYX, {2, 1, 0}, {3, 2, -1}},
    {"YZX", EulerOrder::YZX, {1, 2, 0}, {2, 1, -3}}, {"XZY", EulerOrder::XZY, {0, 2, 1}, {-2, 1, 3}},
};

// The textbook matrix of a turn about one axis, written row by row.
glm::dmat3 turnAbout(int axis, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    const double rows[3][3][3] = {{{1, 0, 0}, {0, c, -s}, {0, s, c}},
                                  {{c, 0, s}, {0, 1, 0}, {-s, 0, c}},
                                  {{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};
    glm::dmat3 m;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            m[column][row] = rows[axis][row][column];
    return m;
}

glm::dmat3 expectedMatrix(const OrderCase& c, const std::array<double, 3>& angle) {
    glm::dmat3 product(1.0);
    for (const int axis : c.axes)
        product = product * turnAbout(axis, angle[static_cast<std::size_t>(axis)]);
    return product;
}

glm::dmat3 matrixOf(const Quaternion& q) { return glm::mat3_cast(glm::dquat(q)); }

double largestDifference(const glm::dmat3& a, const glm::dmat3& b) {
    double largest = 0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) {
            const double difference = std::abs(a[column][row] - b[column][row]);
            if (!(difference <= largest))  // NaN counts as the largest
                largest = difference;
        }
    return largest;
}

class EulerOrders : public testing::TestWithParam<OrderCase> {};

TEST_P(EulerOrders, QuarterTurnsMoveAPointAsDerivedByHand) {
    const OrderCase& c = GetParam();
    const Quaternion q = Quaternion().setFromEuler(Euler(pi / 2, pi / 2, pi / 2, c.order));
    const Vector3 image = matrixOf(q) * glm::dvec3(1, 2, 3);
    EXPECT_NEAR(image.x, c.imageOf123.x, 1e-14);
    EXPECT_NEAR(image.y, c.imageOf123.y, 1e-14);
    EXPECT_NEAR(image.z, c.imageOf123.z, 1e-14);
}

TEST_P(EulerOrders, QuaternionMeansTheProductOfThreeTurns) {
    const OrderCase& c = GetParam();
    for (const std::array<double, 3>& angle :
         {std::array{0.3, -0.7, 1.1}, std::array{-2.9, 1.5, 0.2}, std::array{3.1, -3.0, 2.2}}) {
        const Quaternion q = Quaternion().setFromEuler(Euler(angle[0], angle[1], angle[2], c.order));
        EXPECT_LT(largestDifference(matrixOf(q), expectedMatrix(c, angle)), 1e-15 * 8);
        EXPECT_NEAR(q.length(), 1, 1e-15);
    }
}

TEST_P(EulerOrders, AnglesComeBackFromTheMatrix) {
    const OrderCase& c = GetParam();
    const auto middle = static_cast<std::size_t>(c.axes[1]);
    for (const double outer : {-3.0, -1.6, -0.1, 0.0, 0.4, 1.6, 3.1})
        for (const double between : {-1.5, -0.8, 0.0, 0.8, 1.5}) {
            std::array<double, 3> angle{outer, outer / 2 + 1, outer};
            angle[middle] = between;
            const Euler found = Euler().setFromRotationMatrix(glm::dmat4(expectedMatrix(c, angle)), c.order);
            EXPECT_EQ(found.order(), c.order);
            EXPECT_NEAR(found.x, angle[0], 1e-13);
            EXPECT_NEAR(found.y, angle[1], 1e-13);
            EXPECT_NEAR(found.z, angle[2], 1e-13);
        }
}

TEST_P(EulerOrders, GimbalLockKeepsTheRotationAndPutsTheLastAngleToZero) {
    const OrderCase& c = GetParam();
    const auto first = static_cast<std::size_t>(c.axes[0]);
    const auto middle = static_cast<std::size_t>(c.axes[1]);
    const auto last = static_cast<std::size_t>(c.axes[2]);
    for (const double sign : {-1.0, 1.0}) {
        std::array<double, 3> angle{};
        angle[first] = 0.4;
        angle[middle] = sign * pi / 2;
        angle[last] = 0.9;
        const glm::dmat3 wanted = expectedMatrix(c, angle);
        const Euler found = Euler().setFromRotationMatrix(glm::dmat4(wanted), c.order);
        const std::array<double, 3> back{found.x, found.y, found.z};
        EXPECT_EQ(back[last], 0);
        EXPECT_NEAR(std::abs(back[middle]), pi / 2, 1e-7);
        EXPECT_LT(largestDifference(expectedMatrix(c, back), wanted), 1e-7);
    }
}

INSTANTIATE_TEST_SUITE_P(Six, EulerOrders, testing::ValuesIn(orders),
                         [](const auto& c) { return std::string(c.param.name); });

TEST(Euler, SettingThreeAnglesKeepsTheOrderAndSettingFourChangesIt) {
    Euler e(0, 0, 0, EulerOrder::ZYX);
    e.set(1, 2, 3);
    EXPECT_EQ(e.order(), EulerOrder::ZYX);
    e.set(1, 2, 3, EulerOrder::YXZ);
    EXPECT_EQ(e.order(), EulerOrder::YXZ);
    Euler copied;
    copied.copy(e);
    EXPECT_EQ(copied.order(), EulerOrder::YXZ);
    EXPECT_EQ(copied.x, 1);
    EXPECT_EQ(copied.y, 2);
    EXPECT_EQ(copied.z, 3);
}

struct Counter final : THREE::ChangeListener {
    void changed() override { ++count; }
    int count = 0;
};

TEST(Euler, EachWriteIsToldOnceAndSilentOnesAreNot) {
    Counter counter;
    Euler e;
    e.listen(&counter);
    e.x += 0.1;
    e.y = 2;
    e.z *= 3;
    EXPECT_EQ(counter.count, 3);
    e.set(1, 2, 3);
    e = Euler(4, 5, 6);
    EXPECT_EQ(counter.count, 5);
    e.setSilently(Euler(7, 8, 9));
    EXPECT_EQ(counter.count, 5);
    EXPECT_EQ(e.x, 7);
}

// A copy outlives the object it came from, whose listener it must therefore not keep.
TEST(Euler, ACopyTellsNobody) {
    Counter counter;
    Euler e(1, 2, 3);
    e.listen(&counter);
    Euler copied(e);
    copied.set(4, 5, 6);
    copied.x += 1;
    EXPECT_EQ(counter.count, 0);
    EXPECT_EQ(e.x, 1);
}

TEST(Quaternion, ACopyTellsNobody) {
    Counter counter;
    Quaternion q;
    q.listen(&counter);
    Quaternion copied(q);
    copied.set(0, 0, 1, 0);
    copied.normalize();
    EXPECT_EQ(counter.count, 0);
    EXPECT_EQ(q.w, 1);
}

TEST(Quaternion, EachWriteIsToldOnce) {
    Counter counter;
    Quaternion q;
    q.listen(&counter);
    q.x = 0.5;
    q.w -= 0.25;
    EXPECT_EQ(counter.count, 2);
    q.setFromAxisAngle(Vector3(0, 1, 0), 1);
    q.normalize();
    q = Quaternion(0, 0, 0, 1);
    EXPECT_EQ(counter.count, 5);
}

TEST(Quaternion, NormalizeReachesLengthOneFromAnyLength) {
    for (const double s : {1e-320, 1e-200, 1e-30, 0.5, 7.0, 1e30, 1e200, 1e308}) {
        const Quaternion q = Quaternion(s, -s, s, s).normalize();
        EXPECT_NEAR(q.x, 0.5, 1e-15) << s;
        EXPECT_NEAR(q.y, -0.5, 1e-15) << s;
        EXPECT_NEAR(q.z, 0.5, 1e-15) << s;
        EXPECT_NEAR(q.w, 0.5, 1e-15) << s;
    }
}

void expectIdentity(const Quaternion& q) {
    EXPECT_EQ(q.x, 0);
    EXPECT_EQ(q.y, 0);
    EXPECT_EQ(q.z, 0);
    EXPECT_EQ(q.w, 1);
}

TEST(Quaternion, ZeroAndNotANumberNormalizeToTheIdentity) {
    expectIdentity(Quaternion(0, 0, 0, 0).normalize());
    expectIdentity(Quaternion(0, std::numeric_limits<double>::quiet_NaN(), 0, 1).normalize());
    expectIdentity(Quaternion(0, 0, std::numeric_limits<double>::infinity(), 1).normalize());
}

TEST(Quaternion, AxisAngleNormalisesItsAxis) {
    const double s = std::sqrt(0.5);
    for (const double length : {1e-310, 1.0, 1e200}) {
        const Quaternion q = Quaternion().setFromAxisAngle(Vector3(0, 0, length), pi / 2);
        EXPECT_EQ(q.x, 0);
        EXPECT_EQ(q.y, 0);
        EXPECT_NEAR(q.z, s, 1e-15) << length;
        EXPECT_NEAR(q.w, s, 1e-15) << length;
    }
}

// Row C6 of the stability suite.
TEST(Quaternion, C6ATurnAboutTheZeroAxisIsTheIdentity) {
    expectIdentity(Quaternion().setFromAxisAngle(Vector3(0, 0, 0), 1.25));
}

TEST(Vector3, NormalizeReachesLengthOneFromAnyLength) {
    for (const double s : {5e-324, 1e-310, 1e-300, 1e-160, 1e-30, 3.0, 1e30, 1e160, 1e300, 1.7e308}) {
        const Vector3 v = Vector3(s, -s, s).normalize();
        const double expected = std::sqrt(1.0 / 3);
        EXPECT_NEAR(v.x, expected, 1e-15) << s;
        EXPECT_NEAR(v.y, -expected, 1e-15) << s;
        EXPECT_NEAR(v.z, expected, 1e-15) << s;
    }
}

TEST(Vector3, NormalizeKeepsAxesExactAndZeroZero) {
    EXPECT_EQ(Vector3(0, 1e-320, 0).normalize(), Vector3(0, 1, 0));
    EXPECT_EQ(Vector3(0, 0, -7).normalize(), Vector3(0, 0, -1));
    EXPECT_EQ(Vector3().normalize(), Vector3());
}

}  // namespace
