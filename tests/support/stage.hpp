// The scene that most frame tests vary.
// SPDX-License-Identifier: MIT
#pragma once

#include "support/judge.hpp"

#include <cmath>
#include <memory>

namespace support {

/// A knot and a box above a floor, all below one group, under a sun, an ambient light and bulbs.
struct Stage {
    THREE::Scene scene;
    THREE::Group all;
    THREE::TorusKnotGeometry knotGeometry{1, 0.35, 160, 32};
    THREE::MeshPhongMaterial orange{THREE::Color(0xFF8855)};  // dull unless a test lets it shine
    THREE::Mesh knot{knotGeometry, orange};
    THREE::BoxGeometry boxGeometry{1, 2, 0.5};
    THREE::MeshLambertMaterial green{THREE::Color(0x66AA77)};
    THREE::Mesh box{boxGeometry, green};
    THREE::PlaneGeometry floorGeometry{8, 8};
    THREE::MeshLambertMaterial blue{THREE::Color(0x7788AA)};
    THREE::Mesh floor{floorGeometry, blue};
    THREE::DirectionalLight sun{THREE::Color(0xFFEEDD), 0.5};
    THREE::AmbientLight ambient{THREE::Color(0x303848)};
    std::vector<std::unique_ptr<THREE::PointLight>> bulbs;
    THREE::PerspectiveCamera camera{40, 1, 0.1, 100};
    DrawOptions options;
    THREE::Vector3 eye{2, 2.5, 6}, target{0, 1.25, 0};

    Stage() {
        scene.background = THREE::Color(0x203040);
        scene.add(all, sun, ambient);
        all.add(knot, box, floor);
        knot.position.set(0, 1.6, 0);
        knot.rotation.set(0.5, 0.3, 0.2);
        box.position.set(-2, 1.2, 0.5);
        box.rotation.y = 0.6;
        floor.rotation.x = -std::acos(0.0);
        sun.position.set(1, 3, 2);
        orange.specular.set(0x000000);
        options.width = options.height = 128;
    }
    THREE::PointLight& bulb(const THREE::Vector3& place, double intensity, double k, double distance = 0) {
        bulbs.push_back(std::make_unique<THREE::PointLight>(THREE::Color(0xDD6666), intensity, distance, k));
        bulbs.back()->position = place;
        all.add(*bulbs.back());
        return *bulbs.back();
    }
    /// Puts the camera where eye and target, which move with the group, want it.
    void place() {
        scene.updateMatrixWorld();
        camera.position = all.matrixWorld.applyTo(eye);
        lookAt(camera, all.matrixWorld.applyTo(target), options);
    }
};

}  // namespace support
