// Resource: gives each geometry and material its number.
// SPDX-License-Identifier: MIT
#include "three/resource.hpp"

#include <atomic>
#include <cstdint>

namespace THREE {

namespace {

// Loaders may build resources in threads of their own.
std::atomic<std::uint64_t> lastId{0};

}  // namespace

// A window shows lessons of several modules with one renderer, and each module counts for itself: where its counter stands in memory
// tells it from the others, which are at least a page away: 2^28 numbers.
Resource::Resource() : id_((reinterpret_cast<std::uintptr_t>(&lastId) << 16) + ++lastId) {}

}  // namespace THREE
