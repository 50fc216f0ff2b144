// Scenes in and out: three.js's JSON Object/Scene format 4, and Wavefront .obj.
// SPDX-License-Identifier: MIT
#pragma once

#include "three/scene.hpp"

#include <memory>
#include <string>
#include <vector>

namespace THREE {

/// A scene that came from a file, with what its reader should know.
struct LoadedScene {
    std::unique_ptr<Scene> scene;  ///< owns everything in it; an Object that is no Scene is wrapped in one
    PerspectiveCamera* camera = nullptr;  ///< the first camera of the file (inside `scene`), or null
    std::vector<std::string> notes;  ///< what was left out because it cannot change the picture, a line each
};

/// Reads three.js's JSON format 4 (`scene.toJSON()`, the three.js editor's export).
/// https://github.com/mrdoob/three.js/wiki/JSON-Object-Scene-format-4
/// What is not supported is refused by name where it would change the picture, noted where it cannot.
/// Throws SceneError: file, path inside it ("object.children[2].geometry"), expected and found.
class ObjectLoader {
  public:
    /// `file` is only named in messages.
    LoadedScene parse(const std::string& json, const std::string& file) const;
    /// Reads a file, by its name: .obj through tinyobjloader, anything else as JSON.
    LoadedScene load(const std::string& file) const;
};

/// A Wavefront .obj as one mesh per shape: its normals or, where it has none, computed ones; Kd as a Lambert
/// colour, Ks and Ns as three.js's highlight (MeshPhongMaterial, blinn) unless illum is 1.
LoadedScene loadObj(const std::string& file);
/// The same from text. `file` is named in messages, and its .mtl files are looked for beside it.
LoadedScene parseObj(const std::string& text, const std::string& file);

/// three.js's JSON of `object` and everything below it; `camera`, if given and not inside, is written as its first child,
/// so that it is the one that a reader finds. Numbers are written so that reading them gives the same doubles.
std::string toJSON(const Object3D& object, const PerspectiveCamera* camera = nullptr);

}  // namespace THREE
