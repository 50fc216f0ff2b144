// What every vertex needs: into clip space for the rasteriser, into lighting space for the equation (slides 32-33).
// Lighting space is world space about an anchor near the camera, or view space (--space view): the equation cannot tell.
// SPDX-License-Identifier: MIT
layout(location = 0) in vec3 position;  // object space
layout(location = 1) in vec3 normal;    // object space, unit length

uniform mat4 modelViewProjectionMatrix;  // object to clip space, formed in double on the CPU
uniform mat4x3 modelMatrix;              // object to lighting space: see lighting/frame_plan.hpp
uniform mat3 normalMatrix;               // the inverse transpose of the model matrix, up to a positive factor

// To length 1 whatever the length was; the zero vector stays zero.
vec3 safeNormalize(vec3 v)
{
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (!(largest > 0.0))
        return vec3(0.0);
    v /= largest;
    return v / sqrt(dot(v, v));
}

vec4 clip_position() { return modelViewProjectionMatrix * vec4(position, 1.0); }
vec3 lit_position() { return modelMatrix * vec4(position, 1.0); }
vec3 lit_normal() { return safeNormalize(normalMatrix * normal); }
