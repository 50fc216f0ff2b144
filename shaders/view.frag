// Every fragment of a lit mesh where a view shows one quantity of the equation, of one light, instead of P (--view). The terms are those
// of the equation itself: one that is off is its neutral element here too.
// SPDX-License-Identifier: MIT
#include "variant.glsl"
#include "lights.glsl"
#include "range.glsl"
#include "terms/albedo.glsl"
#include "terms/cosine.glsl"
#include "terms/clamp.glsl"
#include "terms/attenuation.glsl"
#include "terms/light_color.glsl"

in vec3 worldPosition;  // about the anchor
in vec3 worldNormal;    // interpolated, so shorter than 1 between the vertices

uniform vec3 baseColor;  // D, slide 27

vec3 code(float r, float g, float b) { return vec3(r, g, b) / 255.0; }

// Black to white from 0 to 1; black to sky blue from 0 to -1.
vec3 signed_grey(float x) { return x < 0.0 ? min(-x, 1.0) * code(86.0, 180.0, 233.0) : vec3(x); }

// Steps of 0.1: greys, or, hatched, blues where the light is behind.
vec3 band(float x)
{
    float at = clamp(floor(x * 10.0), -10.0, 9.0);
    vec3 behind = mix(code(38.0, 64.0, 102.0), code(89.0, 178.0, 255.0), -0.1 * at);
    if (mod(floor(gl_FragCoord.x) + floor(gl_FragCoord.y), 6.0) < 2.0)
        behind = vec3(0.0);
    return at < 0.0 ? behind : vec3((at + 1.0) / 10.0);
}

// From 1/64 to 4, a colour per octave; each is brighter than the one before (L* from 12 to 92), so hues need not be seen.
vec3 heat(float x)
{
    float octave = log2(max(x, 1e-30)) + 6.0;
    vec3 color = code(46.0, 8.0, 86.0);
    color = mix(color, code(53.0, 38.0, 120.0), clamp(octave, 0.0, 1.0));
    color = mix(color, code(48.0, 72.0, 135.0), clamp(octave - 1.0, 0.0, 1.0));
    color = mix(color, code(40.0, 105.0, 140.0), clamp(octave - 2.0, 0.0, 1.0));
    color = mix(color, code(33.0, 138.0, 135.0), clamp(octave - 3.0, 0.0, 1.0));
    color = mix(color, code(56.0, 169.0, 115.0), clamp(octave - 4.0, 0.0, 1.0));
    color = mix(color, code(116.0, 196.0, 82.0), clamp(octave - 5.0, 0.0, 1.0));
    color = mix(color, code(192.0, 215.0, 57.0), clamp(octave - 6.0, 0.0, 1.0));
    return mix(color, code(254.0, 234.0, 90.0), clamp(octave - 7.0, 0.0, 1.0));
}

// The one light's factors, as terms/directional.glsl and terms/point.glsl have them.
vec3 factor(vec3 n, vec3 Q, vec3 D)
{
    bool from_point = NUM_POINT_LIGHTS > 0;
    vec3 l = from_point ? point_position(0) - Q : directional_w(0);
    watch(l);
    int e = from_point ? shrink(l) : 0;
    float d2 = from_point ? dot(l, l) : 1.0;
    float c = d2 > 0.0 ? cosine(n, l) / max(from_point ? cosine_divisor(d2) : 1.0, 1e-30) : 0.0;
    if (VIEW == VIEW_ALBEDO)
        return albedo(D);
    if (VIEW == VIEW_COSINE)
        return signed_grey(c);
    if (VIEW == VIEW_CLAMP)
        return signed_grey(clamp_cosine(c));
    if (VIEW == VIEW_BANDS)
        return band(c);
    if (VIEW == VIEW_LIGHT_COLOR)
        return light_color(directional_L(0));  // the only one, of whatever kind
    if (VIEW == VIEW_NORMALS)
        return 0.5 * n + vec3(0.5);
    if (VIEW == VIEW_W)
        return 0.5 * (d2 > 0.0 ? l / sqrt(d2) : vec3(0.0)) + vec3(0.5);
    float k = point_decay(0);
    float f = d2 > 0.0 ? attenuation_window(d2, e, point_per_distance(0)) / max(attenuation_divisor(d2, k), 1e-30) : 0.0;
    f = times_power_of_two(vec3(f), attenuation_exponent(d2, e, k, point_exponent(0))).x;
    return heat(from_point ? f : 1.0);
}

void main()
{
    if (!is_surface(worldPosition))
        discard;
    watch(worldPosition);
    watch(worldNormal);
    float length2 = dot(worldNormal, worldNormal);
    vec3 n = length2 > 0.0 ? worldNormal * (facing() / sqrt(length2)) : vec3(0.0);
    write_pixel(factor(n, worldPosition, baseColor));
}
