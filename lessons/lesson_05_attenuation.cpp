// lesson_05_attenuation: light fades with distance, f(d) = 1 / d^k
// Slides 31
//
// A bulb does not shine equally far away: its light spreads over a larger and larger sphere, so what arrives is divided by
// the square of the distance d = |P_L - Q|. Where that fades too abruptly one picks a smaller exponent k, down to 0 (31).
//
//     P = ( sum_i  max(0, n . w_i)  f(d_i)  D (x) L_i )  +  D (x) L_A          f(d) = 1 / d^k
//
// The surprise: with its old intensity the bulb would all but go out, since it hangs some five units away and of 1 only a
// 25th is left. So it is made 25 times stronger, and now one sees where it is: the nearer, the brighter, knot and floor.
// Try: key K, or --decay 0, 1, 1.5. With k = 0 all turns white: why? And with 5, which takes f away? Look at the far floor:
// how does it change as k grows? Nearer than d = 1 the factor is larger than 1. That is no mistake.
//
// SPDX-License-Identifier: MIT
#include "lab/lab.hpp"

int main(int argc, char** argv) {
    lab::App app(argc, argv, "lesson_05_attenuation");

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
    // Slide 31: its light is divided by d^2, so it must be stronger to be seen.  // NUOVO 31
    luce2.decay = 2;  // NUOVO 31
    luce2.intensity = 25;  // NUOVO 31

    // Slide 43: a light that comes from everywhere, faint and grey: 0x10 of 0xFF.
    THREE::AmbientLight luceAmbiente(0x101010);
    miaScena.add(luceAmbiente);

    return app.run(miaScena, miaCamera, [&](double t) {
        // The knot turns with the time.
        miaMesh.rotation.y = 0.3 + 0.6 * t;
    });
}
