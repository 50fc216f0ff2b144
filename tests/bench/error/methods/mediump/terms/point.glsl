// METHOD mediump | everything in the 16-bit floats that a telephone may have for mediump: half the registers there
// SPDX-License-Identifier: MIT
//
// Known to be wrong with it: 11 bits of mantissa, half a code at d = 1 and worse far away; d^2 is infinite from d = 256 on, d^2 sqrt(d^2)
// from 40 on. Drivers are free to take 32 bits instead: then this is the default. Written for this benchmark: no highlight, no
// `distance`, not for SCALED draws.
#if TERM_POINT

mediump vec3 point_light(int i, mediump vec3 n, mediump vec3 Q, mediump vec3 D, mediump float k)
{
    mediump vec3 p = point_position(i), L = light_color(point_L(i));
    mediump vec3 l = p - Q;
    mediump float d2 = dot(l, l);
    mediump float d = sqrt(d2), nv = dot(n, l);
    mediump float share = k == 0.0 ? nv / d : k == 1.0 ? nv / d2 : k == 2.0 ? nv / (d2 * d) : nv / (d * pow(d, k));
    return max(0.0, share) * D * L;
}

#endif

vec3 add_point_lights(mediump vec3 P, mediump vec3 n, mediump vec3 Q, vec3 v, mediump vec3 D)
{
#if TERM_POINT
#pragma unroll
    for (int i = 0; i < END_DECAY_0; ++i)
        P += point_light(i, n, Q, D, 0.0);
#pragma unroll
    for (int i = END_DECAY_0; i < END_DECAY_1; ++i)
        P += point_light(i, n, Q, D, 1.0);
#pragma unroll
    for (int i = END_DECAY_1; i < END_DECAY_2; ++i)
        P += point_light(i, n, Q, D, 2.0);
#pragma unroll
    for (int i = END_DECAY_2; i < NUM_POINT_LIGHTS; ++i)
        P += point_light(i, n, Q, D, point_decay(i));
#endif
    return P;
}
