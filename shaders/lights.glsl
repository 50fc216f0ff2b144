// Where the lights' numbers come from: uniforms, or a texture where there are too many for them.
// SPDX-License-Identifier: MIT

// A light is three vec4: (w or P_L, -), (L, intensity alone), (1 / distance, k, exponent, -).
#if LIGHTS_IN_TEXTURE

uniform highp sampler2D lightData;  // three texels a light, 512 lights a row
vec4 light_texel(int light, int part) { return texelFetch(lightData, ivec2(light % 512 * 3 + part, light / 512), 0); }
vec4 light_geometry(int light) { return light_texel(light, 0); }
vec4 light_radiance(int light) { return light_texel(light, 1); }
vec4 light_falloff(int light) { return light_texel(light, 2); }

#else

const int NUM_LIGHTS = max(NUM_DIRECTIONAL_LIGHTS + NUM_POINT_LIGHTS, 1);
uniform vec4 lightGeometry[NUM_LIGHTS];
uniform vec4 lightRadiance[NUM_LIGHTS];
uniform vec4 lightFalloff[NUM_LIGHTS];
vec4 light_geometry(int light) { return lightGeometry[light]; }
vec4 light_radiance(int light) { return lightRadiance[light]; }
vec4 light_falloff(int light) { return lightFalloff[light]; }

#endif

// w: unit vector towards a directional light; L and, in a, its intensity alone
vec3 directional_w(int i) { return light_geometry(i).xyz; }
vec4 directional_L(int i) { return light_radiance(i); }

// P_L: where a point light stands, world space about the anchor; L; what its falloff needs (terms/attenuation.glsl)
vec3 point_position(int i) { return light_geometry(NUM_DIRECTIONAL_LIGHTS + i).xyz; }
vec4 point_L(int i) { return light_radiance(NUM_DIRECTIONAL_LIGHTS + i); }
float point_per_distance(int i) { return light_falloff(NUM_DIRECTIONAL_LIGHTS + i).x; }
float point_decay(int i) { return light_falloff(NUM_DIRECTIONAL_LIGHTS + i).y; }
float point_exponent(int i) { return light_falloff(NUM_DIRECTIONAL_LIGHTS + i).z; }  // L is point_L 2^this
