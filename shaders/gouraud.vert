// Every vertex of a mesh that is lit at its vertices (--shading vertex, slide 33): the equation is here, for both sides where
// both are drawn, because which one is seen is known only at the fragment.
// SPDX-License-Identifier: MIT
#include "variant.glsl"
#include "vertex.glsl"
#include "lighting.glsl"

uniform vec3 baseColor;  // D, slide 27
#if EMISSIVE
uniform vec3 emissive;   // light of its own
#else
const vec3 emissive = vec3(0.0);
#endif

out vec3 frontColor;
invariant frontColor;  // as variant.glsl's pixel
#if DOUBLE_SIDED
out vec3 backColor;
invariant backColor;
#endif
#if COUNT_NONFINITE
out float metNonfinite;
#endif

void main()
{
    gl_Position = clip_position();
    vec3 Q = lit_position();
    vec3 n = lit_normal();
    watch(Q);
    watch(n);
    frontColor = to_varying(add(lighting(n, Q, baseColor), emissive));
#if DOUBLE_SIDED
    backColor = to_varying(add(lighting(-n, Q, baseColor), emissive));
#endif
#if COUNT_NONFINITE
    metNonfinite = met_nonfinite ? 1.0 : 0.0;
#endif
}
