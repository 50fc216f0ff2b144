// A line that becomes ten thousand million. In the place of terms/clamp.glsl.
// SPDX-License-Identifier: MIT
#define A(x) x x x x x x x x x x
#define B(x) A(A(x))
#define C(x) B(B(x))
float clamp_cosine(float cosine)
{
    watch(cosine);
    return 0.0 C(C(B(+ cosine)));
}
