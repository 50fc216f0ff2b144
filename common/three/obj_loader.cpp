// loadObj: Wavefront .obj through tinyobjloader, one mesh per shape and material.
// SPDX-License-Identifier: MIT
#include "three/obj_text.hpp"
#include "three/object_loader.hpp"
#include "three/scene_file.hpp"
#include "three/validate.hpp"

#include <array>
#include <filesystem>
#include <map>
#include <new>
#include <sstream>
#include <tiny_obj_loader.h>

namespace THREE {

namespace {

// Reads .mtl files from the folder of the .obj. A missing one is no error: its meshes are white.
class MaterialFiles final : public tinyobj::MaterialReader {
  public:
    MaterialFiles(const std::string& obj, std::vector<std::string>& notes)
        : folder_(std::filesystem::path(obj).parent_path()), notes_(notes) {}

    bool operator()(const std::string& name, std::vector<tinyobj::material_t>* materials,
                    std::map<std::string, int>* byName, std::string* warning, std::string* error) override {
        const std::string file = (folder_ / name).string();
        std::error_code ignored;
        if (!std::filesystem::exists(file, ignored)) {
            notes_.push_back(file + ": no such file, so the surfaces it describes are white");
            return false;
        }
        const ObjText checked = checkMtl(readSceneFile(file), file);
        notes_.insert(notes_.end(), checked.notes.begin(), checked.notes.end());
        std::istringstream in(checked.text);
        tinyobj::LoadMtl(byName, materials, &in, warning, error);
        return true;
    }

  private:
    std::filesystem::path folder_;
    std::vector<std::string>& notes_;
};

struct Obj {
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    bool hasSmoothing = false;
};

Obj read(const std::string& text, const std::string& file, std::vector<std::string>& notes) {
    const ObjText checked = checkObj(text, file);
    for (const std::string& note : checked.notes)
        notes.push_back(file + ": " + note);
    Obj obj;
    obj.hasSmoothing = checked.hasSmoothing;
    MaterialFiles materialFiles(file, notes);
    std::istringstream in(checked.text);
    std::string warning;
    std::string error;
    if (!tinyobj::LoadObj(&obj.attributes, &obj.shapes, &obj.materials, &warning, &error, &in, &materialFiles,
                          true))
        throw SceneError(file + ": expected a Wavefront .obj, found one that tinyobjloader cannot read: " +
                         printable(error, 200));
    return obj;
}

std::vector<std::shared_ptr<MeshLambertMaterial>> materialsOf(const Obj& obj) {
    std::vector<std::shared_ptr<MeshLambertMaterial>> all;
    for (const tinyobj::material_t& material : obj.materials) {
        const auto color = [](const tinyobj::real_t* c) { return Color(c[0], c[1], c[2]); };
        const bool shiny = material.illum != 1 && !(color(material.specular) == Color(0, 0, 0));
        std::shared_ptr<MeshLambertMaterial> lambert;
        if (shiny) {
            auto phong = std::make_shared<MeshPhongMaterial>(color(material.diffuse));
            phong->specular = color(material.specular);
            phong->shininess = material.shininess;
            phong->specularModel = SpecularModel::blinn;
            lambert = std::move(phong);
        } else {
            lambert = std::make_shared<MeshLambertMaterial>(color(material.diffuse));
        }
        lambert->emissive = color(material.emission);
        lambert->name = material.name;
        all.push_back(std::move(lambert));
    }
    auto white = std::make_shared<MeshLambertMaterial>();  // for faces without a known material: id -1
    all.push_back(std::move(white));
    return all;
}

// The faces of one shape that have one material, as an indexed geometry. Corners that agree in everything share a vertex.
class Part {
  public:
    Part(const Obj& obj, const tinyobj::mesh_t& mesh, const std::vector<std::size_t>& faces) : obj_(obj) {
        for (const std::size_t face : faces)
            for (std::size_t i = 3 * face; i < 3 * face + 3; ++i) {
                hasNormals_ = hasNormals_ && mesh.indices[i].normal_index >= 0;
                hasUvs_ = hasUvs_ && mesh.indices[i].texcoord_index >= 0;
            }
        for (const std::size_t face : faces)
            for (std::size_t i = 3 * face; i < 3 * face + 3; ++i)
                index_.push_back(vertex(mesh.indices[i], smoothing(mesh, face)));
    }

