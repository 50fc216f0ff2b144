// A thousand errors, each with a terminal's commands in it.
// SPDX-License-Identifier: MIT
#define E(n) int n##[2J = "]0;graded";
#define T(n) E(n##0) E(n##1) E(n##2) E(n##3) E(n##4) E(n##5) E(n##6) E(n##7) E(n##8) E(n##9)
#define H(n) T(n##0) T(n##1) T(n##2) T(n##3) T(n##4) T(n##5) T(n##6) T(n##7) T(n##8) T(n##9)
H(a)
H(b)

int main() {}
