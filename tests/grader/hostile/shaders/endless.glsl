// A loop that never ends: llvmpipe ends it after 65,535 rounds, so each of them takes long. In the place of terms/clamp.glsl.
// SPDX-License-Identifier: MIT
#define A(x) x x x x x x x x
float clamp_cosine(float cosine)
{
    watch(cosine);
    float sum = cosine;
    for (int i = 0; i >= 0; i = (i + 1) % 1000) {
        A(A(A(sum = sin(sum + float(i));)))
    }
    return sum;
}
