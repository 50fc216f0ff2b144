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

// The lights stand sorted by their exponent k, so that each loop knows its own.
vec3 add_point_lights(vec3 P, vec3 n, vec3 Q, vec3 v, vec3 D)
{
#if TERM_POINT
#pragma unroll
    for (int i = 0; i < END_DECAY_0; ++i)
        P = add_in_half(P, point_light(i, n, Q, D, 0.0));
#pragma unroll
    for (int i = END_DECAY_0; i < END_DECAY_1; ++i)
        P = add_in_half(P, point_light(i, n, Q, D, 1.0));
#pragma unroll
    for (int i = END_DECAY_1; i < END_DECAY_2; ++i)
        P = add_in_half(P, point_light(i, n, Q, D, 2.0));
#pragma unroll
    for (int i = END_DECAY_2; i < NUM_POINT_LIGHTS; ++i)
        P = add_in_half(P, point_light(i, n, Q, D, point_decay(i)));
#endif
    return P;
}
