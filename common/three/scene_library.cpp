// The geometries and materials of a scene file, by uuid.
// SPDX-License-Identifier: MIT
#include "three/scene_library.hpp"

#include "three/geometries.hpp"

namespace THREE {

namespace {

// Calls `load` for every element of root[key] and files what it gives under the element's uuid.
template <class T, class Load>
Library<T> loadLibrary(const Node& root, const char* key, Load load) {
    Library<T> library;
    const std::optional<Node> list = root.findSet(key);
    if (!list)
        return library;
    for (std::size_t i = 0; i < list->array().size(); ++i) {
        const Node node = list->at(i);
        const Node uuid = node.at("uuid", "a text that meshes refer to it by");
        Entry<T> entry;
        entry.path = node.path();
        try {
            load(node, entry);
        } catch (const Unsupported& e) {
            entry.resource = nullptr;
            entry.refusal = e.what();
        }
        const auto [place, isNew] = library.emplace(uuid.text(), std::move(entry));
        if (!isNew)
            uuid.fail("a uuid of its own", "it is that of " + place->second.path + " too");
    }
    return library;
}

}  // namespace

Library<BufferGeometry> loadGeometries(const Node& root) {
    double vertices = 0;
    double parametric = 0;
    return loadLibrary<BufferGeometry>(
        root, "geometries", [&](const Node& node, Entry<BufferGeometry>& entry) {
            entry.resource = loadGeometry(node, parametric);
            vertices += static_cast<double>(entry.resource->vertexCount());
            if (vertices > maxVertices)
                node.refuse("expected at most 50 million vertices in a file, found more; use fewer segments");
            entry.note = geometryNote(node);
            entry.groupsCoverAll = groupsCoverAll(node, *entry.resource);
        });
}

Library<Material> loadMaterials(const Node& root) {
    return loadLibrary<Material>(root, "materials", [](const Node& node, Entry<Material>& entry) {
        entry.resource = loadMaterial(node);
    });
}

}  // namespace THREE
