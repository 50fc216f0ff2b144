// Materials of a scene file, and everything about them that would change the picture but is not drawn here.
// SPDX-License-Identifier: MIT
#include "three/scene_file.hpp"
#include "three/scene_library.hpp"

namespace THREE {

namespace {

void refuseTextures(const Node& node) {
    // specularMap scales the highlight; without one it only scales an environment map.
    for (const char* map : {"map", "alphaMap", "envMap", "lightMap", "aoMap", "emissiveMap", "bumpMap",
                            "normalMap", "displacementMap", "matcap", "gradientMap"})
        if (const std::optional<Node> texture = node.findSet(map))
            texture->unsupported("textures are not supported; remove the field, or use a plain color");
}

void loadLambert(const Node& node, MeshLambertMaterial& lambert) {
    lambert.emissive = node.color("emissive", "lambertEmissive", lambert.emissive);
    lambert.emissiveIntensity = node.number("emissiveIntensity", 1);
}

void loadPhong(const Node& node, MeshPhongMaterial& phong) {
    loadLambert(node, phong);
    phong.specular = node.color("specular", "lambertSpecular", phong.specular);
    phong.shininess = node.number("shininess", phong.shininess);
    phong.specularModel = SpecularModel::blinn;
    if (const std::optional<Node> texture = node.findSet("specularMap"))
        texture->unsupported("textures are not supported; remove the field, or use a plain specular");
    const std::optional<Node> userData = node.findSet("userData");
    if (userData && userData->value().is_object())
        if (const std::optional<Node> model = userData->find("specularModel"))
            phong.specularModel = model->value() == "phong" ? SpecularModel::phong : SpecularModel::blinn;
}

void refuseTransparency(const Node& node) {
    const double opacity = node.number("opacity", 1);
    const bool transparent = node.boolean("transparent", false);
    if (transparent && opacity < 1)
        node.find("opacity")->unsupported("transparent surfaces are not supported; set transparent to false");
    // 0 is no test, whatever the opacity.
    if (const double least = node.number("alphaTest", 0); least > 0 && least > opacity)
        node.find("alphaTest")->unsupported("alphaTest above the opacity hides the surface; set it to 0");
    // 0 is no blending, 1 normal blending: the same for an opaque surface.
    if (const std::optional<Node> blending = node.find("blending"); blending && blending->whole(0, 5) > 1)
        blending->unsupported("only normal blending (1) is supported, found " + shortly(blending->value()));
}

void refuseSwitches(const Node& node) {
    for (const char* flag : {"depthTest", "depthWrite", "colorWrite"})
        if (!node.boolean(flag, true))
            node.find(flag)->unsupported(
                "expected true, found false; surfaces always test and write depth and colour");
    if (node.boolean("wireframe", false))
        node.find("wireframe")->unsupported("wireframe is not supported; set it to false");
    // Until r100 three.js wrote 0, 1 or 2 here.
    if (const std::optional<Node> colors = node.find("vertexColors"))
        if (colors->value() != false && colors->value() != 0)
            colors->unsupported("colours per vertex are not supported, found " + shortly(colors->value()) +
                                "; set it to false");
    if (node.whole("depthFunc", 3, 0, 7) != 3)
        node.find("depthFunc")->unsupported("only three.js's LessEqualDepth (3) is supported");
    if (node.boolean("stencilWrite", false) && node.whole("stencilFunc", 519, 0, 1000) != 519)
        node.find("stencilFunc")->unsupported("the stencil test is not supported; set stencilWrite to false");
    if (node.boolean("polygonOffset", false) &&
        (node.number("polygonOffsetFactor", 0) != 0 || node.number("polygonOffsetUnits", 0) != 0))
        node.find("polygonOffset")->unsupported("depth offsets are not supported; set it to false");
}

std::shared_ptr<Material> make(const Node& node) {
    const Node type =
        node.at("type", "\"MeshLambertMaterial\", \"MeshPhongMaterial\" or \"MeshBasicMaterial\"");
    const std::string name = type.text();
    if (name == "MeshBasicMaterial")
        return std::make_shared<MeshBasicMaterial>();
    if (name == "MeshLambertMaterial") {
        auto lambert = std::make_shared<MeshLambertMaterial>();
        loadLambert(node, *lambert);
        return lambert;
    }
    if (name == "MeshPhongMaterial") {
        auto phong = std::make_shared<MeshPhongMaterial>();
        loadPhong(node, *phong);
        return phong;
    }
    type.unsupported(printable(name) +
                     " is not supported; use MeshLambertMaterial (lit), MeshPhongMaterial (lit and shiny) or "
                     "MeshBasicMaterial (unlit)");
}

}  // namespace

std::shared_ptr<Material> loadMaterial(const Node& node) {
    std::shared_ptr<Material> material = make(node);
    material->color = node.color("color", "lambertColor", material->color);
    material->name = node.text("name", "");
    material->side = static_cast<Side>(node.whole("side", FrontSide, FrontSide, DoubleSide));
    material->visible = node.boolean("visible", true);
    material->flatShading = node.boolean("flatShading", false);
    refuseTextures(node);
    refuseTransparency(node);
    refuseSwitches(node);
    return material;
}

}  // namespace THREE
