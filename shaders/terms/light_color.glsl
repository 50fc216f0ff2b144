// TERM light_color | slides 26-27, 31 | L_i: how much light of each colour | off: white of the same intensity
// SPDX-License-Identifier: MIT
vec3 light_color(vec4 L)  // L.rgb: colour x intensity, L.a: intensity
{
#if TERM_LIGHT_COLOR
    return L.rgb;
#else
    return vec3(L.a);
#endif
}
