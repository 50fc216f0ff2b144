// Numbers that no other grader of this machine uses at the same time.
// SPDX-License-Identifier: MIT
#pragma once

#include "grader/confine/descriptor.hpp"

#include <vector>

namespace grader {

/// As many numbers as processes that grade at a time; Confinement::run makes users of them, and two jobs of one user could count as
/// one. Held until the process ends, however it ends. Where all are taken, some are used twice, which is no more than untidy.
class Slots {
  public:
    explicit Slots(int count);
    /// The slot of process number `i`.
    int operator[](int i) const { return numbers_[static_cast<std::size_t>(i)]; }

  private:
    std::vector<int> numbers_;
    std::vector<Descriptor> held_;
};

}  // namespace grader
