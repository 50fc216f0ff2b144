// Keeps numbers inside the range of floats where a scene's distances or strengths are extreme (SCALED: the frame plan
// says so, draw by draw). In every other scene these functions are nothing: true, v itself, x itself, a plain sum.
// SPDX-License-Identifier: MIT
#if SCALED

const float LARGEST = 3.4028234e38;

// 2^e as a float, e from -126 to 127
float power_of_two(int e) { return uintBitsToFloat(uint(e + 127) << 23); }

// Brings the largest component of v to between 1 and 2 and returns the e of v_before = v_after 2^e.
int shrink(inout vec3 v)
{
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    int e = clamp(int(floatBitsToUint(largest) >> 23) - 127, -126, 126);
    v *= power_of_two(-e);
    return e;
}

// Over a triangle that is no more than a line, drivers may interpolate positions that are no numbers.
bool is_number(float x) { return (floatBitsToUint(x) & 0x7F800000u) != 0x7F800000u; }
bool is_surface(vec3 Q) { return is_number(Q.x) && is_number(Q.y) && is_number(Q.z); }

// What is beyond the largest float becomes the largest float.
vec3 limit(vec3 x)
{
    watch_nan(x);
    return clamp(x, -LARGEST, LARGEST);
}

// x 2^e, in two steps so that neither leaves the range before the other brings it back; the limit between them also keeps
// compilers from multiplying the two steps first
vec3 times_power_of_two(vec3 x, float e)
{
    e = clamp(e, -252.0, 252.0);
    int whole = int(floor(e));
    x = limit(x * (exp2(e - float(whole)) * power_of_two(whole / 2)));
    return limit(x * power_of_two(whole - whole / 2));
}

vec3 add(vec3 P, vec3 x) { return limit(P + x); }

// Colours on their way through the rasteriser, which has to multiply and divide them by depths.
vec3 to_varying(vec3 P) { return P * power_of_two(-32); }
vec3 from_varying(vec3 P) { return limit(P * power_of_two(32)); }

#else

bool is_surface(vec3 Q) { return true; }
int shrink(inout vec3 v) { return 0; }
vec3 times_power_of_two(vec3 x, float e) { return x; }
vec3 add(vec3 P, vec3 x) { return P + x; }
vec3 to_varying(vec3 P) { return P; }
vec3 from_varying(vec3 P) { return P; }

#endif
