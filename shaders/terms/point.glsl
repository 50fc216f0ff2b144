// TERM point | slides 29-31 | the addends of the lights whose direction differs from point to point | off: 0
// SPDX-License-Identifier: MIT
#if TERM_POINT

vec3 point_light(int i, vec3 n, vec3 Q, vec3 D, float k)
{
    vec3 v = point_position(i) - Q;  // towards the light, as long as it is far
    watch(v);
    int e = shrink(v);               // 0 unless distances are extreme
    float d2 = dot(v, v);            // d^2
    float divisor = cosine_divisor(d2) * attenuation_divisor(d2, k);
    float c = cosine(n, v);
    // A light in the very point has no direction and adds nothing. Below 1e-30 a divisor is out of the range that the plan allows.
    float share = d2 > 0.0 ? c / max(divisor, 1e-30) : 0.0;
    vec3 addend = clamp_cosine(share) * attenuation_window(d2, e, point_per_distance(i)) * D * light_color(point_L(i));
    return times_power_of_two(addend, attenuation_exponent(d2, e, k, point_exponent(i)));
}

#endif

// The lights stand sorted by their exponent k, so that each loop knows its own.
vec3 add_point_lights(vec3 P, vec3 n, vec3 Q, vec3 D)
{
#if TERM_POINT
    for (int i = 0; i < END_DECAY_0; ++i)
        P = add(P, point_light(i, n, Q, D, 0.0));
    for (int i = END_DECAY_0; i < END_DECAY_1; ++i)
        P = add(P, point_light(i, n, Q, D, 1.0));
    for (int i = END_DECAY_1; i < END_DECAY_2; ++i)
        P = add(P, point_light(i, n, Q, D, 2.0));
    for (int i = END_DECAY_2; i < NUM_POINT_LIGHTS; ++i)
        P = add(P, point_light(i, n, Q, D, point_decay(i)));
#endif
    return P;
}
