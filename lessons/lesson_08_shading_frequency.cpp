// lesson_08_shading_frequency: how often the equation is evaluated: per fragment, per vertex, per face
// Slides 32-33
//
// The equation is evaluated at each fragment, with the normal interpolated between the vertices: per-pixel lighting (33).
// It can also be evaluated at the vertices and its result interpolated, which is cheaper, or with one normal for a face.
// On fine meshes nobody sees a difference; these two balls are coarse, and the right one has `flatShading`.
//
//     per fragment: P( interpolate(n), interpolate(Q) )          per vertex: interpolate( P(n, Q) )
//
// The surprise: key G (or --shading vertex). The knot, 51,200 triangles, stays as it is, but the floor has only two: the
// pool of light lies between its corners, so it is gone. Try --shading flat: why does light still vary over the floor?
//
// SPDX-License-Identifier: MIT
#include "lab/lab.hpp"

int main(int argc, char** argv) {
    lab::App app(argc, argv, "lesson_08_shading_frequency");

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
    // Slide 33: squashed, it shows whether its normals are taken along well.
    miaMesh.scale.set(1, 1, 0.4);
    // Step 2: set the base colour D (an orange, whatever slide 36 calls it).
    mioMat.color.set(0xFF8855);

    // A floor below it.
    THREE::PlaneGeometry quadrato(9, 9);
    THREE::MeshLambertMaterial pavimentoMat(0x7788AA);
    THREE::Mesh pavimento(quadrato, pavimentoMat);
    pavimento.rotation.x = -1.5707963267948966;
    miaScena.add(pavimento);
    // Slide 33: a coarse ball, whose normals are interpolated all the same.  // NUOVO 33
    THREE::SphereGeometry sfera(0.45, 10, 7);  // NUOVO 33
    THREE::Mesh palla(sfera, mioMat);  // NUOVO 33
    palla.position.set(-0.5, 0.45, 1.9);  // NUOVO 33
    miaScena.add(palla);  // NUOVO 33
    THREE::MeshLambertMaterial aFacce(0xFF8855);  // NUOVO 33
    aFacce.flatShading = true;  // one normal for each face  // NUOVO 33
    THREE::Mesh pallaAFacce(sfera, aFacce);  // NUOVO 33
    pallaAFacce.position.set(1.5, 0.45, 1.7);  // NUOVO 33
    miaScena.add(pallaAFacce);  // NUOVO 33

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
