// Draws the bar again whenever it grows.
// SPDX-License-Identifier: MIT
#include "lab/progress.hpp"

#include <algorithm>
#include <iostream>
#include <unistd.h>

namespace lab {

Progress::~Progress() {
    if (shown_)
        std::cerr << '\n';
}

void Progress::step(double share, const std::string& text) {
    if (std::chrono::steady_clock::now() - start_ < std::chrono::seconds(2) || isatty(STDERR_FILENO) == 0)
        return;
    constexpr int width = 40;
    const int filled = static_cast<int>(width * std::clamp(share, 0.0, 1.0));
    if (filled == filled_)
        return;
    filled_ = filled;
    shown_ = true;
    std::cerr << "\r[" << std::string(static_cast<std::size_t>(filled), '#')
              << std::string(static_cast<std::size_t>(width - filled), ' ') << "] " << text << std::flush;
}

void Progress::clear() {
    if (!shown_)
        return;
    std::cerr << "\r\033[K";
    shown_ = false;
    filled_ = -1;
}

}  // namespace lab
