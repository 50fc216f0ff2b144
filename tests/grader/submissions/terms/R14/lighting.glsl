// Slide 42 in one function, no term apart, nothing to switch.
// SPDX-License-Identifier: MIT
#include "lights.glsl"

uniform vec3 ambientLight, eyePosition, specularColor;
uniform float shininess;

vec3 add(vec3 a, vec3 b) { return a + b; }
bool is_surface(vec3 Q) { return true; }

vec3 lighting(vec3 n, vec3 Q, vec3 D)
{
    vec3 v = normalize(eyePosition - Q);
    vec3 color = D * ambientLight;
    for (int i = 0; i < NUM_DIRECTIONAL_LIGHTS + NUM_POINT_LIGHTS; ++i) {
        vec3 L = light_radiance(i).rgb;
        vec3 w = light_geometry(i).xyz;
        if (i >= NUM_DIRECTIONAL_LIGHTS) {
            w -= Q;
            L /= pow(dot(w, w), light_falloff(i).x / 2.0);
            w = normalize(w);
        }
        float c = dot(n, w);
        if (c > 0.0)
            color += L * (c * D + specularColor * pow(max(dot(reflect(-w, n), v), 0.0), shininess));
    }
    return color;
}
