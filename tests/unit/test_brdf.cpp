// BRDFs: the furnace test in numbers and in closed form, what the lab shades by them, and where photons go.
// SPDX-License-Identifier: MIT
#include "lighting/brdf.hpp"
#include "lighting/reference/reference.hpp"
#include "three/three.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace {

using lighting::LambertBrdf;
using lighting::PhongBrdf;
using lighting::Reflection;
using std::numbers::pi;
using THREE::Vector3;

const Vector3 n(0, 1, 0);

// `theta` degrees from n; `phi` degrees about it.
Vector3 at(double theta, double phi = 0) {
    const double t = theta * pi / 180, p = phi * pi / 180;
    return {std::sin(t) * std::cos(p), std::cos(t), std::sin(t) * std::sin(p)};
}

TEST(Lambert, SendsBackItsAlbedoFromWhereverLightArrives) {
    for (const double a : {0.0, 0.18, 0.5, 1.0})
        for (const double theta : {0.0, 35.0, 89.9})
            EXPECT_NEAR(Reflection(LambertBrdf{a}, n, at(theta), 8).sentBack(), a, 1e-14);
    const auto withoutPi = [](const Vector3&, const Vector3&, const Vector3&) { return 0.5; };
    EXPECT_NEAR(Reflection(withoutPi, n, at(20), 8).sentBack(), pi / 2, 1e-13)
        << "a constant a sends back pi a: more than arrives";
}

TEST(Lambert, IsReciprocalAndPhongIsNot) {
    const PhongBrdf phong{0.3, 0.5, 10};
    EXPECT_EQ(LambertBrdf{0.3}(n, at(10), at(70, 40)), LambertBrdf{0.3}(n, at(70, 40), at(10)));
    EXPECT_GT(std::abs(phong(n, at(60), at(70, 180)) - phong(n, at(70, 180), at(60))), 0.1);
}

TEST(Brdf, NothingArrivesOrLeavesBelowTheSurface) {
    const PhongBrdf phong{0.5, 1, 2};
    EXPECT_GT(phong(n, at(89), at(89, 180)), 0);
    for (const auto& [in, out] : {std::pair{91.0, 30.0}, {30.0, 91.0}, {120.0, 120.0}}) {
        EXPECT_EQ(phong(n, at(in), at(out, 180)), 0);
        EXPECT_EQ(LambertBrdf{1}(n, at(in), at(out)), 0);
    }
    EXPECT_EQ(phong.sentBack(pi / 2 + 0.1), 0);
    EXPECT_EQ(Reflection(phong, n, at(100)).sentBack(), 0);
    EXPECT_TRUE(Reflection(phong, n, at(100)).photons(100).empty());
}

TEST(Phong, ItsClosedFormIsTheIntegral) {
    for (const int s : {1, 2, 3, 7, 30, 100})
        for (const double theta : {0.0, 20.0, 45.0, 70.0, 82.0}) {
            const PhongBrdf phong{0.25, 0.8, s};
            const double closed = phong.sentBack(theta * pi / 180);
            EXPECT_NEAR(Reflection(phong, n, at(theta), 480).sentBack(), closed, 1e-6)
                << "s = " << s << ", theta = " << theta;
        }
    // s = 0 ends at the horizon of R with a jump, which cells resolve less well.
    EXPECT_NEAR(Reflection(PhongBrdf{0, 1, 0}, n, at(50), 480).sentBack(),
                PhongBrdf({0, 1, 0}).sentBack(50 * pi / 180), 1e-3);
}

