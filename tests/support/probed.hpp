// A floor under three lights whose sum at the origin one can work out by hand, and fields of the probe's
// line.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/live/probe.hpp"
#include "lighting/frame_plan.hpp"
#include "three/three.hpp"
#include "three/validate.hpp"

#include <cmath>
#include <map>
#include <string>

namespace support {

/// Lesson-like: D = (1, 0x88 / 255, 0x55 / 255), a white light from (0, 3, -2), one of (5, 10, 2.5) at (2,
/// 1.5, 5) with f = 1 / d^2, ambient light of (0.1, 0.2, 0.3), in this order. The middle pixel of a picture
/// of odd size sees the origin.
struct Floor {
    THREE::Scene scene;
    THREE::PerspectiveCamera camera{45, 1, 0.1, 100};
    THREE::PlaneGeometry sheet{8, 8};
    THREE::MeshPhongMaterial paint{THREE::Color(0xFF8855)};
    THREE::Mesh floor{sheet, paint};
    THREE::DirectionalLight sun;
    THREE::PointLight bulb{THREE::Color(0.5, 1, 0.25), 10, 0, 2};
    THREE::AmbientLight sky{THREE::Color(0.1, 0.2, 0.3)};
    lab::Prober prober;

    Floor() {
        paint.specular = THREE::Color(0, 0, 0);
        floor.name = "floor";
        floor.rotation.x = -std::acos(0.0);
        sun.position.set(0, 3, -2);
        sun.name = "sun";
        bulb.position.set(2, 1.5, 5);
        scene.add(floor, sun, bulb, sky);
        camera.position.set(0, 2, 3);
        camera.lookAt(0, 0, 0);
    }
    /// Everything up to date and checked, as a window leaves it; then the prober looks.
    void see(const lighting::Switches& switches = {}, int size = 65) {
        scene.updateMatrixWorld();
        camera.updateWorldMatrix();
        THREE::validate(scene, camera);
        prober.see(scene, camera, switches, size, size);
    }
    lab::ProbeReport middle(const lighting::Switches& switches = {}) {
        see(switches);
        return *prober.at(32, 32);
    }
    lighting::FramePlan plan() const { return lighting::planFrame(scene, camera, lighting::Settings()); }
};

/// "probe a = 1; b = (2, 3, 4)" by name; of remarks the last.
inline std::map<std::string, std::string> fieldsOf(const std::string& line) {
    std::map<std::string, std::string> fields;
    if (!line.starts_with("probe "))
        return fields;
    for (std::size_t at = 6; at < line.size();) {
        const std::size_t end = std::min(line.find("; ", at), line.size()), middle = line.find(" = ", at);
        if (middle >= end)
            fields["bad"] = line.substr(at, end - at);
        else
            fields[line.substr(at, middle - at)] = line.substr(middle + 3, end - middle - 3);
        at = end + 2;
    }
    return fields;
}

}  // namespace support
