// lesson_00_scene: a scene, a camera, a mesh; nothing is lit yet
// Slides 3, 34
//
// Slide 3 sets the task: how much light, and of what colour, arrives at the camera from each point of
// the scene. Here nobody answers yet. A mesh without a material of its own gets three.js's default, a flat
// white: every pixel of it is the same, and the knot is only a silhouette.
//
//     P = colour
//
// Try: orbit with the mouse. Without light and shade, can you tell which part of the knot is in front?
//
// What this file does not show (the window, OpenGL, the command line) is in common/lab and common/render.
//
// SPDX-License-Identifier: MIT
#include "lab/lab.hpp"

int main(int argc, char** argv) {
    lab::App app(argc, argv, "lesson_00_scene");

    // The scene, and the camera that looks at it.
    THREE::Scene miaScena;
    miaScena.background = 0x2E3440;
    THREE::PerspectiveCamera miaCamera(36);
    miaCamera.position.set(2.2, 2.7, 6.4);
    miaCamera.lookAt(0, 1.2, 0);

    // The geometry: 51,200 triangles with a normal at each vertex.
    THREE::TorusKnotGeometry buffers(0.9, 0.34, 400, 64);
    // The mesh, off the axes, so that no side of it is special.
    THREE::Mesh miaMesh(buffers);
    miaMesh.position.set(0, 1.55, 0);
    miaMesh.rotation.set(0.5, 0.3, 0.2);
    miaScena.add(miaMesh);

    // A floor below it.
    THREE::PlaneGeometry quadrato(9, 9);
    THREE::MeshBasicMaterial pavimentoMat(0x7788AA);
    THREE::Mesh pavimento(quadrato, pavimentoMat);
    pavimento.rotation.x = -1.5707963267948966;
    miaScena.add(pavimento);

    return app.run(miaScena, miaCamera, [&](double t) {
        // The knot turns with the time.
        miaMesh.rotation.y = 0.3 + 0.6 * t;
    });
}