TEST(Phong, ItsClosedFormInTheCasesThatOneCanWriteDown) {
    for (const double theta : {0.0, 0.4, 1.2}) {
        const double c = std::cos(theta);
        EXPECT_NEAR(PhongBrdf({0, 1, 0}).sentBack(theta), (1 + c) / (2 * c), 1e-14);
        EXPECT_NEAR(PhongBrdf({0, 1, 1}).sentBack(theta),
                    2.0 / 3 * (c * (pi - theta) + std::sin(theta)) / (pi * c), 1e-14);
    }
    for (const int s : {2, 5, 50, 1000, 100'000})
        EXPECT_NEAR(PhongBrdf({0.1, 1, s}).sentBack(0), 0.1 + 2.0 / (s + 2), 1e-13) << s;
}

TEST(Phong, SendsBackMoreThanArrivesNearGrazing) {
    const PhongBrdf phong{0, 1, 3};
    EXPECT_LT(phong.sentBack(0), 0.5);
    EXPECT_GT(phong.sentBack(85 * pi / 180), 1);
}

// pi f_r cos(theta_i) is what the slides' equation gives for L = 1, in which pi has gone.
TEST(Brdf, TimesPiAndTheCosineIsWhatTheLabShades) {
    THREE::Scene scene;
    THREE::PlaneGeometry geometry(4, 4);
    THREE::MeshPhongMaterial material;
    material.color.set(0.4, 0.4, 0.4);
    material.specular.set(0.7, 0.7, 0.7);
    material.shininess = 6;
    THREE::Mesh plane(geometry, material);  // its normal is z
    THREE::DirectionalLight sun;
    scene.add(plane, sun);
    THREE::PerspectiveCamera camera(1);
    const Vector3 z(0, 0, 1), wr = Vector3(0.5, -0.2, 0.9).normalize();
    camera.position = Vector3(wr).multiplyScalar(50);
    camera.lookAt(0, 0, 0);
    for (const Vector3& w :
         {Vector3(-0.4, 0.3, 1), Vector3(0, 0, 1), Vector3(-2, 1, 0.4), Vector3(1, 0, -0.1)}) {
        sun.position = w;
        const Vector3 wi = Vector3(w).normalize();
        const lighting::reference::Reference<double> reference(scene, camera, lighting::TermSet::all(), 1, 1);
        EXPECT_NEAR(reference.probe(0, 0).P.r,
                    pi * PhongBrdf({0.4, 0.7, 6})(z, wi, wr) * std::max(0.0, z.dot(wi)), 1e-12);
    }
    material.specular.set(0, 0, 0);
    sun.position.set(-0.4, 0.3, 1);
    const Vector3 wi = Vector3(sun.position).normalize();
    const lighting::reference::Reference<double> reference(scene, camera, lighting::TermSet::all(), 1, 1);
    EXPECT_NEAR(reference.probe(0, 0).P.r, pi * LambertBrdf{0.4}(z, wi, wr) * z.dot(wi), 1e-12);
}

TEST(Photons, AreAsManyAsTheShareSaysAndAboveTheSurface) {
    const Vector3 tilted = Vector3(1, 2, -2).normalize();
    for (const double a : {0.0, 0.004, 0.36, 1.0}) {
        const std::vector<Vector3> photons = Reflection(LambertBrdf{a}, tilted, tilted).photons(100);
        EXPECT_EQ(photons.size(), static_cast<std::size_t>(std::lround(100 * a)));
        for (const Vector3& w : photons) {
            EXPECT_NEAR(w.length(), 1, 1e-12);
            EXPECT_GT(w.dot(tilted), 0);
        }
    }
    EXPECT_EQ(Reflection(LambertBrdf{1}, n, n).photons(7), Reflection(LambertBrdf{1}, n, n).photons(7));
}

TEST(Photons, AreDistributedAsTheBrdfTimesTheCosine) {
    // Lambert: the share within an angle of n is sin^2 of it; a hundred photons hit that to one or two.
    const std::vector<Vector3> hundred = Reflection(LambertBrdf{1}, n, at(60)).photons(100);
    for (const double degrees : {20.0, 45.0, 70.0})
        EXPECT_NEAR(lighting::countWithin(hundred, n, degrees),
                    100 * std::pow(std::sin(degrees * pi / 180), 2), 1.5);
    for (int quarter = 0; quarter < 4; ++quarter) {
        const auto inside = [quarter](const Vector3& w) {
            return static_cast<int>(std::floor((std::atan2(w.z, w.x) + pi) / (pi / 2))) == quarter;
        };
        EXPECT_NEAR(static_cast<double>(std::count_if(hundred.begin(), hundred.end(), inside)), 25, 2);
    }
    // Phong, away from the horizon: the share with R . w_r below u is u^(s+2).
    const std::vector<Vector3> peak = Reflection(PhongBrdf{0, 1, 50}, n, at(40)).photons(100'000);
    const double half = std::acos(std::pow(0.5, 1.0 / 52)) * 180 / pi;
    EXPECT_NEAR(lighting::countWithin(peak, at(40, 180), half), 0.5 * static_cast<double>(peak.size()),
                0.01 * static_cast<double>(peak.size()));
}

}  // namespace
