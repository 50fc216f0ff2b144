// Every fragment of a mesh that is lit at its vertices: what is left is interpolation, which the rasteriser did.
// SPDX-License-Identifier: MIT
#include "variant.glsl"
#include "range.glsl"

in vec3 frontColor;
#if DOUBLE_SIDED
in vec3 backColor;
#endif
#if COUNT_NONFINITE
in float metNonfinite;
#endif

void main()
{
    vec3 P = frontColor;
#if DOUBLE_SIDED
    if (!gl_FrontFacing)
        P = backColor;
#endif
    if (!is_surface(P))
        discard;
#if COUNT_NONFINITE
    met_nonfinite = metNonfinite > 0.0;
#endif
    write_pixel(from_varying(P));
}
