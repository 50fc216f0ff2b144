// TERM point | slides 29-31 | the addends of the lights whose direction differs from point to point | off: 0
// SPDX-License-Identifier: MIT
#if TERM_POINT

vec3 point_light(int i, vec3 n, vec3 Q, vec3 v, vec3 D, float k)
{
    vec3 l = point_position(i) - Q;  // towards the light, as long as it is far: w is l / d
    watch(l);
    int e = shrink(l);               // 0 unless distances are extreme
    float d2 = dot(l, l);            // d^2
    float power = attenuation_divisor(d2, k);
    // A light in the very point has no direction and adds nothing. Below 1e-30 a divisor is out of the range that the plan allows.
    float share = d2 > 0.0 ? cosine(n, l) / max(cosine_divisor(d2) * power, 1e-30) : 0.0;
    float f = d2 > 0.0 ? 1.0 / max(power, 1e-30) : 0.0;
    vec3 w = d2 > 0.0 ? l / sqrt(d2) : vec3(0.0);
    vec3 reflected = add_highlight(clamp_cosine(share) * D, n, w, v, f);
    vec3 addend = attenuation_window(d2, e, point_per_distance(i)) * reflected * light_color(point_L(i));
    return times_power_of_two(addend, attenuation_exponent(d2, e, k, point_exponent(i)));
}

#endif

// The lights stand sorted by their exponent k, so that each loop knows its own.
vec3 add_point_lights(vec3 P, vec3 n, vec3 Q, vec3 v, vec3 D)
{
#if TERM_POINT
#pragma unroll
    for (int i = 0; i < END_DECAY_0; ++i)
        P = add(P, point_light(i, n, Q, v, D, 0.0));
#pragma unroll
    for (int i = END_DECAY_0; i < END_DECAY_1; ++i)
        P = add(P, point_light(i, n, Q, v, D, 1.0));
#pragma unroll
    for (int i = END_DECAY_1; i < END_DECAY_2; ++i)
        P = add(P, point_light(i, n, Q, v, D, 2.0));
#pragma unroll
    for (int i = END_DECAY_2; i < NUM_POINT_LIGHTS; ++i)
        P = add(P, point_light(i, n, Q, v, D, point_decay(i)));
#if CLUSTERED
    // and after them those that end, from the lists of the fragment's cluster
    int list = cluster_list();
    int begin_0 = CLUSTERED_DECAY_0 ? list_begin(list) : 0, end_0 = CLUSTERED_DECAY_0 ? list_begin(list + 1) : 0;
    int begin_1 = CLUSTERED_DECAY_1 ? list_begin(list + 1) : 0, end_1 = CLUSTERED_DECAY_1 ? list_begin(list + 2) : 0;
    int begin_2 = CLUSTERED_DECAY_2 ? list_begin(list + 2) : 0, end_2 = CLUSTERED_DECAY_2 ? list_begin(list + 3) : 0;
    int begin_3 = CLUSTERED_DECAY_OTHER ? list_begin(list + 3) : 0, end_3 = CLUSTERED_DECAY_OTHER ? list_begin(list + 4) : 0;
#pragma unroll
    for (int j = begin_0; j < end_0; ++j)
        P = add(P, point_light(listed_light(j), n, Q, v, D, 0.0));
#pragma unroll
    for (int j = begin_1; j < end_1; ++j)
        P = add(P, point_light(listed_light(j), n, Q, v, D, 1.0));
#pragma unroll
    for (int j = begin_2; j < end_2; ++j)
        P = add(P, point_light(listed_light(j), n, Q, v, D, 2.0));
#pragma unroll
    for (int j = begin_3; j < end_3; ++j)
        P = add(P, point_light(listed_light(j), n, Q, v, D, point_decay(listed_light(j))));
#endif
#endif
    return P;
}
