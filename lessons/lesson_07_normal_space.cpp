// lesson_07_normal_space: which matrix takes a normal along, and into which space
// Slides 33
//
// The equation's points and vectors must all be in one space (33). Points go there by the model matrix. Normals do not,
// whatever the slide's wording: where a mesh is stretched, a plane gets steeper and its normal must get flatter. The matrix
// that keeps it at right angles to the surface is the inverse transpose of the model matrix's 3x3 part, the normal matrix.
//
//     n = normalize( (M^-1)^T n_object )
//
// The surprise: with rotations and equal scales both matrices agree, so a wrong program looks right for six lessons.
// Here the knot is squashed, and key N (or --normal-matrix model) shows what the model matrix alone would do.
// Try: key X (or --space view): world or view space, light for light the same picture. Why not clip space?
//
// SPDX-License-Identifier: MIT
#include "lab/lab.hpp"

int main(int argc, char** argv) {
    lab::App app(argc, argv, "lesson_07_normal_space");

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
    // Slide 33: squashed, it shows whether its normals are taken along well.  // NUOVO 33
    miaMesh.scale.set(1, 1, 0.4);  // NUOVO 33
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

    // Slide 38: more lights are more addends: a ring of twelve.
    std::deque<THREE::PointLight> anello;
    for (int i = 0; i < 12; ++i) {
        THREE::PointLight& luce = anello.emplace_back(0xFFFFFF, 1, 0, 2);
        luce.color.setHSL(i / 12.0, 1, 0.5);
        luce.position.setFromCylindricalCoords(2.6, 6.2831853 * i / 12, 1);
        miaScena.add(luce);
    }
    // Slide 39: being many, they must be weak. A number to move by hand.
    const double& forza = app.slider("forza", 0.5, 0, 5, {"luci", "lamps"});

    // Slide 43: a light that comes from everywhere, faint and grey: 0x10 of 0xFF.
    THREE::AmbientLight luceAmbiente(0x101010);
    miaScena.add(luceAmbiente);

    return app.run(miaScena, miaCamera, [&](double t) {
        // Every frame, the ring is as strong as the slider says.
        for (THREE::PointLight& luce : anello)
            luce.intensity = forza;
        // The knot turns with the time.
        miaMesh.rotation.y = 0.3 + 0.6 * t;
    });
}
