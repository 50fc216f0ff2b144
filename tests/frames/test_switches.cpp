// What the switches do to a frame: highlights, per-vertex and flat lighting, view space, normals by the wrong matrix (slides
// 33, 44-45). Against formulas that one can write down, and against each other.
// SPDX-License-Identifier: MIT
#include "support/stage.hpp"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <iostream>

namespace {

using lighting::NormalTransform;
using lighting::Shading;
using lighting::Space;
using lighting::Term;
using lighting::TermSet;
using support::Drawn;
using support::DrawOptions;
using support::Stage;
using THREE::SpecularModel;

// A square of side 2 in the plane z = 0, seen from (0, 0, 2) so that it fills the picture; one light.
struct Square {
    THREE::Scene scene;
    THREE::PlaneGeometry geometry{2, 2};
    THREE::MeshPhongMaterial material{THREE::Color(0x000000)};
    THREE::Mesh plane{geometry, material};
    THREE::DirectionalLight sun{THREE::Color(0xFF8855), 1.5};
    THREE::PerspectiveCamera camera{53.13010235415598, 1, 0.1, 10};
    DrawOptions options;
    const glm::dvec3 n{0, 0, 1}, L = 1.5 * glm::dvec3(1, 0x88 / 255.0, 0x55 / 255.0), K{0.9, 0.6, 0.3};

