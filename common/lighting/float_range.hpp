// Whether the numbers of a draw stay in the range where floats are accurate, or the shader must scale them.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/frame_plan.hpp"

namespace lighting {

class MeshBounds;

/// The lights of a plan, asked draw by draw. Lights that add nothing (`dark`) are left out, so that the answer is the same
/// whether they are kept or not.
class FloatRange {
  public:
    /// Of the plan's lights as they are now; the plan must outlive it.
    explicit FloatRange(const FramePlan& plan);

    /// True where the plain formula, nv / (d d^k) summed up, could leave the range of floats somewhere on this draw's mesh:
    /// distances or strengths beyond what divisors from 1e-30 and sums up to 1e37 hold.
    ///
    /// A light inside the mesh's box is taken to stay 2^-14 away from its surface; where it is nearer still, the plain
    /// formula stays finite and very bright.
    bool leftBy(const Draw& draw) const;

  private:
    bool clearlyStays(const Draw& draw, const MeshBounds& bounds) const;

    const FramePlan& plan_;
    double everywhere_ = 0;  // strength of ambient and directional light
    double worst_ = 0;  // of all light where each point light is as near as it may be
    double steepest_ = 0;  // largest k
    bool extreme_ = false;  // a light has an exponent
    glm::dvec3 low_{0}, high_{0};  // box of the point lights
    std::vector<const PointAddend*> byX_;  // those that are not dark
};

/// The largest power of two that is not above `x`; x > 0 and finite.
double powerOfTwoBelow(double x);

/// The largest component.
inline double largest(const glm::dvec3& v) {
    return v.x > v.y ? (v.x > v.z ? v.x : v.z) : (v.y > v.z ? v.y : v.z);
}

/// Brings a light's numbers where floats hold them: a position beyond 2^120 nearer along its direction, a colour that falls
/// with d^k multiplied by unit^-k, what is too large or too small for a float put into `exponent`.
void fitToFloats(PointAddend& light, double unit, bool attenuated);

}  // namespace lighting
