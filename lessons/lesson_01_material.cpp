// lesson_01_material: a Lambertian material, and no light to show it
// Slides 9-15, 36.1-36.2, 39
//
// A material says how a surface answers to light (slides 9-10). The simplest one sends the same share of the
// light in every direction: Lambertian, or purely diffuse (13). That share is its albedo, here one number per
// colour: the base colour D (14, 27).
//
//     P = (no addend) = 0
//
// The surprise: everything turns black. Nothing is wrong: in the dark all objects are black (39). Only the
// background, which is no object, keeps its colour.
//
// SPDX-License-Identifier: MIT
#include "lab/lab.hpp"

int main(int argc, char** argv) {
    lab::App app(argc, argv, "lesson_01_material");

    // The scene, and the camera that looks at it.
    THREE::Scene miaScena;
    miaScena.background = 0x2E3440;
    THREE::PerspectiveCamera miaCamera(36);
    miaCamera.position.set(2.2, 2.7, 6.4);
    miaCamera.lookAt(0, 1.2, 0);

    // The geometry: 51,200 triangles with a normal at each vertex.
    THREE::TorusKnotGeometry buffers(0.9, 0.34, 400, 64);
    // Slide 36, step 1: make the material and use it for the mesh.  // NUOVO 36.1
    THREE::MeshLambertMaterial mioMat;  // NUOVO 36.1

    // The mesh, off the axes, so that no side of it is special.
    THREE::Mesh miaMesh(buffers, mioMat);  // NUOVO 36.1
    // PRIMA THREE::Mesh miaMesh(buffers);
    miaMesh.position.set(0, 1.55, 0);
    miaMesh.rotation.set(0.5, 0.3, 0.2);
    miaScena.add(miaMesh);
    // Step 2: set the base colour D (an orange, whatever slide 36 calls it).  // NUOVO 36.2
    mioMat.color.set(0xFF8855);  // NUOVO 36.2

    // A floor below it.
    THREE::PlaneGeometry quadrato(9, 9);
    THREE::MeshLambertMaterial pavimentoMat(0x7788AA);  // NUOVO 36
    // PRIMA THREE::MeshBasicMaterial pavimentoMat(0x7788AA);
    THREE::Mesh pavimento(quadrato, pavimentoMat);
    pavimento.rotation.x = -1.5707963267948966;
    miaScena.add(pavimento);

    return app.run(miaScena, miaCamera, [&](double t) {
        // The knot turns with the time.
        miaMesh.rotation.y = 0.3 + 0.6 * t;
    });
}
