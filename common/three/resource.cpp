// Resource: gives each geometry and material its number.
// SPDX-License-Identifier: MIT
#include "three/resource.hpp"

#include <atomic>

namespace THREE {

namespace {

// Loaders may build resources in threads of their own.
std::atomic<std::uint64_t> lastId{0};

}  // namespace

Resource::Resource() : id_(++lastId) {}

}  // namespace THREE
