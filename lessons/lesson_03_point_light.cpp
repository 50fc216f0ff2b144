// lesson_03_point_light: the direction depends on the point, and lights add up
// Slides 29-30, 37.5-37.6, 38
//
// A point light stands at P_L: each point Q of the surface sees it in a direction of its own (30),
// w = (P_L - Q) / |P_L - Q|. With two lights, the colour is the sum of what each would give alone (38).
//
//     P = (n . w_1) D (x) L_1 + (n . w_2) D (x) L_2          each dot product "but zero if negative"
//
// The surprise: look at the floor. Under the sun it was all one colour; near the bulb it is not, because w changes.
// Try: keys 6 and 7 show each light alone. 3 (the clamp) off: now light from behind takes away what the other gave.
// Today's three.js shows this scene differently: since r155 its lights fade with distance; the lecture's did not.
//
// SPDX-License-Identifier: MIT
#include "lab/lab.hpp"

int main(int argc, char** argv) {
    lab::App app(argc, argv, "lesson_03_point_light");

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

    // Slide 37, step 5: a second light, one that stands somewhere, as a bulb does.  // NUOVO 37.5
    THREE::PointLight luce2;  // NUOVO 37.5
    miaScena.add(luce2);  // NUOVO 37.5
    // Step 6: its colour, a reddish one, and this time a real position.  // NUOVO 37.6
    luce2.color.set(0xDD6666);  // NUOVO 37.6
    luce2.position.set(2, 1.5, 5);  // NUOVO 37.6

    return app.run(miaScena, miaCamera, [&](double t) {
        // The knot turns with the time.
        miaMesh.rotation.y = 0.3 + 0.6 * t;
    });
}
