// Every vertex of a mesh: into clip space for the rasteriser, into world space for the lighting (slides 32-33).
// SPDX-License-Identifier: MIT
#include "variant.glsl"

layout(location = 0) in vec3 position;  // object space
layout(location = 1) in vec3 normal;    // object space, unit length

uniform mat4 modelViewProjectionMatrix;  // object to clip space, formed in double on the CPU
uniform mat4x3 modelMatrix;              // object to world space about an anchor: see lighting/frame_plan.hpp
uniform mat3 normalMatrix;               // the inverse transpose of the model matrix, up to a positive factor

out vec3 worldPosition;
out vec3 worldNormal;

// To length 1 whatever the length was; the zero vector stays zero.
vec3 safeNormalize(vec3 v)
{
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (!(largest > 0.0))
        return vec3(0.0);
    v /= largest;
    return v / sqrt(dot(v, v));
}

void main()
{
    gl_Position = modelViewProjectionMatrix * vec4(position, 1.0);
    worldPosition = modelMatrix * vec4(position, 1.0);
    worldNormal = safeNormalize(normalMatrix * normal);
}
