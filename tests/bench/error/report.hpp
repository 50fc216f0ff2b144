// The tables that come out of the error benchmark, and who is on the front.
// SPDX-License-Identifier: MIT
#pragma once

#include "bench/error/cost.hpp"
#include "bench/error/truth.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace bench::error {

/// One method in one case.
struct Row {
    std::string scene, name;  ///< of the case
    Reference reference;
    std::size_t method;  ///< in methods()
    int size;  ///< pixels each way
    std::size_t lights;  ///< of the scene, ambient ones included
    Error error;  ///< against the reference
    double shadingError;  ///< largest against R1, u S: the arithmetic alone, which the bound is about
    CodeError codes;
    double bound;  ///< promised to the default method, u S against R1
    Cost cost;
    double ratio;  ///< lighting cost over that of three.js's order

    bool boundBroken() const { return method == defaultMethod && !(shadingError <= bound); }
};

/// One method in one scene: the worst error and the mean cost of its cases.
struct SceneRow {
    std::string scene;
    std::size_t method;
    Error error;
    CodeError codes;  ///< `max` is the worst, `mean` and `wrong` are the worst case's too
    double lighting = 0;  ///< summed lighting cost, milliseconds
    double frame = 0;  ///< summed cost of whole frames, milliseconds
    int cases = 0;
    /// Lighting cost over that of three.js's order, or in S9, where nothing is lit, frame over floor: the geometric mean of the cases.
    double ratio = 1;
    bool onFront = false;  ///< no method that is more than 3 % cheaper has so small an error in floats
    bool onFrontCodes = false;  ///< the same in 8 bits: largest and mean error
};

/// Whether `ratio` of this scene is the frame over the flat-colour frame.
bool countsFromFloor(const std::string& scene);

/// Sums up the cases of each scene.
std::vector<SceneRow> sumUp(const std::vector<Row>& rows);

/// The median of every number over all scenes but S9, as one more scene, "all".
std::vector<SceneRow> medians(const std::vector<SceneRow>& scenes);

/// The methods of one scene that no cheaper one is as exact as, the cheapest first: the line of the chart, without allowing for noise.
std::vector<const SceneRow*> frontLine(const std::vector<SceneRow>& scene,
                                       const std::function<double(const SceneRow&)>& error);

/// How a run was made.
struct Run {
    std::string driver;  ///< what the driver calls itself
    bool quick;
};

/// Writes error.csv, error_scenes.csv (with the medians), error_front.csv (the charts' lines) and error.json. Throws image::Error.
void write(const std::filesystem::path& directory, const Run& run, const std::vector<Row>& rows,
           const std::vector<SceneRow>& scenes);

/// "R1", "R2", "R3"
const char* shortName(Reference reference);

}  // namespace bench::error
