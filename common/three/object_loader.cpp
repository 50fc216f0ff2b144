// ObjectLoader: three.js's JSON format 4, from text or file to a Scene.
// SPDX-License-Identifier: MIT
#include "three/object_loader.hpp"

#include "three/json_node.hpp"
#include "three/json_text.hpp"
#include "three/scene_file.hpp"
#include "three/scene_library.hpp"
#include "three/tree_loader.hpp"

#include <algorithm>
#include <cctype>
#include <new>

namespace THREE {

namespace {

// Files that are JSON of another kind are told apart by name: that helps more than "object: found nothing".
void checkKind(const Node& root) {
    if (!root.value().is_object())
        root.fail("three.js's JSON, an object with \"metadata\" and \"object\"");
    if (root.find("asset"))
        root.refuse(
            "expected three.js's JSON, found glTF; open it in the three.js editor and export the scene");
    if (root.find("project") && root.find("scene"))
        root.refuse(
            "expected a scene, found a project of the three.js editor; use File / Export Scene there");
}

// What is worth a note about the version, or an empty text.
std::string checkMetadata(const Node& root) {
    const std::optional<Node> metadata = root.findSet("metadata");
    if (!metadata)
        return "";
    const std::string type = metadata->text("type", "Object");
    if (type != "Object")
        metadata->find("type")->fail("\"Object\"", "export the whole scene, not a part of it");
    const double version = metadata->number("version", 4.5);
    if (!(version >= 4 && version < 5))
        metadata->find("version")->fail("format 4", "export the scene with a current three.js");
    if (version < 4.6)
        return "";
    return "metadata.version: written by three.js r152 or later; this lab computes the slides' equation, so "
           "scenes "
           "made for r155's physical units look pi times brighter than there, and colours are not "
           "sRGB-decoded";
}

LoadedScene loadDocument(const nlohmann::json& document, const std::string& file) {
    const Node root(document, "", file);
    checkKind(root);
    const std::string aboutVersion = checkMetadata(root);
    const Node object = root.at("object", "the scene's objects");
    const Library<BufferGeometry> geometries = loadGeometries(root);
    const Library<Material> materials = loadMaterials(root);
    LoadedScene loaded = TreeLoader(geometries, materials).load(object.object());
    if (!aboutVersion.empty())
        loaded.notes.insert(loaded.notes.begin(), aboutVersion);
    if (const auto animations = root.findSet("animations"); animations && animations->array().size() > 0)
        loaded.notes.emplace_back(
            "animations: left out: they move nothing until an AnimationMixer plays them");
    return loaded;
}

}  // namespace

LoadedScene ObjectLoader::parse(const std::string& json, const std::string& file) const {
    try {
        return loadDocument(parseJsonText(json, file), file);
    } catch (const std::bad_alloc&) {
        throw SceneError(file + ": expected a scene that fits memory, found none left; simplify the scene");
    }
}

LoadedScene ObjectLoader::load(const std::string& file) const {
    std::string ending = file.size() < 4 ? "" : file.substr(file.size() - 4);
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending == ".obj" ? loadObj(file) : parse(readSceneFile(file), file);
}

}  // namespace THREE
