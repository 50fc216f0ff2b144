// Whether the numbers of a draw stay in the range where floats are accurate, or the shader must scale them.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/frame_plan.hpp"

namespace lighting {

/// True where the plain formula, nv / (d d^k) summed up, could leave the range of floats somewhere on this mesh: distances
/// or strengths beyond what divisors from 1e-30 and sums up to 1e37 hold. `box` and `sphere` bound the mesh, object space.
///
/// A light inside the box is taken to stay 2^-14 away from its surface; where it is nearer still, the plain formula stays
/// finite and very bright.
bool needsScaling(const FramePlan& plan, const Draw& draw, const THREE::Box3& box,
                  const THREE::Sphere& sphere);

/// The largest power of two that is not above `x`; x > 0 and finite.
double powerOfTwoBelow(double x);

/// Brings a light's numbers where floats hold them: a position beyond 2^120 nearer along its direction, a colour that falls
/// with d^k multiplied by unit^-k, what is too large or too small for a float put into `exponent`.
void fitToFloats(PointAddend& light, double unit, bool attenuated);

}  // namespace lighting
