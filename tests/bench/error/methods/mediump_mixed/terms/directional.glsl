// METHOD mixed mediump | the directional lights' part of it: see point.glsl
// SPDX-License-Identifier: MIT
vec3 add_directional_lights(mediump vec3 P, highp vec3 n, vec3 v, mediump vec3 D)
{
#if TERM_DIRECTIONAL
#pragma unroll
    for (int i = 0; i < NUM_DIRECTIONAL_LIGHTS; ++i) {
        highp vec3 w = directional_w(i);
        mediump float share = max(0.0, dot(n, w));
        mediump vec3 L = light_color(directional_L(i));
        P += share * D * L;
    }
#endif
    return P;
}
