// METHOD half accumulation | the directional lights' part of it: see half.glsl
// SPDX-License-Identifier: MIT
#include "terms/half.glsl"
vec3 add_directional_lights(vec3 P, vec3 n, vec3 v, vec3 D)
{
#if TERM_DIRECTIONAL
#pragma unroll
    for (int i = 0; i < NUM_DIRECTIONAL_LIGHTS; ++i)
        P = add_in_half(P, max(0.0, dot(n, directional_w(i))) * D * light_color(directional_L(i)));
#endif
    return P;
}