    Square() {
        scene.add(plane, sun);
        sun.position.set(0.3, 0.2, 1);
        material.specular = THREE::Color(K.x, K.y, K.z);
        camera.position.z = 2;
    }
    glm::dvec3 w() const { return glm::normalize(glm::dvec3(sun.position)); }
    static glm::dvec3 v(const glm::dvec3& Q) { return glm::normalize(glm::dvec3(0, 0, 2) - Q); }
    void expect(double bound, const std::function<glm::dvec3(const glm::dvec3& Q)>& formula) {
        const Drawn drawn = support::draw(scene, camera, options);
        for (int y = 0; y < options.height; ++y)
            for (int x = 0; x < options.width; ++x) {
                const glm::dvec3 Q(2 * (x + 0.5) / options.width - 1, 1 - 2 * (y + 0.5) / options.height, 0);
                const glm::dvec3 P = formula(Q);
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(drawn.at(x, y)[c], P[c], bound)
                        << "pixel " << x << ',' << y << ", channel " << c;
            }
    }
};

TEST(Highlight, OfTheSlidesIsAPowerOfRAndV) {
    for (const double s : {0.0, 1.0, 7.5, 300.0}) {
        Square square;
        square.material.shininess = s;
        square.expect(2e-5, [&](const glm::dvec3& Q) {
            const glm::dvec3 R = 2 * square.w().z * square.n - square.w();
            return square.K * square.L * std::pow(std::max(0.0, glm::dot(R, Square::v(Q))), s);
        });
    }
}

TEST(Highlight, OfThreeJsIsItsOwnFormula) {
    for (const double s : {1.0, 30.0, 300.0}) {
        Square square;
        square.material.shininess = s;
        square.material.specularModel = SpecularModel::blinn;
        square.expect(2e-4, [&](const glm::dvec3& Q) {
            const glm::dvec3 h = glm::normalize(square.w() + Square::v(Q));
            const double vh = glm::dot(Square::v(Q), h);
            const glm::dvec3 F =
                square.K + (glm::dvec3(1) - square.K) * std::exp2((-5.55473 * vh - 6.98316) * vh);
            return F * square.L * square.w().z * ((s + 2) / 8) * std::pow(h.z, s);
        });
    }
}

// three.js's Fresnel factor goes to 1 at grazing angles whatever K_S is; skipped or not, the same bytes.
TEST(Highlight, OfThreeJsShinesAtGrazingAnglesEvenIfBlack) {
    Square square;
    square.material.specular.set(0x000000);
    square.material.specularModel = SpecularModel::blinn;
    square.material.shininess = 1;
    square.sun.position.set(1, 0, 0.3);
    square.expect(1e-7, [&](const glm::dvec3& Q) {
        const glm::dvec3 h = glm::normalize(square.w() + Square::v(Q));
        const double vh = glm::dot(Square::v(Q), h);
        return square.L * (std::exp2((-5.55473 * vh - 6.98316) * vh) * square.w().z * 3 / 8 * h.z);
    });
    const Drawn skipped = support::draw(square.scene, square.camera, square.options);
    EXPECT_GT(skipped.at(1, 32).r, 4e-5F) << "400 times the bound above";
    square.options.settings.skip = false;
    EXPECT_EQ(support::draw(square.scene, square.camera, square.options).floats(), skipped.floats());
}

TEST(Highlight, IsZeroWhereTheLightIsBehindOrItsTermIsOff) {
    Square square;
    square.sun.position.z = -0.001;
    square.material.shininess = 0;
    square.expect(0, [](const glm::dvec3&) { return glm::dvec3(0); });
    square.sun.position.z = 1;
    square.options.settings.terms = TermSet::all().without(Term::specular);
    square.expect(0, [](const glm::dvec3&) { return glm::dvec3(0); });
}

TEST(Highlight, FadesWithDistanceAsAllLightDoes) {
    Square square;
    square.sun.intensity = 0;
    THREE::PointLight bulb(THREE::Color(0xFF8855), 1.5, 0, 2);
    bulb.position.set(0.5, 0.3, 0.8);
    square.scene.add(bulb);
    square.material.shininess = 20;
    square.expect(1e-4, [&](const glm::dvec3& Q) {
        const glm::dvec3 toLight = glm::dvec3(bulb.position) - Q;
        const glm::dvec3 w = glm::normalize(toLight), R = 2 * w.z * square.n - w;
        return square.K * square.L * std::pow(std::max(0.0, glm::dot(R, Square::v(Q))), 20) /
               glm::dot(toLight, toLight);
    });
}

TEST(Highlight, IsAddedToLambertsSum) {
    Stage shiny, dull;
    for (Stage* stage : {&shiny, &dull})
        stage->bulb({2, 2.5, 2}, 4, 2);
    shiny.orange.specular.set(0x888888);
    shiny.place();
    dull.place();
    const image::Floats with = support::draw(shiny.scene, shiny.camera, shiny.options).floats();
    const image::Floats without = support::draw(dull.scene, dull.camera, dull.options).floats();
    shiny.options.settings.terms = TermSet::all().without(Term::specular);
    EXPECT_EQ(support::draw(shiny.scene, shiny.camera, shiny.options).floats(), without);
    int brighter = 0;
    for (std::size_t i = 0; i < with.size(); ++i) {
        ASSERT_GE(with[i], without[i]) << "value " << i;
        brighter += with[i] > without[i] + 0.01F ? 1 : 0;
    }
    EXPECT_GT(brighter, 500);
}

TEST(SpecularSwitch, OverridesTheMaterialsModel) {
    Square square;
    const image::Floats phong = support::draw(square.scene, square.camera, square.options).floats();
    square.options.settings.specular = SpecularModel::blinn;
    const image::Floats blinn = support::draw(square.scene, square.camera, square.options).floats();
    EXPECT_NE(phong, blinn);
    square.material.specularModel = SpecularModel::blinn;
    EXPECT_EQ(support::draw(square.scene, square.camera, square.options).floats(), blinn);
    square.options.settings.specular = SpecularModel::phong;
    EXPECT_EQ(support::draw(square.scene, square.camera, square.options).floats(), phong);
}

// The corners' colours, interpolated over the two triangles that PlaneGeometry makes: its diagonal goes up to the right.
TEST(VertexShading, InterpolatesTheCornersColours) {
    Square square;
    square.sun.intensity = 0;
    square.material.color.set(0xFFFFFF);
    square.material.shininess = 3;
    THREE::PointLight bulb(THREE::Color(0xFFFFFF), 1, 0, 1);
    bulb.position.set(0.5, 0.3, 0.8);
    square.scene.add(bulb);
    square.options.settings.shading = Shading::vertex;
    const auto P = [&](double x, double y) {
        const glm::dvec3 Q(x, y, 0), toLight = glm::dvec3(bulb.position) - Q;
        const glm::dvec3 w = glm::normalize(toLight), R = 2 * w.z * square.n - w;
        const double mirrored = std::max(0.0, glm::dot(R, Square::v(Q)));
        return (glm::dvec3(w.z) + square.K * std::pow(mirrored, 3)) / glm::length(toLight);
    };
    square.expect(2e-6, [&](const glm::dvec3& Q) {
        const double right = (Q.x + 1) / 2, down = (1 - Q.y) / 2;
        const glm::dvec3 upLeft = P(-1, 1), upRight = P(1, 1), lowLeft = P(-1, -1), lowRight = P(1, -1);
        return right + down < 1
                   ? upLeft + right * (upRight - upLeft) + down * (lowLeft - upLeft)
                   : lowRight + (1 - right) * (lowLeft - lowRight) + (1 - down) * (upRight - lowRight);
    });
}

TEST(VertexShading, OfAFineMeshIsAlmostPerPixelAndOfACoarseOneIsNot) {
    const auto difference = [](int along, int around) {
        Stage stage;
        stage.bulb({2, 2.5, 2}, 4, 2);
        for (THREE::Mesh* mesh : {&stage.floor, &stage.box, &stage.knot})
            mesh->visible = false;
        THREE::TorusKnotGeometry geometry(1, 0.35, along, around);
        THREE::Mesh knot(geometry, stage.orange);
        knot.position = stage.knot.position;
        stage.all.add(knot);
        stage.place();
        const Drawn pixel = support::draw(stage.scene, stage.camera, stage.options);
        stage.options.settings.shading = Shading::vertex;
        return support::largestDifference(pixel, support::draw(stage.scene, stage.camera, stage.options));
    };
    EXPECT_LT(difference(800, 128), 0.02);
    EXPECT_GT(difference(40, 6), 0.1);
}

TEST(VertexShading, LightsBothSidesOfADoubleSidedMesh) {
    Square square;
    square.material.color.set(0xFFFFFF);
    square.material.side = THREE::DoubleSide;
    square.options.settings.shading = Shading::vertex;
    square.options.settings.terms = TermSet::all().without(Term::specular);
    square.plane.rotation.y = std::acos(-1.0);  // its back to us
    square.expect(1e-6, [&](const glm::dvec3&) { return square.L * square.w().z; });
    square.sun.position.z = -1;
    square.expect(0, [](const glm::dvec3&) { return glm::dvec3(0); });
}

TEST(FlatShading, IsTheMaterialsOwnForAllMeshes) {
    Stage a, b;
    for (Stage* stage : {&a, &b}) {
        stage->bulb({2, 2.5, 2}, 4, 2);
        stage->place();
    }
    a.options.settings.shading = Shading::flat;
    for (THREE::Material* material :
         {static_cast<THREE::Material*>(&b.orange), static_cast<THREE::Material*>(&b.green),
          static_cast<THREE::Material*>(&b.blue)})
        material->flatShading = true;
    EXPECT_EQ(support::draw(a.scene, a.camera, a.options).floats(),
              support::draw(b.scene, b.camera, b.options).floats());
}

// Slide 33: any space will do, as long as it is one.
TEST(ViewSpace, IsTheSamePicture) {
    for (const Shading shading : {Shading::pixel, Shading::vertex, Shading::flat})
        for (const double offset : {0.0, 1e6}) {
            Stage stage;
            stage.bulb({2, 2.5, 2}, 4, 2, 9);
            stage.bulb({-2, 1.5, 1}, 1, 0.7);
            stage.orange.specular.set(0x888888);
            stage.all.position.set(offset, offset, -offset);
            stage.all.scale.set(1, 0.7, 1.2);
            stage.camera.scale.setScalar(3);  // a camera's size is no matter of light
            stage.options.settings.shading = shading;
            stage.place();
            const Drawn world = support::draw(stage.scene, stage.camera, stage.options);
            stage.options.settings.space = Space::view;
            const double worst =
                support::largestDifference(world, support::draw(stage.scene, stage.camera, stage.options));
            EXPECT_LT(worst, 4.2e-5) << "offset " << offset;  // measured 1.04e-5
            std::cout << "world and view space, offset " << offset << ": worst " << worst << '\n';
        }
}

TEST(ModelMatrixForNormals, IsRightForRotationsEqualScalesAndMirrorsOnly) {
    const auto worst = [](const THREE::Vector3& scale) {
        Stage stage;
        stage.knot.scale = scale;
        stage.place();
        const Drawn right = support::draw(stage.scene, stage.camera, stage.options);
        stage.options.settings.normals = NormalTransform::model;
        return support::largestDifference(right, support::draw(stage.scene, stage.camera, stage.options));
    };
    // The two normals are rounded differently: measured 7.0e-6 where a triangle is seen almost edge-on.
    EXPECT_LT(worst({1, 1, 1}), 2.8e-5);
    EXPECT_LT(worst({0.6, 0.6, 0.6}), 2.8e-5);
    EXPECT_LT(worst({-1, 1, 1}), 2.8e-5);
    EXPECT_GT(worst({1, 1, 0.4}), 0.2);
}

// A plane that leans back by 45 degrees after being stretched upwards by 3: its normal is known either way.
TEST(ModelMatrixForNormals, TakesThemAlongAsPointsAre) {
    Square square;
    const double h = std::sqrt(0.5);
    THREE::BufferGeometry geometry;
    geometry.setAttribute("position", {-3, -1, 1, 3, -1, 1, 3, 1, -1, -3, -1, 1, 3, 1, -1, -3, 1, -1}, 3);
    geometry.setAttribute("normal", {0, h, h, 0, h, h, 0, h, h, 0, h, h, 0, h, h, 0, h, h}, 3);
    THREE::Mesh leaning(geometry, square.material);
    square.plane.visible = false;
    square.scene.add(leaning);
    leaning.scale.set(1, 3, 1);
    square.material.color.set(0xFFFFFF);
    square.options.settings.terms = TermSet::all().without(Term::specular);
    square.expect(1e-6, [&](const glm::dvec3&) {
        return square.L * glm::dot(square.w(), glm::normalize(glm::dvec3(0, h / 3, h)));
    });
    square.options.settings.normals = NormalTransform::model;
    square.expect(1e-6, [&](const glm::dvec3&) {
        return square.L * glm::dot(square.w(), glm::normalize(glm::dvec3(0, 3 * h, h)));
    });
}

}  // namespace
