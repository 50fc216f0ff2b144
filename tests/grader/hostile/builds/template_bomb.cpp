// Templates that need twice as many, and those again.
// SPDX-License-Identifier: MIT
template <int N, int M>
struct Twice {
    static constexpr int value = Twice<N - 1, 2 * M>::value + Twice<N - 1, 2 * M + 1>::value;
};
template <int M>
struct Twice<0, M> {
    static constexpr int value = 1;
};

int main() { return Twice<24, 0>::value; }
