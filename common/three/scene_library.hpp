// The geometries and materials of a scene file, by uuid.
// SPDX-License-Identifier: MIT
#pragma once

#include "three/buffer_geometry.hpp"
#include "three/json_node.hpp"
#include "three/materials.hpp"

#include <map>
#include <memory>
#include <string>

namespace THREE {

/// One geometry or material of a file. One that is not supported matters only once a visible mesh uses it.
template <class T>
struct Entry {
    std::shared_ptr<T> resource;  ///< null if it is not supported
    std::string refusal;  ///< why it is not, with file and path
    std::string path;  ///< where it stands: "materials[2]"
    std::string note;  ///< what was left out of it because it cannot change the picture, or empty
    bool groupsCoverAll = false;  ///< geometries: an array of one material draws all of it
};

/// Entries by uuid.
template <class T>
using Library = std::map<std::string, Entry<T>>;

/// three.js's "geometries" or "materials"; absent means none. Throws SceneError for anything malformed.
Library<BufferGeometry> loadGeometries(const Node& root);
Library<Material> loadMaterials(const Node& root);

/// One BufferGeometry or parametric geometry. Throws Unsupported for a type or feature that is not supported.
/// `parametric` counts the vertices of the file's parametric geometries, those that are not supported included.
std::shared_ptr<BufferGeometry> loadGeometry(const Node& node, double& parametric);
/// What loadGeometry left out because it shows only in animations, or empty.
std::string geometryNote(const Node& node);
/// Whether the groups draw every triangle with the first material, which decides what [material] means.
bool groupsCoverAll(const Node& node, const BufferGeometry& geometry);
/// A parametric geometry, or null if `type` is none.
std::shared_ptr<BufferGeometry> loadParametric(const Node& node, const std::string& type);
/// One material. Throws Unsupported likewise.
std::shared_ptr<Material> loadMaterial(const Node& node);

}  // namespace THREE
