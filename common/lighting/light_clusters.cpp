// Spheres of lights against tiles and slices, and lists by counting.
// SPDX-License-Identifier: MIT
#include "lighting/light_clusters.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace lighting {

namespace {

constexpr int tiles = 32, slices = 24;  // 16 x 16 pixels of a 512 x 512 picture
constexpr std::size_t mostEntries = 1U << 23U;  // beyond it the grid is made coarser
constexpr double margin = 0.01;  // of a tile or slice, for the roundings of a fragment's own place

// The clusters of one slice that a light may reach.
struct Patch {
    std::uint32_t light;
    int slice, left, right, bottom, top;  // all inclusive

    std::size_t count() const {
        return static_cast<std::size_t>(right - left + 1) * static_cast<std::size_t>(top - bottom + 1);
    }
};

// A light that ends: its sphere in view space, depth counted forwards.
struct Ball {
    std::uint32_t light;
    double x, y, depth, radius;
};

// No vector becomes longer by more than this factor.
double stretch(const glm::dmat3& m) {
    double sum = 0;
    bool rigid = true;
    for (int i = 0; i < 3; ++i) {
        sum += glm::dot(m[i], m[i]);
        for (int j = 0; j <= i; ++j)
            rigid &= std::abs(glm::dot(m[i], m[j]) - (i == j ? 1 : 0)) < 1e-9;
    }
    return rigid ? 1 + 1e-8 : std::sqrt(sum);
}

class Clusterer {
  public:
    explicit Clusterer(const FramePlan& plan) : plan_(plan) {
        const double scale = stretch(glm::dmat3(plan.lightingToView));
        for (std::uint32_t i = 0; i < plan.point.size(); ++i) {
            const PointAddend& light = plan.point[i];
            if (!std::isfinite(light.reach))
                continue;
            const glm::dvec3 at = plan.lightingToView * glm::dvec4(light.position, 1);
            const double rounding = 1e-6 * (glm::length(light.position) + glm::length(at));
            const double radius = light.reach * scale * (1 + 1e-5) + rounding;
            if (-at.z + radius > plan.near)
                balls_.push_back({i, at.x, at.y, -at.z, radius});
        }
        findDepths();
    }

    LightClusters run() {
        LightClusters out;
        out.columns = out.rows = tiles;
        out.slices = slices;
        for (;;) {
            out.slicesPerOctave = out.slices / std::log2(farthest_ / nearest_);
            out.firstSlice = -std::log2(nearest_) * out.slicesPerOctave;
            if (findPatches(out) <= mostEntries || out.count() == 1)
                break;
            for (int* const side : {&out.columns, &out.rows, &out.slices})
                *side = std::max(*side / 2, 1);
        }
        fill(out);
        return out;
    }

  private:
    // The depths that both meshes and lights have.
    void findDepths() {
        double nearestMesh = std::numeric_limits<double>::infinity(), farthestMesh = 0;
        for (const Draw& draw : plan_.draws) {
            nearestMesh = std::min(nearestMesh, draw.nearestDepth);
            farthestMesh = std::max(farthestMesh, draw.farthestDepth);
        }
        double nearestLight = std::numeric_limits<double>::infinity(), farthestLight = 0;
        for (const Ball& ball : balls_) {
            nearestLight = std::min(nearestLight, ball.depth - ball.radius);
            farthestLight = std::max(farthestLight, ball.depth + ball.radius);
        }
        nearest_ = std::max({plan_.near, nearestMesh, nearestLight});
        farthest_ = std::min(farthestMesh, farthestLight);
        if (!(std::isfinite(nearest_) && nearest_ > 0))
            nearest_ = plan_.near;
        // Thinner slices than these, and a driver's log2, which may be 3 units in the last place off, would miss some.
        farthest_ = std::max(farthest_, nearest_ * 1.25);
    }

    static int clampedFloor(double x, int count) {
        return static_cast<int>(std::floor(std::clamp(x, 0.0, count - 1.0)));
    }

