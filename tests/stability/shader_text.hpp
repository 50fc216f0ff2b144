// What the text of the shaders says of precision, before any driver has a say.
// SPDX-License-Identifier: MIT
#pragma once

#include "stability/rows.hpp"

namespace stability {

/// Every shader, in its largest variant, declares highp float and int as its default, and nothing mediump or lowp.
void requireHighp(Outcome& outcome);

/// Draws a plan in floats with a mesh.frag that shows another expression than the equation's result, in GLSL. Needs the
/// context of support::draw, which must have drawn before.
image::Floats drawExpression(const lighting::FramePlan& plan, const support::DrawOptions& options,
                             const std::string& expression);

}  // namespace stability
