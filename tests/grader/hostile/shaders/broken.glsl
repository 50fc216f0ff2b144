// Does not compile, and its name for that would clear a terminal. In the place of terms/clamp.glsl.
// SPDX-License-Identifier: MIT
float clamp_cosine(float cosine)
{
    return [2J nothing;
}
