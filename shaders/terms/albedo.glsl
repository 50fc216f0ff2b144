// TERM albedo | slides 14, 27 | D: the share of each colour that the surface sends back | off: (1, 1, 1)
// SPDX-License-Identifier: MIT
vec3 albedo(vec3 D)
{
#if TERM_ALBEDO
    return D;
#else
    return vec3(1.0);
#endif
}
