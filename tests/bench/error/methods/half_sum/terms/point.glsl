// METHOD half accumulation | the point lights' part of it: see half.glsl
// SPDX-License-Identifier: MIT
//
// Each light as the lab computes it. Written for this benchmark: no highlight, no `distance`, not for SCALED draws.
#include "terms/half.glsl"
#if TERM_POINT

vec3 point_light(int i, vec3 n, vec3 Q, vec3 D, float k)
{
    vec3 l = point_position(i) - Q;
    float d2 = dot(l, l);
    float share = d2 > 0.0 ? dot(n, l) / max(sqrt(d2) * attenuation_divisor(d2, k), 1e-30) : 0.0;
    return max(0.0, share) * D * light_color(point_L(i));
}

#endif

#define add add_in_half
#include "../point_loops.glsl"
#undef add
