// TERM clamp | slides 23-24 | max(0, .): light from behind gives 0, "certainly not a negative number" | off: identity
// SPDX-License-Identifier: MIT
float clamp_cosine(float cosine)
{
    watch(cosine);
#if TERM_CLAMP
    return max(0.0, cosine);
#else
    return cosine;
#endif
}
