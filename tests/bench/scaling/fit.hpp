// Lines through measured times.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <vector>

namespace bench {

/// A size and its frame's time.
struct Point {
    double x, ms;
};

/// ms = base + slope x
struct Line {
    double base, slope;
};

/// The line with the smallest sum of squared relative distances, so that small times count as much as large ones. Needs two sizes.
inline Line fitLine(const std::vector<Point>& points) {
    double w = 0, wx = 0, wy = 0, wxx = 0, wxy = 0;
    for (const Point& p : points) {
        const double weight = 1 / (p.ms * p.ms);
        w += weight;
        wx += weight * p.x;
        wy += weight * p.ms;
        wxx += weight * p.x * p.x;
        wxy += weight * p.x * p.ms;
    }
    const double slope = (w * wxy - wx * wy) / (w * wxx - wx * wx);
    return {(wy - slope * wx) / w, slope};
}

/// The exponent e of ms ~ x^e over the upper half of the points, where what is constant hides least.
inline double fitExponent(const std::vector<Point>& points) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = (points.size() - 1) / 2; i < points.size(); ++i) {
        const double x = std::log(points[i].x), y = std::log(points[i].ms);
        n += 1;
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

}  // namespace bench
