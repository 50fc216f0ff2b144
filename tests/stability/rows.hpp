// The stability suite: every row of the table of ways in which lighting goes wrong in floats, by its id and name.
// SPDX-License-Identifier: MIT
#pragma once

#include "stability/setup.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace stability {

/// What a row is about.
enum class Kind {
    shading,  ///< a pixel of a frame, against a truth
    refused,  ///< THREE::validate names object and field
    matrix,  ///< a normal through a model matrix
    camera,  ///< a view or a rotation
    sum,  ///< many addends
    frame,  ///< how pixels are stored
};
const char* name(Kind kind);

/// What others make of a row, for the report.
struct Peer {
    std::string text;
    enum Verdict { none, ok, wrong, notFinite } verdict = none;
};
/// A single number against the truth: wrong if it is off by more than one code of a picture exposed for it.
Peer peer(double found, double expected);

/// What a row comes to.
struct Outcome {
    Peer naive;  ///< GLSL as one writes it first
    Peer legacy;  ///< three.js's formula, lights as in r146 by default
    Peer
        physical;  ///< three.js's formula with physicallyCorrectLights (and the only one since r165), but for its factor pi
    std::string expected, twin, gl, bound;
    double error = -1;  ///< the worst that was measured, in units of u S; negative: has no such unit
    double spaces = 0;  ///< how much view space changes a frame, relative to its brightest pixel
    std::vector<std::string> failures;  ///< what misses its bound; a row passes if there are none
};

/// A model matrix as two nested objects: turned, scaled, turned again.
struct MatrixCase {
    glm::dvec3 scale{1};
    bool nested = false;  ///< turned before and after the scale; else the scale alone
    double degrees = 1e-5;  ///< how far a normal may be off
    std::optional<glm::dvec3> normal{};  ///< the one that is shown; none: (0.36, 0.48, 0.8)
};

/// A row of the table.
struct Row {
    const char* id;
    const char* name;
    const char* input;  ///< in words
    Kind kind;
    std::vector<Setup> setups{};  ///< all must hold; the first is what others are asked
    std::optional<MatrixCase> matrix{};
    /// Whatever else must hold; called after the above, adds to what they found.
    std::function<void(Outcome&)> also{};
};

/// All, in order: accuracy's 84, and those of highlights and of lighting per vertex.
const std::vector<Row>& rows();
const Row& row(const std::string& id);

/// Runs a row.
Outcome run(const Row& row);

/// Adds a failure unless `good`.
void require(Outcome& outcome, bool good, const std::string& failure);
/// Five digits.
std::string number(double x);

// The families.
std::vector<Row> geometryRows();  // G
std::vector<Row> lightRows();  // L
std::vector<Row> attenuationRows();  // A
std::vector<Row> matrixRows();  // M
std::vector<Row> cameraRows();  // C
std::vector<Row> sumRows();  // S
std::vector<Row> frameRows();  // F
std::vector<Row> phongRows();  // P

// How the parts of a row are run.
void runMatrix(const MatrixCase& matrix, Outcome& outcome);
/// What others make of the normal (0.36, 0.48, 0.8).
void askMatrixPeers(const glm::dmat4& model, Outcome& outcome);
/// M11: what slide 33 says to the letter, the model matrix itself, as the naive one.
void modelMatrixForNormals(Outcome& outcome);
/// What others make of a setup, each in strict IEEE float; the last two are three.js's.
void askPeers(const Setup& setup, double expected, Outcome& outcome);

}  // namespace stability
