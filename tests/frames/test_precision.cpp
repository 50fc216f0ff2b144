// The reference itself: in double against 300 bits (MPFR), and in float and long double against double.
// SPDX-License-Identifier: MIT
#include "lighting/reference/raster.hpp"
#include "support/real.hpp"
#include "support/stage.hpp"

#include <gtest/gtest.h>

namespace {

using lighting::reference::Reference;
using lighting::reference::Surface;
using support::Real;
using support::Stage;

constexpr int size = 96;

// A stage with lights of every kind.
struct Lit : Stage {
    Lit() {
        bulb({2, 2.5, 2}, 4, 2);
        bulb({-1.5, 0.4, 1}, 0.7, 1);
        bulb({0, 4, 0}, 0.5, 0);
        bulb({3, 1, -1}, 1, 1.5);
        bulb({-3, 2, 3}, 1, 2, 6);
        all.rotation.set(0.1, 0.2, 0.3);
        all.scale.set(1, 0.8, -1.2);
    }
};

// The same with highlights.
struct Shiny : Lit {
    explicit Shiny(THREE::SpecularModel model) {
        orange.specular.set(0xCCBBAA);
        orange.shininess = 30;
        orange.specularModel = model;
    }
};

template <class T>
Reference<T> reference(Stage& stage) {
    stage.place();
    stage.camera.aspect = 1;
    return Reference<T>(stage.scene, stage.camera, stage.options.settings.terms, size, size);
}

// Largest |a - truth| / max(S, 1e-3) over some pixels, S as everywhere: every cosine taken as 1.
template <class T, class Truth>
double worst(Stage& stage, int step, bool sameTriangle) {
    const Reference<T> a = reference<T>(stage);
    const Reference<Truth> truth = reference<Truth>(stage);
    stage.options.settings.terms = stage.options.settings.terms.without(lighting::Term::cosine);
    const Reference<double> strength = reference<double>(stage);
    const std::vector<std::uint8_t> edges = strength.edges();
    double result = 0;
    int judged = 0;
    for (int y = 1; y < size; y += step)
        for (int x = 1; x < size; x += step) {
            const std::optional<Surface<T>> surface = a.surface(x, y);
            if (!surface || (!sameTriangle && edges[static_cast<std::size_t>(y * size + x)] != 0))
                continue;
            const std::optional<Surface<Truth>> exact =
                sameTriangle ? truth.extended(surface->body, surface->triangle, x, y) : truth.surface(x, y);
            EXPECT_TRUE(exact.has_value());
            const auto found = a.shade(*surface);
            const auto expected = truth.shade(*exact);
            const auto S = strength.shade(*strength.surface(x, y));
            for (int c = 0; c < 3; ++c) {
                const Truth error = Truth(found[c]) - expected[c];
                result = std::max(result, std::abs(static_cast<double>(error)) / std::max(S[c], 1e-3));
            }
            ++judged;
        }
    EXPECT_GT(judged, 50);
    return result;
}

// Measured on x86-64: 2.4e-15, 1.1e-18, 3.5e-15 and 2.3e-6. Gates are 4 times that.
TEST(Precision, DoubleAgainstThreeHundredBits) {
    Lit stage;
    const double error = worst<double, Real>(stage, 9, true);
    std::cout << "double against MPFR: " << error << '\n';
    EXPECT_LE(error, 1e-14);
    EXPECT_GT(error, 1e-18) << "two ways of rounding differ";
}

TEST(Precision, LongDoubleAgainstThreeHundredBits) {
    Lit stage;
    const double error = worst<long double, Real>(stage, 9, true);
    std::cout << "long double against MPFR: " << error << '\n';
    EXPECT_LE(error, 5e-18);
}

TEST(Precision, DoubleAgainstLongDouble) {
    Lit stage;
    const double error = worst<double, long double>(stage, 1, false);
    std::cout << "double against long double: " << error << '\n';
    EXPECT_LE(error, 1.4e-14);
}

TEST(Precision, FloatAgainstDouble) {
    Lit stage;
    const double error = worst<float, double>(stage, 1, false);
    std::cout << "float against double: " << error << '\n';
    EXPECT_LE(error, 1e-5);
    EXPECT_GT(error, 1e-8);
}

// Measured: 5.9e-15 and 6.0e-15; the exponent, 30, multiplies the error of R . v.
TEST(Precision, HighlightsInDoubleAgainstThreeHundredBits) {
    for (const auto model : {THREE::SpecularModel::phong, THREE::SpecularModel::blinn}) {
        Shiny stage(model);
        const double error = worst<double, Real>(stage, 9, true);
        std::cout << "double against MPFR, highlights: " << error << '\n';
        EXPECT_LE(error, 2.4e-14);
        EXPECT_GT(error, 1e-18);
    }
}

// The 300 bits see what doubles cannot: 1 + 2^-200 is not 1.
TEST(Precision, ThreeHundredBitsAreThree) {
    const Real tiny = Real(std::ldexp(1.0, -200));
    EXPECT_EQ(static_cast<double>((Real(1) + tiny) - Real(1)), std::ldexp(1.0, -200));
    EXPECT_EQ(static_cast<double>(sqrt(Real(2)) * sqrt(Real(2)) - Real(2)) < 1e-80, true);
}

}  // namespace
