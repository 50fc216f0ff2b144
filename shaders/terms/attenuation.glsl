// TERM attenuation | slide 31 | f(d) = 1 / d^k, times three.js's window where a light has a `distance` | off: 1
// SPDX-License-Identifier: MIT
//
// attenuation_divisor() is d^k from d2 = d^2. k is 0, 1 or 2 as a constant, so that only one line is left of it; pow is
// only for exponents that are none of these. Where distances are extreme (range.glsl), d2 belongs to d 2^-e, and
// attenuation_exponent() is what is still to be done: 1 / d^k = 2^attenuation_exponent / attenuation_divisor.
#if TERM_ATTENUATION

float attenuation_divisor(float d2, float k)
{
#if SCALED
    return k == 0.0 ? 1.0 : k == 1.0 ? sqrt(d2) : k == 2.0 ? d2 : 1.0;
#else
    return k == 0.0 ? 1.0 : k == 1.0 ? sqrt(d2) : k == 2.0 ? d2 : pow(d2, 0.5 * k);
#endif
}

float attenuation_exponent(float d2, int e, float k, float light_exponent)
{
    bool power = k == 0.0 || k == 1.0 || k == 2.0;
    return light_exponent - k * (power ? float(e) : float(e) + 0.5 * log2(d2));
}

float attenuation_window(float d2, int e, float per_distance)
{
#if WINDOW && SCALED
    float r = sqrt(d2) * per_distance * power_of_two(e);  // d / distance
    float x = r < 1.0 ? r * r : 1.0;                      // beyond 1 it does not matter how far
#elif WINDOW
    float x = d2 * per_distance * per_distance;  // (d / distance)^2
#else
    float x = 0.0;
#endif
    float rest = max(0.0, 1.0 - x * x);
    return rest * rest;
}

#else

float attenuation_divisor(float d2, float k) { return 1.0; }
float attenuation_exponent(float d2, int e, float k, float light_exponent) { return 0.0; }
float attenuation_window(float d2, int e, float per_distance) { return 1.0; }

#endif
