// METHOD 0x5f3759df | 1 / sqrt(d^2) guessed from the bits of the float, and one step of Newton's: history, when square roots were slow
// SPDX-License-Identifier: MIT
//
// Known to be wrong with it: r is off by up to 0.18 %, and so k + 1 times that in the light: over a code in 8 bits. Written for this
// benchmark: no highlight, no `distance`, not for SCALED draws.
#if TERM_POINT

float inverse_sqrt(float x)
{
    float y = uintBitsToFloat(0x5f3759dfu - (floatBitsToUint(x) >> 1));
    return y * (1.5 - 0.5 * x * y * y);
}

vec3 point_light(int i, vec3 n, vec3 Q, vec3 D, float k)
{
    vec3 l = point_position(i) - Q;
    float r = inverse_sqrt(dot(l, l));
    float nr = dot(n, l) * r;
    float share = k == 0.0 ? nr : k == 1.0 ? nr * r : k == 2.0 ? nr * r * r : nr * pow(r, k);
    return max(0.0, share) * D * light_color(point_L(i));
}

#endif

#include "../point_loops.glsl"
