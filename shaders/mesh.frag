// Every fragment of a lit mesh: the lighting equation at its point (slide 33: per-pixel lighting).
// SPDX-License-Identifier: MIT
#include "variant.glsl"
#include "lighting.glsl"

in vec3 worldPosition;  // about the anchor (or in view space), as the lights' positions are
in vec3 worldNormal;    // interpolated, so shorter than 1 between the vertices

uniform vec3 baseColor;  // D, slide 27
#if EMISSIVE
uniform vec3 emissive;   // light of its own
#else
const vec3 emissive = vec3(0.0);
#endif

void main()
{
    if (!is_surface(worldPosition))
        discard;
    watch(worldPosition);
    watch(worldNormal);
    float length2 = dot(worldNormal, worldNormal);
    vec3 n = length2 > 0.0 ? worldNormal * (facing() / sqrt(length2)) : vec3(0.0);
    write_pixel(add(lighting(n, worldPosition, baseColor), emissive));
}
