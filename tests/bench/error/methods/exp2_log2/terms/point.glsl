// METHOD exp2(log2) | 1 / (d d^k) = exp2(-(k + 1)/2 log2 d^2): every exponent alike, no pow, no square root
// SPDX-License-Identifier: MIT
//
// Known to be wrong with it: the absolute error of the exponent becomes a relative one of the result, up to 20 ulp even with perfect
// exp2 and log2; a light in the very point gives 0 * infinity. Written for this benchmark: no highlight, no `distance`, not for
// SCALED draws.
#if TERM_POINT

vec3 point_light(int i, vec3 n, vec3 Q, vec3 D, float k)
{
    vec3 l = point_position(i) - Q;
    float share = dot(n, l) * exp2(-0.5 * (k + 1.0) * log2(dot(l, l)));
    return max(0.0, share) * D * light_color(point_L(i));
}

#endif

#include "../point_loops.glsl"
