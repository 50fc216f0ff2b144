// METHOD half accumulation | the ambient light's part of it: see half.glsl
// SPDX-License-Identifier: MIT
#include "terms/half.glsl"
uniform vec3 ambientLight;  // L_A, the sum of all ambient lights

vec3 add_ambient_light(vec3 P, vec3 D)
{
#if TERM_AMBIENT
    P = add_in_half(P, D * ambientLight);
#endif
    return P;
}