    // Fills patches_ and returns how many entries the lists would have.
    std::size_t findPatches(const LightClusters& grid) {
        patches_.clear();
        std::size_t entries = 0;
        const auto slice = [&grid](double depth) {
            return std::log2(depth) * grid.slicesPerOctave + grid.firstSlice;
        };
        for (const Ball& ball : balls_) {
            const double front = std::max(ball.depth - ball.radius, plan_.near);
            const double back = std::max(ball.depth + ball.radius, front);
            if (slice(front) - margin > grid.slices && grid.slices > 1)
                continue;  // behind every mesh
            const int first = clampedFloor(slice(front) - margin, grid.slices);
            const int last = clampedFloor(slice(back) + margin, grid.slices);
            for (int s = first; s <= last; ++s) {
                // The slice's own depths; the first and the last take what lies before and behind.
                const auto depthOf = [&grid](double at) {
                    return std::exp2((at - grid.firstSlice) / grid.slicesPerOctave);
                };
                const double begin = s == first ? front : std::max(front, depthOf(s - margin));
                const double end = s == last ? back : std::min(back, depthOf(s + 1 + margin));
                if (const auto patch = patchOf(ball, s, begin, std::max(begin, end), grid);
                    patch.count() > 0) {
                    patches_.push_back(patch);
                    entries += patch.count();
                }
            }
            if (entries > mostEntries && grid.count() > 1)
                return entries;
        }
        return entries;
    }

    // What a ball covers of the picture between two depths: the widest disc there, seen from as near and as far as it is.
    Patch patchOf(const Ball& ball, int s, double begin, double end, const LightClusters& grid) const {
        const double off = ball.depth < begin ? begin - ball.depth : ball.depth > end ? ball.depth - end : 0;
        const double radius = std::sqrt(std::max(ball.radius * ball.radius - off * off, 0.0));
        const auto range = [&](double middle, int axis, int count) {
            std::array<double, 2> out{std::numeric_limits<double>::infinity(),
                                      -std::numeric_limits<double>::infinity()};
            for (const double depth : {begin, end})
                for (const double side : {middle - radius, middle + radius}) {
                    const double ndc =
                        plan_.projection[axis][axis] * side / depth - plan_.projection[2][axis];
                    const double tile = (ndc + 1) / 2 * count;
                    out = {std::min(out[0], tile - margin), std::max(out[1], tile + margin)};
                }
            return out;
        };
        const auto [left, right] = range(ball.x, 0, grid.columns);
        const auto [bottom, top] = range(ball.y, 1, grid.rows);
        if (right < 0 || left > grid.columns || top < 0 || bottom > grid.rows)
            return {ball.light, s, 0, -1, 0, -1};
        return {ball.light,
                s,
                clampedFloor(left, grid.columns),
                clampedFloor(right, grid.columns),
                clampedFloor(bottom, grid.rows),
                clampedFloor(top, grid.rows)};
    }

    template <class Visit>
    void forEachEntry(const LightClusters& grid, const Visit& visit) const {
        for (const Patch& patch : patches_) {
            const unsigned group = decayGroup(plan_.point[patch.light]);
            for (int row = patch.bottom; row <= patch.top; ++row)
                for (int column = patch.left; column <= patch.right; ++column) {
                    const auto cluster =
                        static_cast<std::size_t>((patch.slice * grid.rows + row) * grid.columns + column);
                    visit(cluster * 4 + group, patch.light);
                }
        }
    }

    void fill(LightClusters& out) const {
        out.begins.assign(out.count() * 4 + 1, 0);
        forEachEntry(out, [&out](std::size_t list, std::uint32_t) { ++out.begins[list + 1]; });
        for (std::size_t i = 1; i < out.begins.size(); ++i)
            out.begins[i] += out.begins[i - 1];
        out.lights.resize(out.begins.back());
        std::vector<std::uint32_t> next(out.begins.begin(), out.begins.end() - 1);
        forEachEntry(out, [&](std::size_t list, std::uint32_t light) { out.lights[next[list]++] = light; });
    }

    const FramePlan& plan_;
    std::vector<Ball> balls_;
    std::vector<Patch> patches_;
    double nearest_ = 1, farthest_ = 2;
};

// One cluster, every light that is not everywhere.
LightClusters unculled(const FramePlan& plan) {
    LightClusters out;
    out.begins.assign(5, 0);
    for (std::uint32_t i = 0; i < plan.point.size(); ++i)
        if (const PointAddend& light = plan.point[i]; std::isfinite(light.reach)) {
            out.lights.push_back(i);
            for (unsigned end = decayGroup(light) + 1; end < 5; ++end)
                ++out.begins[end];
        }
    return out;
}

}  // namespace

LightClusters clusterLights(const FramePlan& plan, bool cull) {
    return cull ? Clusterer(plan).run() : unculled(plan);
}

}  // namespace lighting
