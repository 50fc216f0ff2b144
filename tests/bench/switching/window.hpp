// What a change costs in a window: the time of the thread that draws, and how long until the change is seen.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace bench {

/// Toggles terms, chooses views, adds and drags lights in scenes like the lessons', as a window does with Compile::aside; or, where
/// `prepared`, toggles terms after prepare() of all neighbours. Prints lines `group<TAB>name<TAB>milliseconds`. Groups that end in ", CPU" are of the drawing thread alone. `amount`: "", "--quick", "--smoke".
void changes(const std::string& amount, bool prepared);

}  // namespace bench
