// A thousand errors, each with a terminal's commands in it.
// SPDX-License-Identifier: MIT
#define E(n) int n##[2J = "]0;graded";
#define T(n) E(n##0) E(n##1) E(n##2) E(n##3) E(n##4) E(n##5) E(n##6) E(n##7) E(n##8) E(n##9)
T(a)
T(b) T(c) T(d) T(e) T(f) T(g) T(h) T(i) T(j) T(k)

    int main() {}
