// lesson_06_many_lights: a sum over as many lights as one likes, each of them weaker
// Slides 38-39
//
// More lights are more addends, nothing else (38). Here a ring of twelve coloured bulbs joins the two lights of before.
// Each costs another evaluation at every pixel (39): key C measures it. And each pushes the sum up, but a pixel
// ends at (1,1,1), and what is above is cut off: so many lights must be weak, each of them (39).
//
//     P = ( sum_i  max(0, n . w_i)  f(d_i)  D (x) L_i )  +  D (x) L_A          i = 1 ... 14
//
// The surprise: move the slider `forza` (arrow keys; or --set forza=5). The lamps get stronger, and the picture loses its
// shapes, then its colours: each channel stops at 1 by itself, so orange turns yellow before it turns white.
// Try: `forza` at 0. How many lights does --stats count then, and what does a frame cost?
//
// SPDX-License-Identifier: MIT
#include "lab/lab.hpp"

int main(int argc, char** argv) {
    lab::App app(argc, argv, "lesson_06_many_lights");

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
    // Slide 31: its light is divided by d^2, so it must be stronger to be seen.
    luce2.decay = 2;
    luce2.intensity = 25;

    // Slide 38: more lights are more addends: a ring of twelve.  // NUOVO 38
    std::deque<THREE::PointLight> anello;  // NUOVO 38
    for (int i = 0; i < 12; ++i) {  // NUOVO 38
        THREE::PointLight& luce = anello.emplace_back(0xFFFFFF, 1, 0, 2);  // NUOVO 38
        luce.color.setHSL(i / 12.0, 1, 0.5);  // NUOVO 38
        luce.position.setFromCylindricalCoords(2.6, 6.2831853 * i / 12, 1);  // NUOVO 38
        miaScena.add(luce);  // NUOVO 38
    }  // NUOVO 38
    // Slide 39: being many, they must be weak. A number to move by hand.  // NUOVO 39
    const double& forza = app.slider("forza", 0.5, 0, 5, {"luci", "lamps"});  // NUOVO 39

    // Slide 43: a light that comes from everywhere, faint and grey: 0x10 of 0xFF.
    THREE::AmbientLight luceAmbiente(0x101010);
    miaScena.add(luceAmbiente);

    return app.run(miaScena, miaCamera, [&](double t) {
        // Every frame, the ring is as strong as the slider says.  // NUOVO 39
        for (THREE::PointLight& luce : anello)  // NUOVO 39
            luce.intensity = forza;  // NUOVO 39
        // The knot turns with the time.
        miaMesh.rotation.y = 0.3 + 0.6 * t;
    });
}
