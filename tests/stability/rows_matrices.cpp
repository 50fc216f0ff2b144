// Rows M1 to M14: normals through model matrices.
// SPDX-License-Identifier: MIT
#include "stability/rows.hpp"

#include "support/strict_glsl.hpp"

#include <limits>

namespace stability {

namespace {

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

MatrixCase scaled(const glm::dvec3& scale) { return {scale}; }
MatrixCase uniform(double s) { return scaled(glm::dvec3(s)); }

Setup posed(std::function<void(THREE::Mesh&)> pose) {
    Setup s{{sun({0, 0, 1})}};
    s.pose = std::move(pose);
    return s;
}

// Nothing to see and nothing to go wrong, with skips or without.
void darkFrame(const glm::dvec3& scale, std::size_t draws, Outcome& outcome) {
    for (const bool skip : {true, false}) {
        Stage stage(posed([scale](THREE::Mesh& mesh) { mesh.scale = scale; }), 1);
        stage.options.settings.skip = skip;
        const support::Drawn drawn = support::draw(stage.scene, stage.camera, stage.options);
        require(outcome, drawn.plan.draws.size() == draws,
                "expected " + std::to_string(draws) + " draws, found " +
                    std::to_string(drawn.plan.draws.size()));
        for (const float value : drawn.floats())
            if (value != 0) {
                require(outcome, false, "a pixel holds " + number(value) + ", expected the black background");
                return;
            }
    }
    outcome.gl = "nothing drawn";
}

void vanished(Outcome& outcome) {
    runMatrix({glm::dvec3(1)}, outcome);  // that an ordinary one is drawn where this one is not
    darkFrame(glm::dvec3(0), 0, outcome);
    askMatrixPeers(glm::dmat4(0), outcome);
    outcome.expected = outcome.twin = "nothing drawn";
    outcome.bound = "exact";
    outcome.error = -1;
}

// A line covers no pixel, but its vertices are run: the normal is undefined, so that only ambient light is left.
void line(Outcome& outcome) {
    darkFrame({1, 0, 0}, 1, outcome);
    Stage stage(posed([](THREE::Mesh& mesh) { mesh.scale.set(1, 0, 0); }), 1);
    const Twin strict = twin(stage);
    require(outcome, strict.P == glm::vec3(static_cast<float>(A)) && !strict.nonfinite,
            "strict IEEE gives " + number(strict.P.r) + ", expected the ambient light alone");
    askMatrixPeers(glm::dmat4(glm::dvec4(1, 0, 0, 0), glm::dvec4(0), glm::dvec4(0), glm::dvec4(0, 0, 0, 1)),
                   outcome);
    outcome.expected = number(A);
    outcome.twin = number(strict.P.r);
    outcome.bound = "exact";
}

Setup notANumber() {
    Setup s = posed([](THREE::Mesh& mesh) {
        mesh.matrixAutoUpdate = false;
        mesh.matrix.elements[1][2] = NaN;
    });
    s.refused = {"Mesh 'piano'", "matrixWorld"};
    return s;
}

}  // namespace

std::vector<Row> matrixRows() {
    const glm::dvec3 leaning(0.3, 0.7, 1);
    std::vector<Row> all{
        {"M1", "flattened", "scale (1, 1, 0)", Kind::matrix, {}, MatrixCase{{1, 1, 0}, false, 1e-5, leaning}},
        {"M2", "vanished", "scale 0", Kind::matrix, {}, {}, vanished},
        {"M3", "line", "scale (1, 0, 0)", Kind::matrix, {}, {}, line},
        {"M4", "mirror", "scale (-1, 1, 1)", Kind::matrix, {}, scaled({-1, 1, 1})},
        {"M5", "uniform 1e-13", "scale 1e-13", Kind::matrix, {}, uniform(1e-13)},
        {"M6", "uniform 1e-16", "scale 1e-16", Kind::matrix, {}, uniform(1e-16)},
        {"M7", "uniform 1e-20", "scale 1e-20", Kind::matrix, {}, uniform(1e-20)},
        {"M8", "uniform 1e13", "scale 1e13", Kind::matrix, {}, uniform(1e13)},
        {"M9", "uniform 1e20", "scale 1e20", Kind::matrix, {}, uniform(1e20)},
        {"M10",
         "one axis 1e-30",
         "scale (1, 1, 1e-30)",
         Kind::matrix,
         {},
         MatrixCase{{1, 1, 1e-30}, false, 1e-5, leaning}},
        {"M11",
         "model matrix used for normals",
         "scale (1, 2, 3)",
         Kind::matrix,
         {},
         scaled({1, 2, 3}),
         modelMatrixForNormals},
        {"M12",
         "nested scale",
         "R diag(1e6, 1, 1e-6) R'",
         Kind::matrix,
         {},
         MatrixCase{{1e6, 1, 1e-6}, true, 2e-3}},
        {"M13",
         "nested, two axes 1e-4",
         "R diag(1, 1e-4, 1e-4) R'",
         Kind::matrix,
         {},
         MatrixCase{{1, 1e-4, 1e-4}, true, 1e-4}},
        {"M14",
         "NaN entry",
         "a matrix set by hand",
         Kind::refused,
         {notANumber()},
         {},
         [](Outcome& o) { askMatrixPeers(glm::dmat4(NaN), o); }},
    };
    return all;
}

}  // namespace stability