    std::shared_ptr<BufferGeometry> geometry() {
        auto geometry = std::make_shared<BufferGeometry>();
        geometry->setAttribute("position", std::move(position_), 3);
        if (hasNormals_)
            geometry->setAttribute("normal", std::move(normal_), 3);
        if (hasUvs_)
            geometry->setAttribute("uv", std::move(uv_), 2);
        geometry->setIndex(std::move(index_));
        if (!hasNormals_)
            geometry->computeVertexNormals();
        return geometry;
    }

  private:
    // Whose neighbours are smoothed together when normals are computed: all where the file says nothing, else those of
    // the same group; group 0 ("s off") is a facet on its own.
    long long smoothing(const tinyobj::mesh_t& mesh, std::size_t face) const {
        if (hasNormals_ || !obj_.hasSmoothing)
            return 0;
        const unsigned group = mesh.smoothing_group_ids[face];
        return group != 0 ? static_cast<long long>(group) : -1 - static_cast<long long>(face);
    }

    std::uint32_t vertex(const tinyobj::index_t& corner, long long smooth) {
        const std::array<long long, 4> key = {corner.vertex_index, hasNormals_ ? corner.normal_index : -1,
                                              hasUvs_ ? corner.texcoord_index : -1, smooth};
        const auto [place, isNew] = vertices_.emplace(key, static_cast<std::uint32_t>(vertices_.size()));
        if (isNew) {
            append(position_, obj_.attributes.vertices, corner.vertex_index, 3);
            if (hasNormals_)
                append(normal_, obj_.attributes.normals, corner.normal_index, 3);
            if (hasUvs_)
                append(uv_, obj_.attributes.texcoords, corner.texcoord_index, 2);
        }
        return place->second;
    }

    static void append(std::vector<double>& to, const std::vector<tinyobj::real_t>& from, int number,
                       int size) {
        for (int i = 0; i < size; ++i)
            to.push_back(from.at(static_cast<std::size_t>(number) * static_cast<std::size_t>(size) +
                                 static_cast<std::size_t>(i)));
    }

    const Obj& obj_;
    bool hasNormals_ = true;
    bool hasUvs_ = true;
    std::map<std::array<long long, 4>, std::uint32_t> vertices_;
    std::vector<double> position_, normal_, uv_;
    std::vector<std::uint32_t> index_;
};

struct Faces {
    int material;
    std::vector<std::size_t> numbers;
};

// A shape's faces by material, in the order in which it uses them.
std::vector<Faces> facesByMaterial(const tinyobj::mesh_t& mesh) {
    std::vector<Faces> parts;
    std::map<int, std::size_t> places;
    for (std::size_t face = 0; face < mesh.material_ids.size(); ++face) {
        const auto [place, isNew] = places.emplace(mesh.material_ids[face], parts.size());
        if (isNew)
            parts.push_back({mesh.material_ids[face], {}});
        parts[place->second].numbers.push_back(face);
    }
    return parts;
}

LoadedScene build(const Obj& obj) {
    const auto materials = materialsOf(obj);
    LoadedScene loaded;
    loaded.scene = std::make_unique<Scene>();
    for (const tinyobj::shape_t& shape : obj.shapes) {
        for (const Faces& faces : facesByMaterial(shape.mesh)) {
            const std::shared_ptr<BufferGeometry> geometry = Part(obj, shape.mesh, faces.numbers).geometry();
            geometry->name = shape.name;
            const auto& material = faces.material >= 0
                                       ? materials.at(static_cast<std::size_t>(faces.material))
                                       : materials.back();
            auto mesh = std::make_unique<Mesh>(Handle<BufferGeometry>(geometry), Handle<Material>(material));
            mesh->name = shape.name;
            loaded.scene->add(std::move(mesh));
        }
    }
    loaded.scene->updateMatrixWorld();
    return loaded;
}

}  // namespace

LoadedScene loadObj(const std::string& file) { return parseObj(readSceneFile(file), file); }

LoadedScene parseObj(const std::string& text, const std::string& file) {
    try {
        std::vector<std::string> notes;
        const Obj obj = read(text, file, notes);
        LoadedScene loaded = build(obj);
        if (loaded.scene->children().empty())
            throw SceneError(file +
                             ": expected a mesh, found only faces that span no area; check its f lines");
        loaded.notes = std::move(notes);
        return loaded;
    } catch (const std::bad_alloc&) {
        throw SceneError(file + ": expected a scene that fits memory, found none left; simplify the mesh");
    }
}

}  // namespace THREE
