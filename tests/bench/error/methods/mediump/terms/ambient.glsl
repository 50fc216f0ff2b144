// METHOD mediump | the ambient light's part of it: see point.glsl
// SPDX-License-Identifier: MIT
uniform vec3 ambientLight;  // L_A, the sum of all ambient lights

vec3 add_ambient_light(mediump vec3 P, mediump vec3 D)
{
#if TERM_AMBIENT
    mediump vec3 L = ambientLight;
    P += D * L;
#endif
    return P;
}
