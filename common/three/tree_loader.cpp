// The object tree of a scene file: order, children, targets and what stands for what is left out.
// SPDX-License-Identifier: MIT
#include "three/tree_loader.hpp"

#include "three/scene_file.hpp"

namespace THREE {

namespace {

const char* const someType = "the name of an object's class such as \"Mesh\"";

// Three.js writes the mask as a signed or an unsigned number of 32 bits.
std::int64_t layersOf(const Node& node) {
    return node.whole("layers", 1, -2147483648LL, 4294967295LL) & 0xFFFFFFFFLL;
}

// 0 for the Scene itself.
int levelOf(const Object3D& object) {
    int level = 0;
    for (const Object3D* above = object.parent(); above != nullptr; above = above->parent())
        ++level;
    return level;
}

std::size_t childCount(const Node& node) {
    const std::optional<Node> children = node.findSet("children");
    return children ? children->array().size() : 0;
}

}  // namespace

LoadedScene TreeLoader::load(const Node& object) {
    const bool isScene = object.at("type", someType).text() == "Scene";
    lookAhead(object, isScene ? 0 : 1);  // what is no Scene hangs below one, and is written so
    LoadedScene loaded;
    loaded.scene = std::make_unique<Scene>();
    if (isScene) {
        fillScene(object, *loaded.scene);
        if (const std::string lost = loadPlace(object, *loaded.scene); !lost.empty())
            notes_.push_back(lost);
        if (const auto uuid = object.findSet("uuid"))
            placed_[uuid->text()] = {loaded.scene.get(), placed_[uuid->text()].count + 1};
        buildChildren(object, *loaded.scene, !loaded.scene->visible);
    } else {
        build(object, *loaded.scene, false);
    }
    resolveTargets();
    if (!orthographic_.empty() && camera_ == nullptr)
        object.refuse("the only camera, " + orthographic_ +
                      ", is no PerspectiveCamera and is not supported; use a PerspectiveCamera or none");
    if (!orthographic_.empty())
        notes_.push_back(orthographic_ + ": camera left out: the PerspectiveCamera is used");
    loaded.scene->updateMatrixWorld();
    loaded.camera = camera_;
    loaded.notes = std::move(notes_);
    return loaded;
}

// What has to be known before objects are made, in file order: the camera's layers, and which plain objects are the
// targets of directional lights, because such an object is the light's own `target`.
void TreeLoader::lookAhead(const Node& node, int level) {
    if (level > deepestTree)
        node.refuse("expected at most " + std::to_string(deepestTree) +
                    " levels of objects, found one more; flatten the scene");
    const std::string type = node.at("type", someType).text();
    if (type == "PerspectiveCamera" && !cameraLayersKnown_) {
        cameraLayers_ = layersOf(node);
        cameraLayersKnown_ = true;
    }
    if (type == "DirectionalLight") {
        if (const std::optional<Node> target = node.findSet("target")) {
            auto light = std::make_unique<DirectionalLight>();
            // An object that several lights aim at is the `target` of none: each one's hangs below it.
            if (const auto [place, isNew] = wanted_.emplace(target->text(), light.get()); !isNew)
                place->second = nullptr;
            aims_.push_back({light.get(), *target});
            waiting_.emplace(&node.value(), std::move(light));
        }
    }
    for (std::size_t i = 0; i < childCount(node); ++i)
        lookAhead(node.find("children")->at(i), level + 1);
}

void TreeLoader::build(const Node& node, Object3D& parent, bool hidden) {
    hidden = hidden || !node.boolean("visible", true);
    const std::string type = node.at("type", someType).text();
    const std::optional<Node> uuid = node.findSet("uuid");
    Object3D* object = nullptr;
    if (uuid && type == "Object3D" && childCount(node) == 0) {
        // Only without children: a target that owned its own light would never be freed.
        if (const auto light = wanted_.find(uuid->text());
            light != wanted_.end() && light->second != nullptr) {
            object = &light->second->target;
            wanted_.erase(light);
            parent.add(*object);
        }
    }
    if (object == nullptr)
        object = &parent.add(make(node, hidden));
    if (const std::string lost = loadPlace(node, *object); !lost.empty())
        notes_.push_back(lost);
    if (uuid) {
        Placed& placed = placed_[uuid->text()];
        ++placed.count;
        if (placed.object == nullptr)
            placed.object = object;
    }
    buildChildren(node, *object, hidden);
}

void TreeLoader::buildChildren(const Node& node, Object3D& object, bool hidden) {
    for (std::size_t i = 0; i < childCount(node); ++i)
        build(node.find("children")->at(i), object, hidden);
}

// What is not supported but cannot be seen leaves a plain object behind, for its children to stand on.
std::unique_ptr<Object3D> TreeLoader::make(const Node& node, bool hidden) {
    const std::string type = node.at("type", someType).text();
    try {
        return makeType(node, type);
    } catch (const Unsupported& e) {
        if (!hidden)
            throw;
        note(node, printable(type) + " left out: it is invisible (" + e.what() + ")");
        return std::make_unique<Object3D>();
    }
}

std::unique_ptr<Object3D> TreeLoader::makeType(const Node& node, const std::string& type) {
    if (type == "Object3D" || type == "Bone")
        return std::make_unique<Object3D>();
    if (type == "Group")
        return std::make_unique<Group>();
    if (type == "Scene") {
        auto scene = std::make_unique<Scene>();
        fillScene(node, *scene);
        return scene;
    }
    if (type == "PerspectiveCamera")
        return makeCamera(node);
    if (!seen(node)) {
        note(node, printable(type) + " left out: the camera does not see its layers");
        return std::make_unique<Object3D>();
    }
    if (type == "Mesh")
        return makeMesh(node);
    if (type == "AmbientLight" || type == "DirectionalLight" || type == "PointLight")
        return makeLight(node, type);
    return makeOther(node, type);
}

bool TreeLoader::seen(const Node& node) const { return (layersOf(node) & cameraLayers_) != 0; }

// A target that is not in the file is the origin, as three.js has it.
void TreeLoader::resolveTargets() {
    for (const Aim& aim : aims_) {
        const auto found = placed_.find(aim.target.text());
        if (found == placed_.end())
            continue;
        if (found->second.count > 1)
            aim.target.fail("the uuid of one object",
                            std::to_string(found->second.count) + " objects have it");
        if (found->second.object == &aim.light->target)
            continue;
        if (levelOf(*found->second.object) >= deepestTree)  // the light's own target hangs one level below it
            aim.target.fail("the uuid of an object at most " + std::to_string(deepestTree - 1) +
                            " levels deep");
        found->second.object->add(aim.light->target);
    }
}

void TreeLoader::note(const Node& node, const std::string& text) {
    notes_.push_back(node.path() + ": " + text);
}

}  // namespace THREE
