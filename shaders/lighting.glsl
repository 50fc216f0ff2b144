// The lighting equation of slide 42, one line per symbol. Each symbol is a file in terms/: switched off, it is the neutral
// element of its operation (1 in a product, 0 in a sum), so what is left is still an equation.
//
//     P  =  ( sum_i  max(0, n . w_i)  f(d_i)  D (x) L_i )  +  D (x) L_A
//
// Shiny materials (slides 44-45) add a highlight K_S max(0, R . v)^s f(d_i) to each light's share: terms/specular.glsl.
//
// SPDX-License-Identifier: MIT
#include "lights.glsl"
#include "clusters.glsl"
#include "range.glsl"
// the factors
#include "terms/albedo.glsl"
#include "terms/cosine.glsl"
#include "terms/clamp.glsl"
#include "terms/attenuation.glsl"
#include "terms/light_color.glsl"
#include "terms/specular.glsl"
// the addends, made of factors
#include "terms/directional.glsl"
#include "terms/point.glsl"
#include "terms/ambient.glsl"

// n: unit normal, Q: the point, both in lighting space (vertex.glsl); D: base colour
vec3 lighting(vec3 n, vec3 Q, vec3 D)
{
    D = albedo(D);
    vec3 v = view_direction(Q);
    vec3 P = vec3(0.0);
    P = add_directional_lights(P, n, v, D);
    P = add_point_lights(P, n, Q, v, D);
    P = add_ambient_light(P, D);
    return P;
}
