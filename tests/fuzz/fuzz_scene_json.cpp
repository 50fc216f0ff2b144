// Fuzz target: any bytes as a scene in three.js's JSON.
// SPDX-License-Identifier: MIT
#include "fuzz/property.hpp"
#include "fuzz/scene_property.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    fuzz::checkScene([&text] { return THREE::ObjectLoader().parse(text, "scene.json"); }, "scene.json: ");
    return 0;
}
