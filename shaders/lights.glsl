// Where the lights' numbers come from: constants of this shader for those that stand still, uniforms for those that move, or a
// texture where there are too many. The same numbers, and the same picture, from all of them.
// SPDX-License-Identifier: MIT

// A light is three vec4: (w or P_L, 1 / distance), (L, intensity alone), (k, exponent, -, -).
#if LIGHTS_IN_TEXTURE

uniform highp sampler2D lightData;  // three texels a light, 512 lights a row
vec4 light_texel(int light, int part) { return texelFetch(lightData, ivec2(light % 512 * 3 + part, light / 512), 0); }
vec4 light_geometry(int light) { return light_texel(light, 0); }
vec4 light_radiance(int light) { return light_texel(light, 1); }
vec4 light_falloff(int light) { return light_texel(light, 2); }

#else

uniform vec4 lightGeometry[NUM_UNIFORM_LIGHTS];
uniform vec4 lightRadiance[NUM_UNIFORM_LIGHTS];
uniform vec4 lightFalloff[NUM_UNIFORM_LIGHTS];
#if LIGHTS_ARE_CONSTANTS && SOME_LIGHTS_MOVE  // UNIFORM_LIGHT says where a light that moves is in the uniforms, or -1
vec4 light_geometry(int light) { int i = UNIFORM_LIGHT[light]; return i < 0 ? LIGHT_GEOMETRY[light] : lightGeometry[max(i, 0)]; }
vec4 light_radiance(int light) { int i = UNIFORM_LIGHT[light]; return i < 0 ? LIGHT_RADIANCE[light] : lightRadiance[max(i, 0)]; }
vec4 light_falloff(int light) { int i = UNIFORM_LIGHT[light]; return i < 0 ? LIGHT_FALLOFF[light] : lightFalloff[max(i, 0)]; }
#elif LIGHTS_ARE_CONSTANTS  // these arrays are written above
vec4 light_geometry(int light) { return LIGHT_GEOMETRY[light]; }
vec4 light_radiance(int light) { return LIGHT_RADIANCE[light]; }
vec4 light_falloff(int light) { return LIGHT_FALLOFF[light]; }
#else
vec4 light_geometry(int light) { return lightGeometry[light]; }
vec4 light_radiance(int light) { return lightRadiance[light]; }
vec4 light_falloff(int light) { return lightFalloff[light]; }
#endif

#endif

// w: unit vector towards a directional light; L and, in a, its intensity alone
vec3 directional_w(int i) { return light_geometry(i).xyz; }
vec4 directional_L(int i) { return light_radiance(i); }

// P_L: where a point light stands, world space about the anchor; L; what its falloff needs (terms/attenuation.glsl)
vec3 point_position(int i) { return light_geometry(NUM_DIRECTIONAL_LIGHTS + i).xyz; }
vec4 point_L(int i) { return light_radiance(NUM_DIRECTIONAL_LIGHTS + i); }
float point_per_distance(int i) { return light_geometry(NUM_DIRECTIONAL_LIGHTS + i).w; }
float point_decay(int i) { return light_falloff(NUM_DIRECTIONAL_LIGHTS + i).x; }
float point_exponent(int i) { return light_falloff(NUM_DIRECTIONAL_LIGHTS + i).y; }  // L is point_L 2^this
