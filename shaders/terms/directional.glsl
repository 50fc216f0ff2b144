// TERM directional | slides 29-30 | the addends of the lights whose direction w is the same everywhere | off: 0
// SPDX-License-Identifier: MIT
vec3 add_directional_lights(vec3 P, vec3 n, vec3 v, vec3 D)
{
#if TERM_DIRECTIONAL
#pragma unroll
    for (int i = 0; i < NUM_DIRECTIONAL_LIGHTS; ++i) {
        vec3 w = directional_w(i);
        vec3 reflected = clamp_cosine(cosine(n, w)) * D;
        P = add(P, add_highlight(reflected, n, w, v, 1.0) * light_color(directional_L(i)));
    }
#endif
    return P;
}
