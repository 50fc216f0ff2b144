// Ten lines that become ten thousand million.
// SPDX-License-Identifier: MIT
#define A(x) x x x x x x x x x x
#define B(x) A(A(x))
#define C(x) B(B(x))
#define D(x) C(C(x))
int main() { return 0 D(C(+1)); }
