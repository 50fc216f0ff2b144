// TERM point | slides 29-31 | the addends of the lights whose direction differs from point to point | off: 0
// SPDX-License-Identifier: MIT
#if TERM_POINT

vec3 point_light(int i, vec3 n, vec3 Q, vec3 D, float k)
{
    vec3 v = point_position(i) - Q;  // towards the light, as long as it is far
    float d2 = dot(v, v);            // d^2
    float divisor = cosine_divisor(d2) * attenuation_divisor(d2, k);
    float c = cosine(n, v);
    // Where d^k is too small for a float, the share is the largest one; a light in the very point has no direction: none.
    float share = divisor > 0.0 ? c / divisor : d2 > 0.0 ? c * 3.4028234e38 : 0.0;
    return clamp_cosine(share) * attenuation_window(d2, point_per_distance2(i)) * D * light_color(point_L(i));
}

#endif

// The lights stand sorted by their exponent k, so that each loop knows its own.
vec3 add_point_lights(vec3 P, vec3 n, vec3 Q, vec3 D)
{
#if TERM_POINT
    for (int i = 0; i < END_DECAY_0; ++i)
        P += point_light(i, n, Q, D, 0.0);
    for (int i = END_DECAY_0; i < END_DECAY_1; ++i)
        P += point_light(i, n, Q, D, 1.0);
    for (int i = END_DECAY_1; i < END_DECAY_2; ++i)
        P += point_light(i, n, Q, D, 2.0);
    for (int i = END_DECAY_2; i < NUM_POINT_LIGHTS; ++i)
        P += point_light(i, n, Q, D, point_decay(i));
#endif
    return P;
}
