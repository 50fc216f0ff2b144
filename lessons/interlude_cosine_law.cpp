// interlude_cosine_law: a beam of light on a tilted patch, counted ray by ray
// Slides 16-23
//
// How much of the light that comes from a direction does a bit of surface receive (16-18)? Here light is a beam of
// parallel rays, equally spaced. 50 of them end on the patch when it lies square to them; tilted, it is narrower for
// the rays, and fewer do. They are counted where they end, on triangles: no formula is used.
//
//     rays that hit / 50 = max(0, n . w)          the cosine law (20)
//
// The patch is Lambertian and lit along the beam, so that its colour fades with the same number. Above: a bar for
// the count at 0, 10, 20, ... 180 degrees, the line cos(alpha), and a ball at the present tilt and count.
// The surprise: half of the light is lost at 60 degrees, not at 45; and beyond 90 the line goes on below zero, but
// no bar does. From behind there is no light (23), "certainly not a negative number".
// Try: alpha (the arrow keys) to 30, 60, 85, 90 (22), 120. How many rays? Say it first, then look.
//
// SPDX-License-Identifier: MIT
#include "lab/beam.hpp"
#include "lab/lab.hpp"

int main(int argc, char** argv) {
    lab::App app(argc, argv, "interlude_cosine_law");
    const double& alpha = app.slider("alpha", 40, 0, 180, {"inclinazione, gradi", "tilt, degrees"});

    // The scene, and a camera from so far away that parallel rays look parallel.
    THREE::Scene miaScena;
    miaScena.background = 0x2E3440;
    THREE::PerspectiveCamera miaCamera(20);
    miaCamera.position.set(5.5, 4.6, 13.8);
    miaCamera.lookAt(0, 0.75, 0);

    // The patch, 2 x 2: its front Lambertian, its back a plain blue. And a floor, far below.
    THREE::PlaneGeometry quadrato(2, 2);
    THREE::MeshLambertMaterial mioMat(0xFF8855);
    THREE::MeshBasicMaterial retroMat(0x5E81AC), pavimentoMat(0x3B4456);
    retroMat.side = THREE::BackSide;
    THREE::Mesh superficie(quadrato, mioMat), retro(quadrato, retroMat), pavimento(quadrato, pavimentoMat);
    superficie.add(retro);
    pavimento.scale.set(1.8, 1.2, 1);
    pavimento.position.y = -1.2;
    pavimento.rotation.x = -90 * lab::degree;
    miaScena.add(superficie, pavimento);

    // The light, its rays, and what is drawn of them: w is straight up.
    THREE::Vector3 w(0, 1, 0);
    THREE::DirectionalLight miaLuce;
    miaLuce.position = w;
    lab::Beam raggi(14, 5, 0.2, 0.4, 1.35);
    lab::Strokes colpi, mancati;
    THREE::MeshBasicMaterial giallo(0xFFD060), grigio(0x8A8270);
    THREE::Mesh raggiColpiti(colpi, giallo), raggiMancati(mancati, grigio);
    miaScena.add(miaLuce, raggiColpiti, raggiMancati);

    // Tilts the patch and counts the rays that end on its front.
    const auto conta = [&](double gradi) {
        superficie.rotation.set(-90 * lab::degree, gradi * lab::degree, 0);
        raggi.strike({&superficie, &retro, &pavimento});
        return raggi.hits(superficie);
    };

    // The diagram: the counts as bars, 50 times the cosine as a line.
    const lab::Chart diagramma{{-1.9, 1.95, -1}, 3.8, 0.85, 0, 180, 50};
    lab::Strokes barre, linea, ora;
    diagramma.bars(barre, 19, 0.065, conta);
    diagramma.curve(linea, 91, 0.018, [](double gradi) { return 50 * std::cos(gradi * lab::degree); });
    linea.stick(diagramma.at(0, 0), diagramma.at(180, 0), 0.018);
    THREE::MeshBasicMaterial azzurro(0x88C0D0), bianco(0xFFFFFF);
    THREE::Mesh istogramma(barre, azzurro), coseno(linea, bianco), segno(ora, giallo);
    THREE::Group quadro;
    quadro.rotation.y = 22 * lab::degree;
    quadro.add(istogramma, coseno, segno);
    miaScena.add(quadro);

    // The patch turns with the time.
    return app.run(miaScena, miaCamera, [&](double t) {
        const double gradi = alpha + 20 * t;
        const THREE::Vector3 n = lab::direction(gradi, 0);
        const int colpiti = conta(gradi);
        colpi.clear().sticks(raggi.raysTo(superficie), 0.013).balls(raggi.pointsOn(superficie), 0.045);
        mancati.clear().sticks(raggi.raysTo(pavimento), 0.012).sticks(raggi.raysTo(retro), 0.012);
        ora.clear().ball(diagramma.at(std::acos(n.dot(w)) / lab::degree, colpiti, 0.1), 0.09);
        app.show({"raggi che colpiscono il davanti", "rays that hit the front"}, colpiti);
        app.show({"raggi per unità di superficie", "rays per unit of area"}, colpiti / 4.0);
        app.show({"parte dei 50 che lo colpiscono di fronte", "share of the 50 that hit it face-on"},
                 colpiti / 50.0);
        app.show({"n · ω = cos(alpha)", "n · ω = cos(alpha)"}, n.dot(w));
    });
}
