// Adds up stretches of time.
// SPDX-License-Identifier: MIT
#include "lab/phases.hpp"

#include <algorithm>
#include <string_view>

namespace lab {

double Phases::lap() {
    const Clock::time_point now = Clock::now();
    const double passed = std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
    return passed;
}

void Phases::add(const char* name, double milliseconds) {
    const auto known = std::find_if(all_.begin(), all_.end(), [name](const auto& phase) {
        return std::string_view(phase.first) == name;
    });
    if (known != all_.end())
        known->second += milliseconds;
    else
        all_.emplace_back(name, milliseconds);
}

void Phases::restart() {
    all_.clear();
    last_ = Clock::now();
}

}  // namespace lab
