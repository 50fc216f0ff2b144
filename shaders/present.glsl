// How a frame shows P (--view): as it is, one channel of it in grey (slide 26), or dimmed, with stripes where it is above 1 (slide 39).
// SPDX-License-Identifier: MIT
#if SHOW_CHANNEL  // 1 red, 2 green, 3 blue

vec3 present(vec3 P) { return vec3(SHOW_CHANNEL == 1 ? P.x : SHOW_CHANNEL == 2 ? P.y : P.z); }

#elif MARK_OVEREXPOSED

// What an 8-bit picture cuts off: its code would be above 255.
int overexposed(float x) { return x > 1.0 + 0.5 / 255.0 ? 1 : 0; }

// Diagonal stripes, the wider the more channels are above 1, so that they can be told apart without their hues.
vec3 present(vec3 P)
{
    int channels = overexposed(P.x) + overexposed(P.y) + overexposed(P.z);
    float along = mod(floor(gl_FragCoord.x) + floor(gl_FragCoord.y), 8.0);
    if (along >= 2.0 * float(channels))
        return 0.35 * clamp(P, 0.0, 1.0);
    return (channels == 1 ? vec3(86.0, 180.0, 233.0) : channels == 2 ? vec3(240.0, 228.0, 66.0) : vec3(255.0)) / 255.0;
}

#else

vec3 present(vec3 P) { return P; }

#endif
