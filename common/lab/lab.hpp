// The one include of a lesson: three.js's API, and the App that shows what it makes.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/app.hpp"
#include "three/three.hpp"

#include <deque>
