// The hemisphere's grid, closed round the pole without a seam, so that it is smooth everywhere.
// SPDX-License-Identifier: MIT
#include "lab/lobe.hpp"

#include "lab/strokes.hpp"

#include <algorithm>

namespace lab {

using THREE::Vector3;

Lobe::Lobe(int rings) {
    const int columns = 2 * rings;
    directions_.emplace_back(0, 1, 0);
    for (int ring = 1; ring <= rings; ++ring)
        for (int column = 0; column < columns; ++column)
            directions_.push_back(direction(90.0 * ring / rings, 360.0 * column / columns));
    for (Vector3& w : directions_)
        w.y = std::max(w.y, 0.0);  // the cosine of 90 degrees may come out below 0
    std::vector<std::uint32_t> triangles;
    const auto vertex = [columns](int ring, int column) {
        return static_cast<std::uint32_t>(1 + (ring - 1) * columns + column % columns);
    };
    for (int column = 0; column < columns; ++column) {
        triangles.insert(triangles.end(), {0, vertex(1, column), vertex(1, column + 1)});
        for (int ring = 1; ring < rings; ++ring) {
            const std::uint32_t a = vertex(ring, column), b = vertex(ring + 1, column),
                                c = vertex(ring + 1, column + 1), d = vertex(ring, column + 1);
            triangles.insert(triangles.end(), {a, b, c, a, c, d});
        }
    }
    setIndex(std::move(triangles));
    follow([](const Vector3&) { return 1; }, 1);
}

double Lobe::follow(const std::function<double(const Vector3&)>& radius, double longest) {
    std::vector<double> radii(directions_.size());
    std::transform(directions_.begin(), directions_.end(), radii.begin(), radius);
    const double farthest = *std::max_element(radii.begin(), radii.end());
    const double scale = farthest > longest ? longest / farthest : 1;
    std::vector<double> positions;
    for (std::size_t i = 0; i < radii.size(); ++i)
        for (const double coordinate : {directions_[i].x, directions_[i].y, directions_[i].z})
            positions.push_back(coordinate * radii[i] * scale);
    setAttribute("position", std::move(positions), 3);
    computeVertexNormals();
    return scale;
}

}  // namespace lab
