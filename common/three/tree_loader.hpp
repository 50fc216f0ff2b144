// The object tree of a scene file: from three.js's JSON to Scene, Mesh, lights and cameras.
// SPDX-License-Identifier: MIT
#pragma once

#include "three/json_node.hpp"
#include "three/lights.hpp"
#include "three/object_loader.hpp"
#include "three/scene_library.hpp"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace THREE {

/// Deeper trees are refused: everything that walks a tree takes stack for each level.
inline constexpr int deepestTree = 256;

/// Builds the tree below one "object" of a file. Used once.
class TreeLoader {
  public:
    TreeLoader(const Library<BufferGeometry>& geometries, const Library<Material>& materials)
        : geometries_(geometries), materials_(materials) {}

    /// Throws SceneError for what is malformed, or not supported and visible; what is not supported and cannot be seen
    /// becomes a plain Object3D at its place, and a note.
    LoadedScene load(const Node& object);

  private:
    struct Placed {
        Object3D* object = nullptr;
        int count = 0;  // objects of this uuid
    };
    struct Aim {
        DirectionalLight* light;
        Node target;  // the field that holds the uuid
    };

    void lookAhead(const Node& node, int level);
    void build(const Node& node, Object3D& parent, bool hidden);
    void buildChildren(const Node& node, Object3D& object, bool hidden);
    std::unique_ptr<Object3D> make(const Node& node, bool hidden);
    std::unique_ptr<Object3D> makeType(const Node& node, const std::string& type);
    std::unique_ptr<Object3D> makeMesh(const Node& node);
    std::unique_ptr<Object3D> makeLight(const Node& node, const std::string& type);
    std::unique_ptr<Object3D> makeCamera(const Node& node);
    std::unique_ptr<Object3D> makeOther(const Node& node, const std::string& type);
    void fillScene(const Node& node, Scene& scene);
    void resolveTargets();
    bool seen(const Node& node) const;
    bool isEmptyGeometry(const Node& node) const;
    template <class T>
    const Entry<T>& refer(const Node& node, const Library<T>& library, const char* what) const;
    void note(const Node& node, const std::string& text);

    const Library<BufferGeometry>& geometries_;
    const Library<Material>& materials_;
    std::vector<std::string> notes_;
    PerspectiveCamera* camera_ = nullptr;
    std::string orthographic_;  // path of the first one, or empty
    std::int64_t cameraLayers_ = 1;
    bool cameraLayersKnown_ = false;
    std::vector<Aim> aims_;  // directional lights with a target
    std::map<const nlohmann::json*, std::unique_ptr<DirectionalLight>> waiting_;  // made ahead of their place
    std::map<std::string, DirectionalLight*>
        wanted_;  // uuid of a target to the light that it becomes a part of, null if several want it
    std::map<std::string, Placed> placed_;  // objects by uuid
};

/// Fills in name, visible, up and the transform of an object.
/// Returns what of the matrix is lost as in three.js (a shear), or an empty text.
std::string loadPlace(const Node& node, Object3D& object);

}  // namespace THREE
