// lesson_02_directional_light: P = (n . w) D (x) L
// Slides 16-30, 36.3-36.4
//
// How much light does a bit of surface receive? The more squarely the light falls on it, the more: the cosine of
// the angle between its normal n and the direction w towards the light (20), which is their dot product (24).
// Light from behind gives zero, "certainly not a negative number" (23). In colours, channel by channel: (x) (26-27).
//
//     P = max(0, n . w) D (x) L          w is the same everywhere: a sun, large and far (29-30)
//
// The surprise: the light comes from above and *behind* the knot. (0, 3, -2) points to where the sun is, not to
// where it shines. The floor is lit all over; of the knot that you see, about a fifth is.
// Try: key 2 (the cosine) off: lit or not, nothing between; 3 (the clamp) is drawn dim: with one light, why?
//
// SPDX-License-Identifier: MIT
#include "lab/lab.hpp"

int main(int argc, char** argv) {
    lab::App app(argc, argv, "lesson_02_directional_light");

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

    // Slide 36, step 3: make a light, a directional one, and add it to the scene.  // NUOVO 36.3
    THREE::DirectionalLight miaLuce;  // NUOVO 36.3
    miaScena.add(miaLuce);  // NUOVO 36.3
    // Step 4: its colour L, and its direction; "position" is normalised.  // NUOVO 36.4
    miaLuce.color.set(0xFFFFFF);  // NUOVO 36.4
    miaLuce.position.set(0, 3, -2);  // NUOVO 36.4

    return app.run(miaScena, miaCamera, [&](double t) {
        // The knot turns with the time.
        miaMesh.rotation.y = 0.3 + 0.6 * t;
    });
}
