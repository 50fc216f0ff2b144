// lesson_04_ambient: the ambient component, and the lecture's equation is whole
// Slides 40-43
//
// Where no light falls, lessons 02 and 03 are perfectly black; in a real room they never are. A little light reaches
// every surface from every direction (40). It is added once, times the base colour like all light (42):
//
//     P = ( sum_i  max(0, n . w_i) D (x) L_i )  +  D (x) L_A
//
// This is the lecture's lez04.html. The surprise: there is almost nothing to see. 16 of 255, times D, is at most
// (16, 9, 5): press 8 and look at the darkest places, where the knot turns away from both lights.
// Try: --terms ambient shows the new term alone: a silhouette again, as in lesson 00, but a very dark one. Why?
//
// SPDX-License-Identifier: MIT
#include "lab/lab.hpp"

int main(int argc, char** argv) {
    lab::App app(argc, argv, "lesson_04_ambient");

    // The scene, and the camera that looks at it.
    THREE::Scene miaScena;
    miaScena.background = 0x2E3440;
    THREE::PerspectiveCamera miaCamera(36);
    miaCamera.position.set(2.2, 2.7, 6.4);
    miaCamera.lookAt(0, 1.2, 0);

    // The geometry: 51,200 triangles with a normal at each vertex.
    THREE::TorusKnotGeometry buffers(0.9, 0.34, 400, 64);
    // Slide 36, step 1: make the material and use it for the mesh.
    THREE::MeshLambertMaterial mioMat;

    // The mesh, off the axes, so that no side of it is special.
    THREE::Mesh miaMesh(buffers, mioMat);
    miaMesh.position.set(0, 1.55, 0);
    miaMesh.rotation.set(0.5, 0.3, 0.2);
    miaScena.add(miaMesh);
    // Step 2: set the base colour D (an orange, whatever slide 36 calls it).
    mioMat.color.set(0xFF8855);

    // A floor below it.
    THREE::PlaneGeometry quadrato(9, 9);
    THREE::MeshLambertMaterial pavimentoMat(0x7788AA);
    THREE::Mesh pavimento(quadrato, pavimentoMat);
    pavimento.rotation.x = -1.5707963267948966;
    miaScena.add(pavimento);

    // Slide 36, step 3: make a light, a directional one, and add it to the scene.
    THREE::DirectionalLight miaLuce;
    miaScena.add(miaLuce);
    // Step 4: its colour L, and its direction; "position" is normalised.
    miaLuce.color.set(0xFFFFFF);
    miaLuce.position.set(0, 3, -2);

    // Slide 37, step 5: a second light, one that stands somewhere, as a bulb does.
    THREE::PointLight luce2;
    miaScena.add(luce2);
    // Step 6: its colour, a reddish one, and this time a real position.
    luce2.color.set(0xDD6666);
    luce2.position.set(2, 1.5, 5);

    // Slide 43: a light that comes from everywhere, faint and grey: 0x10 of 0xFF.  // NUOVO 43
    THREE::AmbientLight luceAmbiente(0x101010);  // NUOVO 43
    miaScena.add(luceAmbiente);  // NUOVO 43

    return app.run(miaScena, miaCamera, [&](double t) {
        // The knot turns with the time.
        miaMesh.rotation.y = 0.3 + 0.6 * t;
    });
}
