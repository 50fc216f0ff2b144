// Real: a number of 300 bits (MPFR) that behaves like a built-in one, so that Reference<Real> evaluates the equation to far
// more digits than any frame holds.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <deque>
#include <limits>
#include <mpfr.h>

namespace support {

/// A handle to an immutable number in a pool that grows until the process ends: trivial to copy, as glm's vectors want. For
/// one thread at a time.
class Real {
  public:
    static constexpr mpfr_prec_t bits = 300;

    Real() = default;
    Real(double x) : value_(next()) { mpfr_set_d(value_, x, MPFR_RNDN); }
    Real(long double x) : value_(next()) { mpfr_set_ld(value_, x, MPFR_RNDN); }
    Real(float x) : Real(static_cast<double>(x)) {}
    Real(int x) : Real(static_cast<double>(x)) {}

    explicit operator double() const { return mpfr_get_d(value_, MPFR_RNDN); }
    explicit operator long double() const { return mpfr_get_ld(value_, MPFR_RNDN); }

    friend Real operator+(Real a, Real b) { return make(mpfr_add, a, b); }
    friend Real operator-(Real a, Real b) { return make(mpfr_sub, a, b); }
    friend Real operator*(Real a, Real b) { return make(mpfr_mul, a, b); }
    friend Real operator/(Real a, Real b) { return make(mpfr_div, a, b); }
    friend Real operator-(Real a) { return make(mpfr_neg, a); }
    Real& operator+=(Real b) { return *this = *this + b; }
    Real& operator-=(Real b) { return *this = *this - b; }
    Real& operator*=(Real b) { return *this = *this * b; }
    Real& operator/=(Real b) { return *this = *this / b; }
    friend bool operator<(Real a, Real b) { return mpfr_less_p(a.value_, b.value_) != 0; }
    friend bool operator>(Real a, Real b) { return b < a; }
    friend bool operator<=(Real a, Real b) { return mpfr_lessequal_p(a.value_, b.value_) != 0; }
    friend bool operator>=(Real a, Real b) { return b <= a; }
    friend bool operator==(Real a, Real b) { return mpfr_equal_p(a.value_, b.value_) != 0; }

    friend Real sqrt(Real x) { return make(mpfr_sqrt, x); }
    friend Real abs(Real x) { return make(mpfr_abs, x); }
    friend Real tan(Real x) { return make(mpfr_tan, x); }
    friend Real atan(Real x) { return make(mpfr_atan, x); }
    friend Real exp2(Real x) { return make(mpfr_exp2, x); }
    friend Real pow(Real x, Real y) { return make(mpfr_pow, x, y); }

  private:
    static mpfr_ptr next() {
        static std::deque<mpfr_t> pool;  // its elements stay where they are
        pool.emplace_back();
        mpfr_init2(pool.back(), bits);
        return pool.back();
    }
    template <class Operation, class... Operands>
    static Real make(const Operation& operation, Operands... operands) {
        Real result;
        result.value_ = next();
        operation(result.value_, operands.value_..., MPFR_RNDN);
        return result;
    }

    mpfr_ptr value_;
};

}  // namespace support

// glm asks for these before it adds and multiplies.
template <>
class std::numeric_limits<support::Real> {
  public:
    static constexpr bool is_specialized = true;
    static constexpr bool is_iec559 = true;
    static constexpr bool is_integer = false;
    static constexpr bool is_signed = true;
    static constexpr int max_exponent = 1'000'000;
};
