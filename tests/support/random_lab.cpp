// Random scenes with something to skip: lights that end, many meshes, closed and open, black and shiny.
// SPDX-License-Identifier: MIT
#include "support/random_lab.hpp"

#include "support/judge.hpp"
#include "three/object_loader.hpp"

namespace support {

namespace {

THREE::Vector3 anyVector(double low, double high) {
    const double x = between(low, high), y = between(low, high), z = between(low, high);
    return {x, y, z};
}

std::vector<std::unique_ptr<THREE::BufferGeometry>> shapes() {
    std::vector<std::unique_ptr<THREE::BufferGeometry>> out;
    out.push_back(std::make_unique<THREE::BoxGeometry>(1, 2, 0.5));
    out.push_back(std::make_unique<THREE::SphereGeometry>(1, 12, 7));
    out.push_back(std::make_unique<THREE::CylinderGeometry>(0.4, 1, 1.5, 9, 2));
    out.push_back(std::make_unique<THREE::PlaneGeometry>(3, 3, 2, 2));
    out.push_back(std::make_unique<THREE::TorusKnotGeometry>(1, 0.4, 24, 8));
    out.push_back(std::make_unique<THREE::CylinderGeometry>(1, 1, 1.5, 9, 1, true));
    return out;
}

}  // namespace

RandomLab::RandomLab(const Wishes& wishes) : geometries(shapes()) {
    scene.background = THREE::Color(0x203040);
    scene.add(all);
    for (int i = *rc::gen::inRange(1, wishes.meshes + 1); i > 0; --i)
        addMesh();
    for (int i = *rc::gen::inRange(1, wishes.lights + 1); i > 0; --i)
        addPoint(wishes);
    for (int i = *rc::gen::inRange(0, 3); i > 0; --i) {
        lights.push_back(std::make_unique<THREE::DirectionalLight>(anyColor(), between(0, 1)));
        lights.back()->position = anyVector(-1, 1).add({0, 1.5, 0});
        all.add(*lights.back());
    }
    if (chance(50)) {
        lights.push_back(std::make_unique<THREE::AmbientLight>(anyColor(), between(0, 0.3)));
        all.add(*lights.back());
    }
    if (wishes.anySize && chance(40)) {
        const double size = octaves(1e-6, 1e6);
        all.scale.setScalar(size);
        for (const auto& light : lights)
            if (auto* const point = dynamic_cast<THREE::PointLight*>(light.get()))
                point->distance *= size;  // three.js's `distance` knows no scale
    }
    placeCamera();
    chooseSettings();
}

THREE::Color RandomLab::anyColor() {
    if (chance(10))
        return {0, 0, 0};
    const double r = chance(15) ? 0 : between(0, 1), g = chance(15) ? 1 : between(0, 1), b = between(0, 1.2);
    return {r, g, b};
}

std::unique_ptr<THREE::Material> RandomLab::anyMaterial() {
    if (chance(10))
        return std::make_unique<THREE::MeshBasicMaterial>(anyColor());
    if (chance(50)) {
        auto lambert = std::make_unique<THREE::MeshLambertMaterial>(anyColor());
        lambert->emissive = chance(20) ? anyColor() : THREE::Color(0, 0, 0);
        return lambert;
    }
    auto phong = std::make_unique<THREE::MeshPhongMaterial>(anyColor());
    phong->specular = chance(30) ? THREE::Color(0, 0, 0) : anyColor();
    phong->shininess = octaves(0.1, 300);
    phong->specularModel = chance(50) ? THREE::SpecularModel::blinn : THREE::SpecularModel::phong;
    return phong;
}

void RandomLab::addMesh() {
    materials.push_back(anyMaterial());
    THREE::Material& material = *materials.back();
    material.side =
        *rc::gen::element(THREE::FrontSide, THREE::BackSide, THREE::DoubleSide, THREE::DoubleSide);
    material.flatShading = chance(15);
    meshes.push_back(std::make_unique<THREE::Mesh>(
        *geometries[*rc::gen::inRange<std::size_t>(0, geometries.size())], material));
    THREE::Mesh& mesh = *meshes.back();
    mesh.position = anyVector(-4, 4);
    mesh.rotation.set(between(-4, 4), between(-4, 4), between(-4, 4));
    if (chance(50))
        mesh.scale.set(octaves(0.2, 2) * (chance(30) ? -1 : 1), octaves(0.2, 2), octaves(0.2, 2));
    if (chance(10))
        mesh.scale.multiplyScalar(octaves(1, 1000));
    all.add(mesh);
}

void RandomLab::addPoint(const Wishes& wishes) {
    auto light = std::make_unique<THREE::PointLight>(anyColor(), chance(10) ? 0 : octaves(0.01, 10));
    light->position = anyVector(-6, 6);
    light->decay = *rc::gen::element(0.0, 1.0, 2.0, 0.0, 1.0, 2.0, 0.5, 1.5, 3.0, 4.0, 8.0);
    const bool ends = wishes.ending && (!wishes.endless || chance(60));
    light->distance = ends ? octaves(0.05, 30) : 0;
    lights.push_back(std::move(light));
    all.add(*lights.back());
}

void RandomLab::placeCamera() {
    const double size = all.scale.x;
    camera.fov = chance(70) ? between(20, 70) : octaves(0.5, 150);
    camera.near = octaves(1e-3, 1) * size;
    camera.far = camera.near * octaves(10, 1e5);
    camera.position = anyVector(-7, 7).multiplyScalar(size);
    options.width = *rc::gen::inRange(24, 70);
    options.height = *rc::gen::inRange(24, 60);
    lookAt(camera, anyVector(-2, 2).multiplyScalar(size), options);
}

void RandomLab::chooseSettings() {
    lighting::Settings& s = options.settings;
    s.constantLights = chance(20) ? 64 : 0;  // constants take longer to compile
    s.shading = *rc::gen::element(lighting::Shading::pixel, lighting::Shading::pixel,
                                  lighting::Shading::vertex, lighting::Shading::flat);
    s.space = chance(30) ? lighting::Space::view : lighting::Space::world;
    if (chance(40))
        s.terms = s.terms.without(static_cast<lighting::Term>(*rc::gen::inRange(0, lighting::termCount)));
    if (chance(10))
        s.terms = s.terms.without(static_cast<lighting::Term>(*rc::gen::inRange(0, lighting::termCount)));
}

std::string RandomLab::text() const {
    const lighting::Settings& s = options.settings;
    std::string out = THREE::toJSON(scene, &camera);
    out += "\nterms " + s.terms.text() + ", shading " + std::to_string(static_cast<int>(s.shading)) +
           ", space " + std::to_string(static_cast<int>(s.space)) + ", " + std::to_string(options.width) +
           " x " + std::to_string(options.height);
    return out + ", lights " + std::to_string(s.constantLights) + ' ' + std::to_string(s.uniformLights);
}

}  // namespace support
