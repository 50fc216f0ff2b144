// METHOD mixed mediump | the vector to the light, d^2 and the division in 32 bits, colours and sums in the 16 bits of mediump
// SPDX-License-Identifier: MIT
//
// Known to be wrong with it: the sum of the lights has 11 bits of mantissa, a sixteenth of a code near white for every light that is
// added; more than 65,504 is infinite. Drivers are free to take 32 bits instead. Written for this benchmark: no highlight, no
// `distance`, not for SCALED draws.
#if TERM_POINT

mediump vec3 point_light(int i, vec3 n, vec3 Q, mediump vec3 D, float k)
{
    vec3 l = point_position(i) - Q;
    float d2 = dot(l, l), d = sqrt(d2), nv = dot(n, l);
    mediump float share =
        max(0.0, k == 0.0 ? nv / d : k == 1.0 ? nv / d2 : k == 2.0 ? nv / (d2 * d) : nv / (d * pow(d, k)));
    mediump vec3 L = light_color(point_L(i));
    return share * D * L;
}

#endif

vec3 add_point_lights(mediump vec3 P, vec3 n, vec3 Q, vec3 v, mediump vec3 D)
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
