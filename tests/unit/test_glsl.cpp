// GLSL's numbers and functions in C++: strict floats, and maxima that let NaN through or not.
// SPDX-License-Identifier: MIT
#include "support/glsl.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <stdexcept>
#include <vector>

namespace {

using support::glsl::Float;

constexpr float NaN = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();

bool isNaN(Float x) { return std::isnan(x.value()); }

TEST(StrictFloat, WhetherNaNGoesThroughDependsOnTheOrder) {
    EXPECT_TRUE(isNaN(max(Float(NaN), 0.0)));
    EXPECT_EQ(max(Float(0.0), NaN), 0.0);
    EXPECT_TRUE(isNaN(min(Float(NaN), 1.0)));
    EXPECT_EQ(min(Float(1.0), NaN), 1.0);
    EXPECT_TRUE(isNaN(clamp(Float(NaN), 0.0, 1.0)));
    EXPECT_EQ(clamp(Float(0.5), NaN, 1.0), 0.5);
    EXPECT_EQ(clamp(Float(0.5), 0.0, NaN), 0.5);
    EXPECT_TRUE(isNaN(clamp(support::glsl::vec3(0.5, 0.5, NaN), 0.0, 1.0).z));
    EXPECT_EQ(clamp(Float(infinite), -3.4028234e38, 3.4028234e38), std::numeric_limits<float>::max());
    EXPECT_EQ(support::glsl::clamp(-7, -2, 3), -2);
    EXPECT_EQ(support::glsl::clamp(7, -2, 3), 3);
}

TEST(StrictFloat, EveryOperationIsRoundedToFloat) {
    EXPECT_EQ((Float(1.0) + 0x1p-24) + 0x1p-24, 1.0);
    EXPECT_EQ((0.7 * Float(9)).value(), 0.7F * 9.0F) << "the literal is rounded first";
    EXPECT_NE((0.7 * Float(9)).value(), static_cast<float>(0.7 * 9));
    volatile float a = 1 + 0x1p-12F;  // a a = 1 + 2^-11 + 2^-24, halfway between two floats
    EXPECT_EQ(Float(a) * Float(a) - (1 + 0x1p-11), 0.0) << "product and difference became one operation";
    EXPECT_EQ(Float(1e30) * 1e30, infinite);
    EXPECT_EQ(Float(1e-30) * 1e-10 / 1e-10 > 0.0, true) << "small numbers became 0";
}

TEST(StrictFloat, FunctionsAreThoseOfFloat) {
    EXPECT_EQ(sqrt(Float(2)).value(), std::sqrt(2.0F));
    EXPECT_EQ(pow(Float(3), 0.75).value(), std::pow(3.0F, 0.75F));
    EXPECT_EQ(pow(Float(0.0), 0.0), 1.0);
    EXPECT_EQ(exp2(Float(-3)), 0.125);
    EXPECT_EQ(log2(Float(0.125)), -3);
    EXPECT_EQ(floor(Float(-0.5)), -1);
    EXPECT_EQ(abs(Float(-0.5)), 0.5);
    EXPECT_EQ(support::glsl::floatBitsToUint(1.0), 0x3F800000U);
    EXPECT_EQ(support::glsl::uintBitsToFloat(0x7F7FFFFFU).value(), std::numeric_limits<float>::max());
    EXPECT_EQ(static_cast<int>(Float(-2.9)), -2);
    EXPECT_EQ(static_cast<int>(Float(1e20)), std::numeric_limits<int>::max());
    EXPECT_EQ(static_cast<int>(Float(-1e20)), std::numeric_limits<int>::min());
    EXPECT_EQ(static_cast<int>(Float(NaN)), 0);
}

TEST(StrictFloat, TexelsStandInRowsAndMatricesInColumns) {
    using namespace support::glsl;
    sampler2D texture{std::vector<vec4>(6), 3};
    texture.texels[5] = vec4(1, 2, 3, 4);
    EXPECT_EQ(texelFetch(texture, ivec2(2, 1), 0).a, 4);
    EXPECT_THROW(texelFetch(texture, ivec2(0, 2), 0), std::out_of_range);
    const mat4x3 m{{vec3(1, 0, 0), vec3(2, 1, 0), vec3(0, 0, 1), vec3(5, 6, 7)}};
    const vec3 v = m * vec4(1, 10, 100, 1);
    EXPECT_EQ(v.x, 26);
    EXPECT_EQ(v.y, 16);
    EXPECT_EQ(v.z, 107);
}

}  // namespace
