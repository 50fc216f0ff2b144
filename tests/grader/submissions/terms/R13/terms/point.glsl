// The point lights as slides 30-31 write them.
// SPDX-License-Identifier: MIT
vec3 add_point_lights(vec3 P, vec3 n, vec3 Q, vec3 v, vec3 D)
{
    for (int i = 0; i < NUM_POINT_LIGHTS; ++i) {
        vec3 to_light = point_position(i) - Q;
        float d = length(to_light);
        vec3 w = to_light / d;
        float c = clamp_cosine(dot(n, w));
        float f = 1.0 / pow(d, point_decay(i));
        vec3 L = light_color(point_L(i));
        vec3 reflected = add_highlight(c * D, n, w, v, 1.0);
        P += f * reflected * L;
    }
    return P;
}
