// Geometries, materials and colours as three.js's JSON.
// SPDX-License-Identifier: MIT
#pragma once

#include "three/buffer_geometry.hpp"
#include "three/json_writer.hpp"
#include "three/materials.hpp"

#include <string>

namespace THREE {

/// What a uuid is of: its first digits.
enum class Kind { object = 1, geometry = 2, material = 3 };

/// A uuid that depends only on the order in the file, so that the same scene is written byte for byte the same.
std::string uuid(Kind kind, std::uint64_t number);

/// three.js's 0xRRGGBB under `key` and, where that is not exact, the three doubles under `exactKey`, which three.js ignores.
void writeColor(JsonWriter& json, const char* key, const char* exactKey, const Color& color);
/// Whether a parametric geometry is what its parameters say: nobody has changed its arrays since, in whatever way.
bool isAsConstructed(const BufferGeometry& geometry);
/// With its constructor's parameters if it is a parametric geometry that nobody has changed, else with its arrays.
void writeGeometry(JsonWriter& json, const BufferGeometry& geometry, const std::string& id);
void writeMaterial(JsonWriter& json, const Material& material, const std::string& id);

}  // namespace THREE
