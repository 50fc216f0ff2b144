// Every fragment of an unlit mesh: its colour, whatever the lights do (lesson 00).
// SPDX-License-Identifier: MIT
#include "variant.glsl"

uniform vec3 baseColor;

void main()
{
    write_pixel(baseColor);
}
