// The root of what is negative. In the place of terms/clamp.glsl.
// SPDX-License-Identifier: MIT
float clamp_cosine(float cosine)
{
    watch(cosine);
    return sqrt(-1.0 - abs(cosine));
}
