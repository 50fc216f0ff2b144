// Sums up cases, and finds the Pareto front.
// SPDX-License-Identifier: MIT
#include "bench/error/report.hpp"

#include <algorithm>
#include <cmath>

namespace bench::error {

namespace {

constexpr double noise = 0.03;  // of costs

// Errors that agree to three digits are the same: in S4 to S6 most of them is not the method's.
bool noWorse(double a, double b) { return a <= b * 1.001; }

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
    // The geometric mean of ratios, so that no case weighs more because it takes longer; noise can bring a cost to nothing.
    const double ratio = std::max(countsFromFloor(row.scene) ? row.cost.overFloor : row.ratio, 1e-3);
    to.ratio = std::pow(std::pow(to.ratio, to.cases) * ratio, 1.0 / (to.cases + 1));
    ++to.cases;
}

void findFront(std::vector<SceneRow>& scene) {
    for (SceneRow& row : scene) {
        const auto beatenBy = [&](const auto& beats) {
            return std::any_of(scene.begin(), scene.end(),
                               [&](const SceneRow& other) { return beats(other, row); });
        };
        row.onFront = !beatenBy(beatsInFloats);
        row.onFrontCodes = !beatenBy(beatsInCodes);
    }
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values.empty() ? 0 : (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
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
        findFront(scene);
        all.insert(all.end(), scene.begin(), scene.end());
    }
    return all;
}

std::vector<SceneRow> medians(const std::vector<SceneRow>& scenes) {
    std::vector<SceneRow> all;
    for (std::size_t method = 0; method < methods().size(); ++method) {
        std::vector<const SceneRow*> rows;
        for (const SceneRow& row : scenes)
            if (row.method == method && !countsFromFloor(row.scene))
                rows.push_back(&row);
        const auto of = [&rows](const auto& value) {
            std::vector<double> values;
            for (const SceneRow* row : rows)
                values.push_back(value(*row));
            return median(values);
        };
        SceneRow sum;
        sum.scene = "all";
        sum.method = method;
        sum.ratio = of([](const SceneRow& row) { return row.ratio; });
        sum.error.max = of([](const SceneRow& row) { return row.error.max; });
        sum.error.p999 = of([](const SceneRow& row) { return row.error.p999; });
        sum.codes.max = static_cast<int>(of([](const SceneRow& row) { return row.codes.max; }));
        sum.codes.mean = of([](const SceneRow& row) { return row.codes.mean; });
        sum.codes.wrong = of([](const SceneRow& row) { return row.codes.wrong; });
        if (!rows.empty())
            all.push_back(sum);
    }
    findFront(all);
    return all;
}

std::vector<const SceneRow*> frontLine(const std::vector<SceneRow>& scene,
                                       const std::function<double(const SceneRow&)>& error) {
    std::vector<const SceneRow*> rows, line;
    for (const SceneRow& row : scene)
        rows.push_back(&row);
    std::stable_sort(rows.begin(), rows.end(),
                     [](const SceneRow* a, const SceneRow* b) { return a->ratio < b->ratio; });
    for (const SceneRow* row : rows)
        if (line.empty() || error(*row) < error(*line.back()))
            line.push_back(row);
    return line;
}

}  // namespace bench::error
