// What the pixels of a case should be, and how far a frame is from that.
// SPDX-License-Identifier: MIT
#pragma once

#include "bench/error/scenes.hpp"
#include "image/frame.hpp"

#include <cstdint>
#include <vector>

namespace bench::error {

/// The right value of each pixel, top row first.
struct Truth {
    using Vec = lighting::reference::Vec3<long double>;
    std::vector<std::uint8_t> judged;  ///< 1 where a lit surface is seen and, for R3, no edge is near
    std::vector<Vec> P;  ///< the value
    std::vector<Vec> S;  ///< what errors are relative to: the same with every cosine taken as 1
};

/// The references of a case.
struct Truths {
    Truth own;  ///< by Case::reference
    Truth shading;  ///< R1, for the bound
    double bound = 0;  ///< what is promised against R1, in units of u S
    /// What doubles give: at the points of R1, or, for R3, from the scene.
    image::Floats doubles;
};
Truths makeTruths(const Case& which, World& world, int size);

/// How far a frame is from the truth.
struct Error {
    double max = 0;  ///< largest |error| in u S; not finite numbers count as 1e30
    double p999 = 0;  ///< 99.9 % of the values are no farther off
    long long values = 0;  ///< how many were judged: three a pixel
};
Error floatError(const Truth& truth, const image::Floats& frame);

/// The same in 8 bits, against the truth rounded to the nearest code (R4).
struct CodeError {
    int max = 0;  ///< codes
    double mean = 0;  ///< codes
    double wrong = 0;  ///< share of values with another code than the truth's
};
CodeError codeError(const Truth& truth, const image::Bytes& frame);

}  // namespace bench::error
