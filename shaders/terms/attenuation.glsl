// TERM attenuation | slide 31 | f(d) = 1 / d^k, times three.js's window where a light has a `distance` | off: 1
// SPDX-License-Identifier: MIT
//
// attenuation_divisor() is d^k from d2 = d^2. k is 0, 1 or 2 as a constant, so that only one line is left of it; pow is
// only for exponents that are none of these.
#if TERM_ATTENUATION
float attenuation_divisor(float d2, float k)
{
    return k == 0.0 ? 1.0 : k == 1.0 ? sqrt(d2) : k == 2.0 ? d2 : pow(d2, 0.5 * k);
}
float attenuation_window(float d2, float per_distance2)
{
#if WINDOW
    float x = d2 * per_distance2;  // (d / distance)^2
    float rest = max(0.0, 1.0 - x * x);
    return rest * rest;
#else
    return 1.0;
#endif
}
#else
float attenuation_divisor(float d2, float k) { return 1.0; }
float attenuation_window(float d2, float per_distance2) { return 1.0; }
#endif
