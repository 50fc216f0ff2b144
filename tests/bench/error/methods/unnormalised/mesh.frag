// METHOD unnormalised normal | the interpolated normal as it comes: one square root and one division a fragment less
// SPDX-License-Identifier: MIT
//
// Known to be wrong with it: between the vertices the normal is shorter than 1, cos(A/2) where those of the vertices are A apart, so
// everything is too dark in the middle of triangles (19 codes at 45 degrees).
#include "variant.glsl"
#include "lighting.glsl"

in vec3 worldPosition;
in vec3 worldNormal;

uniform vec3 baseColor;
uniform vec3 emissive;

void main()
{
    if (!is_surface(worldPosition))
        discard;
    write_pixel(add(lighting(facing() * worldNormal, worldPosition, baseColor), emissive));
}
