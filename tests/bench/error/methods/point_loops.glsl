// What methods that change point_light(i, n, Q, D, k) alone share: the lab's own loops, without highlights and clusters.
// SPDX-License-Identifier: MIT

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
