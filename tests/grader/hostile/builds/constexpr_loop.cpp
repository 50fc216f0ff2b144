// A loop that the compiler runs.
// SPDX-License-Identifier: MIT
constexpr unsigned count() {
    unsigned n = 0;
    while (n < 4'000'000'000U) {
        ++n;
    }
    return n;
}
static_assert(count() > 0);

int main() {}
