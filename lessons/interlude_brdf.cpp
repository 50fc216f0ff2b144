// interlude_brdf: f_r(w_i, w_r) as a lobe, and what becomes of 100 photons
// Slides 10-14, 44-45
//
// A material is a function of two directions (10): of the light that comes from w_i, how much goes towards w_r? The
// yellow arrow is w_i, the blue one w_r. The orange lobe is f_r(w_i, .): as far from the point in each direction as pi
// times f_r says, all of it smaller where it would not fit. The blue ball is f_r(w_i, w_r). The dots are photons: 100
// arrive along w_i, and those that are not absorbed go there (11); the ring holds what goes within 15 degrees of w_r.
//
//     f_r = a / pi                                                   Lambert: constant (13-14)
//     f_r = a / pi + k max(0, R . w_r)^s / (pi (n . w_i))            and Phong's peak about R, the mirror of w_i (45)
//
// With k = 0 the lobe is half a ball, however w_i and w_r turn. Why the pi? A surface with f_r = a would send back pi a,
// more than arrives; with a / pi it sends back a, its albedo. The slides call the constant itself the albedo (14) and fold
// its pi into the light: that is why P = (n . w) D L has none.
// The surprise: theta_i = 80, a = 0.5, k = 1, s = 3. More photons leave than arrive! Phong is no physics (44).
// Try: k = 0, then theta_i. Does the share sent back change? And why are the dots denser around n (20)?
//
// SPDX-License-Identifier: MIT
#include "lab/lab.hpp"
#include "lab/lobe.hpp"
#include "lab/strokes.hpp"
#include "lighting/brdf.hpp"

int main(int argc, char** argv) {
    lab::App app(argc, argv, "interlude_brdf");
    const double& theta_i = app.slider("theta_i", 45, 0, 85, {"ω_i, gradi da n", "ω_i, degrees from n"});
    const double& theta_r = app.slider("theta_r", 30, 0, 85, {"ω_r, gradi da n", "ω_r, degrees from n"});
    const double& phi_r =
        app.slider("phi_r", 0, -180, 180, {"ω_r, gradi attorno a n", "ω_r, degrees about n"});
    const double& a = app.slider("a", 0.4, 0, 1, {"albedo", "albedo"});
    const double& k = app.slider("k", 0.8, 0, 1, {"forza del riflesso", "strength of the highlight"});
    const double& s = app.slider("s", 10, 1, 100, {"lucidità", "shininess"});

    // The scene, and the camera that looks at it.
    THREE::Scene miaScena;
    miaScena.background = 0x2E3440;
    THREE::PerspectiveCamera miaCamera(30);
    miaCamera.position.set(1.6, 2.6, 7);
    miaCamera.lookAt(0, 0.75, 0);

    // The surface about the point, and lights to see shapes by.
    THREE::CylinderGeometry disco(1.8, 1.8, 0.1, 96);
    THREE::MeshLambertMaterial discoMat(0x5B6780), mioMat(0xFF8855);
    THREE::Mesh superficie(disco, discoMat);
    superficie.position.y = -0.05;
    THREE::DirectionalLight miaLuce(0xFFFFFF, 0.75);
    miaLuce.position.set(2, 3, 4);
    THREE::AmbientLight luceAmbiente(0x505050);
    lab::Strokes normale;
    normale.arrow({0, 0, 0}, {0, 1.6, 0}, 0.012);
    THREE::MeshBasicMaterial bianco(0xECEFF4), giallo(0xFFD060), azzurro(0x88C0D0);
    THREE::Mesh versoAlto(normale, bianco);
    miaScena.add(superficie, versoAlto, miaLuce, luceAmbiente);

    // What changes: the lobe, the two directions, the photons.
    lab::Lobe lobo;
    lab::Strokes luce, occhio, puntini;
    THREE::Mesh fr(lobo, mioMat), versoLuce(luce, giallo), versoOcchio(occhio, azzurro),
        fotoni(puntini, bianco);
    miaScena.add(fr, versoLuce, versoOcchio, fotoni);

    // The light goes round the normal with the time.
    return app.run(miaScena, miaCamera, [&](double t) {
        const THREE::Vector3 x(0, 0, 0), n(0, 1, 0);
        const THREE::Vector3 w_i = lab::direction(theta_i, 180 + 20 * t),
                             w_r = lab::direction(theta_r, phi_r);
        const lighting::PhongBrdf f_r{a, k, static_cast<int>(s)};
        const auto raggio = [&](const THREE::Vector3& w) { return std::numbers::pi * f_r(n, w_i, w); };
        const double scala = lobo.follow(raggio, 1.6);

        // Where 100 photons go; a ring about w_r, 15 degrees wide on each side.
        const lighting::Reflection riflessione(f_r, n, w_i);
        const std::vector<THREE::Vector3> partiti = riflessione.photons(100);
        puntini.clear().balls(lab::along(partiti, 1.9), 0.03);
        luce.clear().arrow(x, lab::along(w_i, 2.3), 0.025);
        occhio.clear().arrow(x, lab::along(w_r, 2.3), 0.025);
        occhio.circle(lab::along(w_r, 1.9 * std::cos(15 * lab::degree)), w_r,
                      1.9 * std::sin(15 * lab::degree), 0.015);
        occhio.ball(lab::along(w_r, scala * raggio(w_r)), 0.07);

        app.show({"f_r(ω_i, ω_r)", "f_r(ω_i, ω_r)"}, f_r(n, w_i, w_r));
        app.show({"fotoni che ripartono, su 100", "photons sent back, of 100"}, double(partiti.size()));
        app.show({"fotoni assorbiti", "photons absorbed"}, 100 - double(partiti.size()));
        app.show({"fotoni nell'anello", "photons into the ring"}, lighting::countWithin(partiti, w_r, 15));
        app.show({"parte riflessa, sommando", "share sent back, summed up"}, riflessione.sentBack());
        app.show({"parte riflessa, formula", "share sent back, closed form"},
                 f_r.sentBack(theta_i * lab::degree));
    });
}
