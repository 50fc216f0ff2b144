// Sums up cases, and finds the Pareto front.
// SPDX-License-Identifier: MIT
#include "bench/error/report.hpp"

#include <algorithm>

namespace bench::error {

namespace {

constexpr double noise = 0.03;  // of costs

// The slack keeps differences in the last digit from counting as errors.
bool noWorse(double a, double b) { return a <= b * (1 + 1e-9); }

bool beatsInFloats(const SceneRow& a, const SceneRow& b) {
    return a.ratio < b.ratio * (1 - noise) && noWorse(a.error.max, b.error.max);
}

bool beatsInCodes(const SceneRow& a, const SceneRow& b) {
    return a.ratio < b.ratio * (1 - noise) && a.codes.max <= b.codes.max &&
           noWorse(a.codes.mean, b.codes.mean);
}

void add(SceneRow& to, const Row& row) {
    to.error.max = std::max(to.error.max, row.error.max);
    to.error.p999 = std::max(to.error.p999, row.error.p999);
    to.error.values += row.error.values;
    to.codes.max = std::max(to.codes.max, row.codes.max);
    to.codes.mean = std::max(to.codes.mean, row.codes.mean);
    to.codes.wrong = std::max(to.codes.wrong, row.codes.wrong);
    to.lighting += row.cost.lighting;
    to.frame += row.cost.frame;
    to.floor += row.cost.frame / row.cost.overFloor;
}

void placeInScene(std::vector<SceneRow>& scene) {
    for (SceneRow& row : scene)
        row.ratio =
            countsFromFloor(row.scene) ? row.frame / row.floor : row.lighting / scene[threeMethod].lighting;
    for (SceneRow& row : scene) {
        const auto beatenBy = [&](const auto& beats) {
            return std::any_of(scene.begin(), scene.end(),
                               [&](const SceneRow& other) { return beats(other, row); });
        };
        row.onFront = !beatenBy(beatsInFloats);
        row.onFrontCodes = !beatenBy(beatsInCodes);
    }
}

}  // namespace

bool countsFromFloor(const std::string& scene) { return scene == "S9"; }

std::vector<SceneRow> sumUp(const std::vector<Row>& rows) {
    std::vector<SceneRow> all;
    for (const SceneInfo& info : sceneTable()) {
        std::vector<SceneRow> scene;
        for (std::size_t method = 0; method < methods().size(); ++method) {
            SceneRow sum;
            sum.scene = info.id;
            sum.method = method;
            for (const Row& row : rows)
                if (row.scene == sum.scene && row.method == method)
                    add(sum, row);
            if (sum.error.values > 0)
                scene.push_back(sum);
        }
        if (scene.empty())
            continue;
        placeInScene(scene);
        all.insert(all.end(), scene.begin(), scene.end());
    }
    return all;
}

}  // namespace bench::error
