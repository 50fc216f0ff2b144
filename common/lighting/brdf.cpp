// Lambert's and Phong's BRDF, the share that they send back, and photons by inverting its distribution.
// SPDX-License-Identifier: MIT
#include "lighting/brdf.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lighting {

using std::numbers::pi;
using THREE::Vector3;

double LambertBrdf::operator()(const Vector3& n, const Vector3& wi, const Vector3& wr) const {
    return n.dot(wi) > 0 && n.dot(wr) > 0 ? albedo / pi : 0;
}

double PhongBrdf::operator()(const Vector3& n, const Vector3& wi, const Vector3& wr) const {
    const double cosine = n.dot(wi);
    if (!(cosine > 0 && n.dot(wr) > 0))
        return 0;
    const double toMirror = 2 * cosine * n.dot(wr) - wi.dot(wr);  // R . w_r with R = 2 (n . w_i) n - w_i
    const double highlight = toMirror > 0 ? std::pow(toMirror, shininess) : 0;
    return albedo / pi + specular * highlight / (pi * cosine);
}

// With u = R . w and v = n . w, over the directions where both are positive, let M_k be the integral of u^k and J_k that of
// u^k v. What sends back is a + k J_s / (pi cos). On the sphere |grad u|^2 = 1 - u^2, grad u . grad v = cos - u v, and the
// Laplacians are -2 u and -2 v. So the divergence of u^k grad u is k u^(k-1) - (k+2) u^(k+1), that of u^k grad v is
// k cos u^(k-1) - (k+2) u^k v. Their flow leaves where v = 0 only (where u = 0, u^k is 0), a half circle on which
// u = sin cos(phi): that gives the two recurrences, with B_k the integral of cos^k(phi) over it.
double PhongBrdf::sentBack(double theta) const {
    const double c = std::cos(theta), sine = std::sin(theta);
    if (!(c > 0))
        return 0;
    double J = pi * (1 + c) / 2;
    double M0 = 2 * (pi - theta), M1 = pi * (1 + c) / 2;  // M_(k-1) and M_k
    double B0 = pi, B1 = 2;  // Wallis: B_(k-1) and B_k
    double power = sine;  // sin^k
    for (int k = 1; k <= shininess; ++k) {
        J = (k * c * M0 + power * B1) / (k + 2);
        const double M2 = (k * M0 + c * power * B1) / (k + 2), B2 = B0 * k / (k + 1);
        M0 = M1;
        M1 = M2;
        B0 = B1;
        B1 = B2;
        power *= sine;
    }
    return albedo + specular * J / (pi * c);
}

namespace {

// A unit vector at right angles to n.
Vector3 beside(const Vector3& n) {
    const Vector3 other = std::abs(n.x) < 0.7 ? Vector3(1, 0, 0) : Vector3(0, 0, 1);
    return Vector3(other).sub(Vector3(n).multiplyScalar(other.dot(n))).normalize();
}

// 0.5, 0.25, 0.75, 0.125, ...: the binary digits of i, mirrored. Evenly spread however many are taken.
double mirroredDigits(unsigned i) {
    double value = 0;
    for (double digit = 0.5; i != 0; i >>= 1U, digit /= 2)
        value += (i & 1U) != 0 ? digit : 0;
    return value;
}

// Where a rising table of sums passes `wanted`, counted in cells and parts of a cell.
double inverted(const double* sums, int cells, double wanted) {
    const double* const above = std::upper_bound(sums + 1, sums + cells, wanted);
    const double below = above[-1];
    const double part = *above > below ? (wanted - below) / (*above - below) : 0.5;
    return static_cast<double>(above - 1 - sums) + std::clamp(part, 0.0, 1.0);
}

}  // namespace

Reflection::Reflection(const Brdf& brdf, const Vector3& n, const Vector3& wi, int rings)
    : rings_(std::max(rings, 1)), cells_(4 * rings_), n_(n), side_(beside(n)),
      front_(Vector3(side_).cross(n)), rows_{0} {
    const auto sineSquared = [this](int ring) { return std::pow(std::sin(ring * pi / 2 / rings_), 2); };
    for (int ring = 0; ring < rings_; ++ring) {
        // The integral of (n . w) over a cell is known exactly: Lambert's share is exact, however few rings there are.
        const double area = (sineSquared(ring + 1) - sineSquared(ring)) * pi / cells_;
        columns_.push_back(0);
        for (int cell = 0; cell < cells_; ++cell) {
            const Vector3 wr = direction((ring + 0.5) * pi / 2 / rings_, (cell + 0.5) * 2 * pi / cells_);
            columns_.push_back(columns_.back() + brdf(n, wi, wr) * area);
        }
        rows_.push_back(rows_.back() + columns_.back());
    }
}

Vector3 Reflection::direction(double theta, double phi) const {
    const double across = std::sin(theta);
    return Vector3(side_)
        .multiplyScalar(across * std::cos(phi))
        .add(Vector3(front_).multiplyScalar(across * std::sin(phi)))
        .add(Vector3(n_).multiplyScalar(std::cos(theta)));
}

std::vector<Vector3> Reflection::photons(int arriving) const {
    const auto count = static_cast<int>(std::lround(sentBack() * arriving));
    std::vector<Vector3> directions;
    for (int i = 0; i < count; ++i) {
        const double row = inverted(rows_.data(), rings_, sentBack() * (i + 0.5) / count);
        const int ring = std::min(static_cast<int>(row), rings_ - 1);
        const double* const sums = columns_.data() + static_cast<std::ptrdiff_t>(ring) * (cells_ + 1);
        const double column = inverted(sums, cells_, sums[cells_] * mirroredDigits(static_cast<unsigned>(i)));
        directions.push_back(direction(row * pi / 2 / rings_, column * 2 * pi / cells_));
    }
    return directions;
}

int countWithin(const std::vector<Vector3>& directions, const Vector3& axis, double degrees) {
    const double least = std::cos(degrees * pi / 180);
    return static_cast<int>(std::count_if(directions.begin(), directions.end(),
                                          [&](const Vector3& w) { return w.dot(axis) >= least; }));
}

}  // namespace lighting
