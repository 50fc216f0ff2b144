// What every shader of a variant shares. The framework writes the #defines above it: only what the scene has.
// SPDX-License-Identifier: MIT

#if COUNT_NONFINITE

// What met NaN or infinity anywhere is marked (--stats, tests).
bool met_nonfinite = false;

void watch(float x)
{
    if ((floatBitsToUint(x) & 0x7F800000u) == 0x7F800000u)
        met_nonfinite = true;
}
void watch(vec3 v) { watch(v.x); watch(v.y); watch(v.z); }

// The same where infinity is allowed, because it is about to be limited.
void watch_nan(float x)
{
    if ((floatBitsToUint(x) & 0x7FFFFFFFu) > 0x7F800000u)
        met_nonfinite = true;
}
void watch_nan(vec3 v) { watch_nan(v.x); watch_nan(v.y); watch_nan(v.z); }

#else

void watch(float x) {}
void watch(vec3 v) {}
void watch_nan(float x) {}
void watch_nan(vec3 v) {}

#endif

#ifdef FRAGMENT_SHADER

layout(location = 0) out vec4 pixel;
invariant pixel;  // the same bits whatever else a variant has: no compiler may, say, take a common factor out of the sum
#if COUNT_NONFINITE
layout(location = 1) out vec4 nonfinite;  // a second target
#endif

// -1 on the back of a surface that is drawn on its back too, as in three.js
float facing()
{
#if DOUBLE_SIDED
    return gl_FrontFacing ? 1.0 : -1.0;
#else
    return 1.0;
#endif
}

#include "present.glsl"

// A sum beyond the largest float is stored as the largest float.
void write_pixel(vec3 P)
{
    watch(P);
    pixel = vec4(present(clamp(P, -3.4028234e38, 3.4028234e38)), 1.0);
#if COUNT_NONFINITE
    nonfinite = vec4(met_nonfinite ? 1.0 : 0.0);
#endif
}

#endif
