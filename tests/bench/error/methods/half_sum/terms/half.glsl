// METHOD half accumulation | the sum of the lights kept in 16-bit floats, as a frame buffer of halves does between passes
// SPDX-License-Identifier: MIT
//
// Known to be wrong with it: once the sum is 2,048 times an addend, adding it changes nothing; 1,000 lights lose 4 codes.
vec3 add_in_half(vec3 P, vec3 x)
{
    vec3 sum = P + x;
    return vec3(unpackHalf2x16(packHalf2x16(sum.xy)), unpackHalf2x16(packHalf2x16(vec2(sum.z, 0.0))).x);
}
