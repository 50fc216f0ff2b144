// TERM ambient | slides 40-42 | D (x) L_A: the light that comes from everywhere | off: 0
// SPDX-License-Identifier: MIT
#if AMBIENT_IS_CONSTANT
const vec3 ambientLight = AMBIENT_LIGHT;  // L_A, the sum of all ambient lights: they stand still
#else
uniform vec3 ambientLight;  // L_A
#endif

vec3 add_ambient_light(vec3 P, vec3 D)
{
#if TERM_AMBIENT
    P = add(P, D * ambientLight);
#endif
    return P;
}
