// The table as a whole, and how a row is run.
// SPDX-License-Identifier: MIT
#include "stability/rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace stability {

const char* name(Kind kind) {
    constexpr std::array names{"shading", "refused", "matrix", "camera", "sum", "frame"};
    return names[static_cast<std::size_t>(kind)];
}

std::string number(double x) {
    if (std::isnan(x))
        return "NaN";  // printf may print its sign, which says nothing
    char text[40];
    std::snprintf(text, sizeof text, "%.5g", x);
    return text;
}

Peer peer(double found, double expected) {
    if (!std::isfinite(found))
        return {number(found), Peer::notFinite};
    const double code = std::max(1.0, std::abs(expected)) / 255;
    return {number(found), std::abs(found - expected) <= code ? Peer::ok : Peer::wrong};
}

void require(Outcome& outcome, bool good, const std::string& failure) {
    if (!good)
        outcome.failures.push_back(failure);
}

const std::vector<Row>& rows() {
    static const std::vector<Row> all = [] {
        std::vector<Row> list;
        for (const auto& family : {geometryRows, lightRows, attenuationRows, matrixRows, cameraRows, sumRows,
                                   frameRows, phongRows})
            for (Row& row : family())
                list.push_back(std::move(row));
        return list;
    }();
    return all;
}

const Row& row(const std::string& id) {
    for (const Row& row : rows())
        if (id == row.id)
            return row;
    throw std::out_of_range("no row " + id);
}

namespace {

// "geometry.attributes.normal": the attribute.
std::string lastWord(const std::string& field) {
    const std::size_t dot = field.rfind("s.");
    return dot == std::string::npos ? field : field.substr(dot + 2);
}

}  // namespace

Outcome run(const Row& row) {
    Outcome outcome;
    bool first = true;
    for (const Setup& setup : row.setups) {
        const Measured measured = measure(setup);
        for (const std::string& failure : measured.failures)
            outcome.failures.push_back(failure);
        outcome.spaces = std::max(outcome.spaces, measured.spaces);
        if (setup.refused.empty())
            outcome.error = std::max(outcome.error, measured.error);
        if (!first)
            continue;
        first = false;
        const bool refused = !setup.refused.empty();
        outcome.expected = refused ? "refused" : number(setup.expected.value_or(measured.expected));
        outcome.twin = outcome.gl = refused ? "refused" : "";
        outcome.bound = refused ? "names " + lastWord(setup.refused.back()) : setup.bound.text();
        if (!refused) {
            outcome.twin = number(measured.twin);
            outcome.gl = number(measured.gl);
        }
        askPeers(setup, refused ? std::nan("") : measured.expected, outcome);
    }
    if (row.matrix)
        runMatrix(*row.matrix, outcome);
    if (row.also)
        row.also(outcome);
    return outcome;
}

}  // namespace stability
