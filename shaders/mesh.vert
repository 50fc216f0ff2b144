// Every vertex of a mesh that is lit at each fragment, or not at all.
// SPDX-License-Identifier: MIT
#include "variant.glsl"
#include "vertex.glsl"

out vec3 worldPosition;
out vec3 worldNormal;

void main()
{
    gl_Position = clip_position();
    worldPosition = lit_position();
    worldNormal = lit_normal();
}
