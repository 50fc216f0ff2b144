// The types and functions of GLSL ES 3.00 that the shaders use, in C++ and in strict IEEE float.
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <vector>

#if FLT_EVAL_METHOD != 0 || defined(__FAST_MATH__)
#error                                                                                                       \
    "strict IEEE float needs every operation rounded to float: build without x87 arithmetic and without -ffast-math"
#endif

/// What GLSL's text defines, to the letter: max, min and clamp are comparisons, so whether a NaN goes through depends on
/// the order of the arguments. Where GLSL leaves a result open (pow(0, 0), accuracy of exp2), this is what <cmath> gives.
/// Only what shaders/ needs is here; a shader that uses more does not compile, and says what is missing.
namespace support::glsl {

/// GLSL's float: one IEEE binary32 number, rounded after each operation. Literals are doubles in C++ and become floats
/// before they meet another number.
class Float {
  public:
    Float() = default;
    Float(float x) : value_(x) {}
    Float(double x) : value_(static_cast<float>(x)) {}
    Float(int x) : value_(static_cast<float>(x)) {}

    float value() const { return value_; }
    /// Towards zero. GLSL leaves what an int does not hold open: NaN gives 0, the rest the nearest int.
    explicit operator int() const {
        if (!(value_ > -0x1p31F))
            return value_ <= -0x1p31F ? -2147483647 - 1 : 0;
        return value_ < 0x1p31F ? static_cast<int>(value_) : 2147483647;
    }

    Float operator-() const { return -value_; }
    Float& operator*=(Float b) { return *this = *this * b; }
    Float& operator/=(Float b) { return *this = *this / b; }
    friend Float operator+(Float a, Float b) { return a.value_ + b.value_; }
    friend Float operator-(Float a, Float b) { return a.value_ - b.value_; }
    friend Float operator*(Float a, Float b) { return a.value_ * b.value_; }
    friend Float operator/(Float a, Float b) { return a.value_ / b.value_; }
    friend bool operator<(Float a, Float b) { return a.value_ < b.value_; }
    friend bool operator>(Float a, Float b) { return a.value_ > b.value_; }
    friend bool operator>=(Float a, Float b) { return a.value_ >= b.value_; }
    friend bool operator==(Float a, Float b) { return a.value_ == b.value_; }

  private:
    float value_ = 0;
};

using uint = unsigned int;

inline Float max(Float x, Float y) { return x < y ? y : x; }
inline Float min(Float x, Float y) { return y < x ? y : x; }
inline Float clamp(Float x, Float low, Float high) { return min(max(x, low), high); }
inline int clamp(int x, int low, int high) { return x < low ? low : high < x ? high : x; }
inline Float abs(Float x) { return std::fabs(x.value()); }
inline Float floor(Float x) { return std::floor(x.value()); }
inline Float mod(Float x, Float y) { return x - y * floor(x / y); }
inline Float sqrt(Float x) { return std::sqrt(x.value()); }
inline Float pow(Float x, Float y) { return std::pow(x.value(), y.value()); }
inline Float exp(Float x) { return std::exp(x.value()); }
inline Float exp2(Float x) { return std::exp2(x.value()); }
inline Float log2(Float x) { return std::log2(x.value()); }
inline uint floatBitsToUint(Float x) { return std::bit_cast<uint>(x.value()); }
inline Float uintBitsToFloat(uint x) { return std::bit_cast<float>(x); }

struct vec3 {
    Float x, y, z;

    vec3() = default;
    explicit vec3(Float all) : x(all), y(all), z(all) {}
    vec3(Float x_, Float y_, Float z_) : x(x_), y(y_), z(z_) {}
    vec3& operator*=(Float s) { return *this = vec3(x * s, y * s, z * s); }
    vec3& operator/=(Float s) { return *this = vec3(x / s, y / s, z / s); }
    vec3 operator-() const { return {-x, -y, -z}; }
    friend vec3 operator+(vec3 a, vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend vec3 operator-(vec3 a, vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend vec3 operator*(vec3 a, vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
    friend vec3 operator*(vec3 a, Float s) { return a *= s; }
    friend vec3 operator*(Float s, vec3 a) { return a *= s; }
    friend vec3 operator/(vec3 a, Float s) { return a /= s; }
};

/// A component has two names, as in GLSL. The swizzles .xyz and .rgb are functions here: the includer of a shader makes
/// them calls with a macro.
struct vec4 {
    union {
        Float x, r;
    };
    union {
        Float y, g;
    };
    union {
        Float z, b;
    };
    union {
        Float w, a;
    };

    vec4() : vec4(0) {}
    explicit vec4(Float all) : x(all), y(all), z(all), w(all) {}
    vec4(Float x_, Float y_, Float z_, Float w_) : x(x_), y(y_), z(z_), w(w_) {}
    vec4(vec3 v, Float w_) : vec4(v.x, v.y, v.z, w_) {}
    vec3 xyz() const { return {x, y, z}; }
    vec3 rgb() const { return xyz(); }
    friend vec4 operator+(vec4 a, vec4 b) { return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w}; }
    friend vec4 operator*(vec4 a, Float s) { return {a.x * s, a.y * s, a.z * s, a.w * s}; }
};

inline Float dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline vec3 clamp(vec3 v, Float low, Float high) {
    return {clamp(v.x, low, high), clamp(v.y, low, high), clamp(v.z, low, high)};
}

inline vec3 mix(vec3 a, vec3 b, Float share) { return a * (1.0 - share) + b * share; }

// Matrices are columns; a product sums the columns from the left, as Mesa does.
struct mat3 {
    vec3 column[3];
    friend vec3 operator*(const mat3& m, vec3 v) {
        return m.column[0] * v.x + m.column[1] * v.y + m.column[2] * v.z;
    }
};
struct mat4 {
    vec4 column[4];
    friend vec4 operator*(const mat4& m, vec4 v) {
        return m.column[0] * v.x + m.column[1] * v.y + m.column[2] * v.z + m.column[3] * v.w;
    }
};
struct mat4x3 {
    vec3 column[4];
    friend vec3 operator*(const mat4x3& m, vec4 v) {
        return m.column[0] * v.x + m.column[1] * v.y + m.column[2] * v.z + m.column[3] * v.w;
    }
};

struct ivec2 {
    int x, y;
    ivec2(int x_, int y_) : x(x_), y(y_) {}
};

/// A texture of floats without filtering: rows of `width` texels.
struct sampler2D {
    std::vector<vec4> texels;
    int width = 1;
};
/// Throws std::out_of_range beyond the last texel, where GLSL leaves the result open.
inline vec4 texelFetch(const sampler2D& texture, ivec2 p, int /*level*/) {
    return texture.texels.at(static_cast<std::size_t>(p.y * texture.width + p.x));
}

/// How `inout vec3 v` becomes a reference: `inout` is a macro for `by_reference::`.
namespace by_reference {
using vec3 = glsl::vec3&;
}

}  // namespace support::glsl
