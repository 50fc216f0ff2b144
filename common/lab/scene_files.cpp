// Reads scene files.
// SPDX-License-Identifier: MIT
#include "lab/scene_files.hpp"

#include "three/validate.hpp"

#include <filesystem>
#include <system_error>

namespace lab {

THREE::LoadedScene loadScene(const std::string& file) {
    THREE::LoadedScene loaded = THREE::ObjectLoader().load(file);
    loaded.scene->updateMatrixWorld();
    // Before its size is measured; a camera that sees as far as anything may be.
    THREE::validate(*loaded.scene, THREE::PerspectiveCamera(50, 1, 1e30, 1e36));
    return loaded;
}

void takeCamera(THREE::PerspectiveCamera& camera, const THREE::PerspectiveCamera& own) {
    camera.fov = own.fov;
    camera.near = own.near;
    camera.far = own.far;
    camera.zoom = own.zoom;
    camera.up = own.up;
    camera.applyMatrix4(own.matrixWorld);
}

void expectView(const THREE::LoadedScene& loaded) {
    if (loaded.camera == nullptr)
        return;
    THREE::PerspectiveCamera camera(40);
    takeCamera(camera, *loaded.camera);
    camera.updateWorldMatrix();
    THREE::validate(*loaded.scene, camera);
}

std::string folderOf(const std::string& file) {
    const std::filesystem::path folder = std::filesystem::path(file).parent_path();
    return folder.empty() ? "." : folder.string();
}

bool sameFile(const std::string& a, const std::string& b) {
    std::error_code error;
    return std::filesystem::equivalent(a, b, error) && !error;
}

}  // namespace lab
