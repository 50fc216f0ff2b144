// TERM cosine | slides 16-20, 24 | n . w: how squarely the light falls on the surface | off: 1
// SPDX-License-Identifier: MIT
//
// For a point light w = v / d with v = P_L - Q, and the division waits: cosine() is n . v, cosine_divisor() is d.
// Dividing once by d and f(d)'s d^k together costs the fewest roundings, and w is never computed where d = 0.
#if TERM_COSINE
float cosine(vec3 n, vec3 v) { return dot(n, v); }
float cosine_divisor(float d2) { return sqrt(d2); }
#else
float cosine(vec3 n, vec3 v) { return 1.0; }
float cosine_divisor(float d2) { return 1.0; }
#endif
