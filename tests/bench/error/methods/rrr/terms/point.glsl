// METHOD r r r | one inverse square root r = 1 / d, multiplied once for the cosine and k times for the attenuation
// SPDX-License-Identifier: MIT
//
// Known to be wrong with it: r's rounding counts k + 1 times, so the bound is 20.5 u instead of 14.5 for k = 2; a light in the very
// point gives 0 * infinity. Written for this benchmark: no highlight, no `distance`, not for SCALED draws.
#if TERM_POINT

vec3 point_light(int i, vec3 n, vec3 Q, vec3 D, float k)
{
    vec3 l = point_position(i) - Q;
    float r = inversesqrt(dot(l, l));
    float nr = dot(n, l) * r;
    float share = k == 0.0 ? nr : k == 1.0 ? nr * r : k == 2.0 ? nr * r * r : nr * pow(r, k);
    return max(0.0, share) * D * light_color(point_L(i));
}

#endif

#include "../point_loops.glsl"
