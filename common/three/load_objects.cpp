// The objects of a scene file one by one: meshes, lights, cameras, and the ones that are not supported.
// SPDX-License-Identifier: MIT
#include "three/scene_file.hpp"
#include "three/tree_loader.hpp"

#include <algorithm>

namespace THREE {

void TreeLoader::fillScene(const Node& node, Scene& scene) {
    if (const std::optional<Node> background = node.findSet("background")) {
        if (!background->value().is_number())
            background->unsupported("expected a colour, found " + shortly(background->value()) +
                                    "; textures are not supported");
        scene.background = node.color("background", "lambertBackground", Color());
    }
    if (const std::optional<Node> fog = node.findSet("fog"))
        fog->unsupported("fog is not supported; remove it from the scene");
    if (node.findSet("environment"))
        note(node, "environment left out: it lights only MeshStandardMaterial");
}

template <class T>
const Entry<T>& TreeLoader::refer(const Node& node, const Library<T>& library, const char* what) const {
    const auto found = library.find(node.text());
    if (found == library.end())
        node.fail("the uuid of one of the file's " + std::string(what),
                  std::to_string(library.size()) + " " + what + " are there, none has it");
    if (found->second.resource == nullptr)
        throw Unsupported(found->second.refusal + " (used by " + node.path() + ")");
    return found->second;
}

std::unique_ptr<Object3D> TreeLoader::makeMesh(const Node& node) {
    const Node uuid = node.at("geometry", "the uuid of a geometry");
    const Entry<BufferGeometry>& geometry = refer(uuid, geometries_, "geometries");
    Node material = node.at("material", "the uuid of a material");
    if (material.value().is_array()) {
        if (material.size() != 1 || !geometry.groupsCoverAll)
            material.unsupported("several materials on a mesh are not supported, found an array of " +
                                 std::to_string(material.size()) + "; make one mesh per material");
        material = material.at(std::size_t{0});
    }
    const Entry<Material>& surface = refer(material, materials_, "materials");
    if (const std::optional<Node> morph = node.findSet("morphTargetInfluences"))
        for (std::size_t i = 0; i < morph->array().size(); ++i)
            if (morph->at(i).number() != 0)
                morph->at(i).unsupported("morph targets are not supported; set the influence to 0");
    if (!geometry.note.empty() && std::find(notes_.begin(), notes_.end(), geometry.note) == notes_.end())
        notes_.push_back(geometry.note);
    return std::make_unique<Mesh>(Handle<BufferGeometry>(geometry.resource),
                                  Handle<Material>(surface.resource));
}

std::unique_ptr<Object3D> TreeLoader::makeLight(const Node& node, const std::string& type) {
    std::unique_ptr<Light> light;
    if (type == "AmbientLight") {
        light = std::make_unique<AmbientLight>();
    } else if (type == "DirectionalLight") {
        const auto ready = waiting_.find(&node.value());
        if (ready != waiting_.end())
            light = std::move(ready->second);
        else
            light = std::make_unique<DirectionalLight>();
    } else {
        auto point = std::make_unique<PointLight>();
        point->distance = node.number("distance", 0);
        // three.js always writes it; a file by hand means slide 37's light, which does not fall off.
        point->decay = node.number("decay", 0);
        light = std::move(point);
    }
    light->color = node.color("color", "lambertColor", light->color);
    light->intensity = node.number("intensity", 1);
    return light;
}

namespace {

// Not Unsupported: a camera shows its picture whether it is visible itself or not.
void refuseShiftedView(const Node& node) {
    const std::optional<Node> view = node.findSet("view");
    if (view && view->boolean("enabled", true))
        view->refuse("a camera's view of a part of the picture is not supported; remove the field");
    if (node.number("filmOffset", 0) != 0)
        node.find("filmOffset")->fail("0", "a shifted film is not supported");
    if ((node.whole("layers", 1, -2147483648LL, 4294967295LL) & 0xFFFFFFFFLL) == 0)
        node.find("layers")->fail("a mask with some layer in it", "1 is three.js's default");
}

}  // namespace

std::unique_ptr<Object3D> TreeLoader::makeCamera(const Node& node) {
    auto camera = std::make_unique<PerspectiveCamera>();
    camera->fov = node.number("fov", camera->fov);
    camera->aspect = node.number("aspect", camera->aspect);
    camera->near = node.number("near", camera->near);
    camera->far = node.number("far", camera->far);
    camera->zoom = node.number("zoom", camera->zoom);
    const bool isFirst = camera_ == nullptr;
    if (!isFirst)
        note(node, "this PerspectiveCamera is not used: the first one of the file is");
    if (isFirst)
        refuseShiftedView(node);
    if (isFirst)
        camera_ = camera.get();
    return camera;
}

namespace {

bool isBlack(const Node& node, const char* key) {
    const std::optional<Node> color = node.find(key);
    return color && color->value() == 0;
}

bool givesNoLight(const Node& node, const std::string& type) {
    return node.number("intensity", 1) == 0 ||
           (isBlack(node, "color") && (type != "HemisphereLight" || isBlack(node, "groundColor")));
}

}  // namespace

// A geometry that draws nothing, whatever draws it.
bool TreeLoader::isEmptyGeometry(const Node& node) const {
    const std::optional<Node> uuid = node.findSet("geometry");
    if (!uuid)
        return false;
    const auto found = geometries_.find(uuid->text());
    return found != geometries_.end() && found->second.resource != nullptr &&
           found->second.resource->vertexCount() == 0;
}

std::unique_ptr<Object3D> TreeLoader::makeOther(const Node& node, const std::string& type) {
    const auto isOneOf = [&type](std::initializer_list<const char*> names) {
        return std::find(names.begin(), names.end(), type) != names.end();
    };
    const auto leaveOut = [&](const char* why) {
        note(node, printable(type) + " left out: " + why);
        return std::make_unique<Object3D>();
    };
    if (isOneOf({"OrthographicCamera", "ArrayCamera", "StereoCamera", "CubeCamera", "Camera"})) {
        if (orthographic_.empty())
            orthographic_ = node.path();
        return std::make_unique<Object3D>();
    }
    if (isOneOf({"Audio", "PositionalAudio", "AudioListener"}))
        return leaveOut("it is heard, not seen");
    if (type == "RectAreaLight")
        return leaveOut("it lights only MeshStandardMaterial");
    if (isOneOf({"SpotLight", "HemisphereLight", "LightProbe"})) {
        if (givesNoLight(node, type))
            return leaveOut("it gives no light");
        node.unsupported(type + " is not supported; use AmbientLight, DirectionalLight or PointLight");
    }
    if (isOneOf(
            {"Line", "LineLoop", "LineSegments", "Points", "PointCloud", "SkinnedMesh", "InstancedMesh"})) {
        if (isEmptyGeometry(node))
            return leaveOut("its geometry is empty");
        if (type == "InstancedMesh" && node.number("count", 1) == 0)
            return leaveOut("it has no instances");
    }
    node.unsupported(printable(type) + " is not supported; use Mesh, Group, AmbientLight, DirectionalLight, "
                                       "PointLight or PerspectiveCamera");
}

}  // namespace THREE
