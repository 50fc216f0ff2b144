// METHOD three.js's order | normalise w first, then cosine, then 1 / d^k through pow, with k a number that the compiler does not know
// SPDX-License-Identifier: MIT
//
// Known to be wrong with it: f never exceeds 100, because three.js divides by max(d^k, 0.01) (r146); more roundings than needed, and
// those of pow; a light in the very point gives 0 / 0. Written for this benchmark: no highlight, no `distance`, not for SCALED draws.
#if TERM_POINT

vec3 point_light(int i, vec3 n, vec3 Q, vec3 D)
{
    vec3 l = point_position(i) - Q;
    vec3 w = normalize(l);
    float d = length(l);
    float k = point_decay(i) + min(D.x, 0.0);  // adds 0, which only the reader knows: three.js's k is a uniform
    float f = 1.0 / max(pow(d, k), 0.01);
    return clamp(dot(n, w), 0.0, 1.0) * (light_color(point_L(i)) * f) * D;
}

#endif

// One loop: three.js does not sort its lights by exponent.
vec3 add_point_lights(vec3 P, vec3 n, vec3 Q, vec3 v, vec3 D)
{
#if TERM_POINT
#pragma unroll
    for (int i = 0; i < NUM_POINT_LIGHTS; ++i)
        P = add(P, point_light(i, n, Q, D));
#endif
    return P;
}
