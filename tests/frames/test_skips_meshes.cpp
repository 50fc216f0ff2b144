// What a frame leaves out of its meshes: those out of view, lights of black ones, faces that are hidden, uploads. Each time the
// same bytes as with --no-skip, a counter that says so, and fewer draws, lights or faces.
// SPDX-License-Identifier: MIT
#include "render/program.hpp"
#include "support/both_ways.hpp"
#include "support/stage.hpp"

#include <functional>
#include <gtest/gtest.h>

namespace {

using lighting::Term;
using lighting::TermSet;
using support::BothWays;

struct SkippedMeshes : testing::Test, support::Stage {
    SkippedMeshes() {
        options.width = 60;
        options.height = 52;
    }
    BothWays bothWays() {
        place();
        return support::drawBothWays(scene, camera, options);
    }
};

const lighting::Draw& drawOf(const lighting::FramePlan& plan, const THREE::Mesh& mesh) {
    for (const lighting::Draw& draw : plan.draws)
        if (draw.mesh == &mesh)
            return draw;
    throw std::runtime_error("the mesh is not drawn");
}

TEST_F(SkippedMeshes, OutsideTheView) {
    THREE::Mesh out(knotGeometry, orange);
    scene.add(out);
    const auto triangles = static_cast<long long>(knotGeometry.triangleCount());
    for (const THREE::Vector3& where :
         {THREE::Vector3(0, 0, 40), THREE::Vector3(40, 0, 0), THREE::Vector3(-40, 0, 0),
          THREE::Vector3(0, 40, 0), THREE::Vector3(0, -40, 0), THREE::Vector3(-40, -40, -200)}) {
        out.position = where;
        const BothWays both = bothWays();
        EXPECT_TRUE(both.tells(out, "outside the camera's view"));
        EXPECT_EQ(both.skipped.stats.meshesSkipped, 1);
        EXPECT_EQ(both.skipped.stats.drawCalls, 3);
        EXPECT_EQ(both.whole.stats.meshesSkipped, 0);
        EXPECT_EQ(both.whole.stats.drawCalls, 4);
        EXPECT_EQ(both.whole.stats.triangles, both.skipped.stats.triangles + triangles);
    }
    out.position.set(0, 1, 0);
    EXPECT_EQ(bothWays().skipped.stats.meshesSkipped, 0);
}

// A ball that touches the far plane from behind, or the near one from before, as closely as doubles can tell: floats, whose far
// depths lie far apart, may draw a piece of it.
TEST_F(SkippedMeshes, JustBeyondThePlanesOfTheView) {
    all.remove(knot);
    all.remove(box);
    all.remove(floor);
    THREE::SphereGeometry ballGeometry(1, 48, 48);
    THREE::BoxGeometry cubeGeometry;
    green.side = THREE::DoubleSide;
    THREE::Mesh ball(ballGeometry, green), cube(cubeGeometry, green);
    scene.add(ball, cube);
    eye.set(0, 0, 0);
    target.set(0, 0, -1);
    for (const double fov : {0.05, 1.0, 40.0})
        for (const double near : {1e-3, 0.1, 10.0})
            for (const double gap : {1e-9, 1e-7, 1e-5, 1e-3, 0.3}) {
                camera.fov = fov;
                camera.near = near;
                camera.far = 2000;
                ball.scale.setScalar(100);
                ball.rotation.x = std::acos(0.0);  // a pole towards the camera
                ball.position.set(0, 0, -(2000 + 100 * (1 + 3e-9) + gap));
                cube.scale.setScalar(near / 5);
                cube.position.set(0, 0, -(near - near / 5 * std::sqrt(0.75) - gap * near * 1e-2));
                SCOPED_TRACE(testing::Message() << "fov " << fov << ", near " << near << ", gap " << gap);
                bothWays();
            }
}

TEST_F(SkippedMeshes, LightsOfBlackOnes) {
    green.color = THREE::Color(0x000000);
    green.emissive = THREE::Color(0x112233);
    bulb({2, 3, 2}, 3, 1);
    bulb({-2, 2, 2}, 3, 2);
    const BothWays both = bothWays();
    EXPECT_TRUE(both.tells(box, "it is black"));
    EXPECT_EQ(both.skipped.stats.pairsSkipped, 3);
    EXPECT_EQ(both.whole.stats.pairsSkipped, 0);
    const lighting::Variant& black = drawOf(both.skipped.plan, box).variant;
    EXPECT_EQ(black.point() + black.directional, 0);
    EXPECT_FALSE(black.ambient);
    EXPECT_EQ(drawOf(both.skipped.plan, floor).variant.point(), 2);
    options.settings.terms = TermSet::all().without(Term::albedo);
    EXPECT_FALSE(bothWays().tells(box, "it is black")) << "with D = 1 it is white";
}

TEST_F(SkippedMeshes, BlackOnesThatShineKeepTheirLights) {
    orange.color = THREE::Color(0x000000);
    EXPECT_TRUE(bothWays().tells(knot, "it is black"));
    orange.specular.set(0x808080);
    const BothWays shiny = bothWays();
    EXPECT_FALSE(shiny.tells(knot, "it is black"));
    EXPECT_EQ(drawOf(shiny.skipped.plan, knot).variant.directional, 1);
    orange.specular.set(0x000000);
    orange.specularModel = THREE::SpecularModel::blinn;
    EXPECT_FALSE(bothWays().tells(knot, "it is black")) << "Fresnel's factor shines at grazing angles";
    options.settings.terms = TermSet::all().without(Term::specular);
    EXPECT_TRUE(bothWays().tells(knot, "it is black"));
    options.settings.terms = TermSet::all();
    options.settings.specular = THREE::SpecularModel::phong;
    EXPECT_TRUE(bothWays().tells(knot, "it is black"));
}

TEST_F(SkippedMeshes, UnlitOnesHaveNoEquation) {
    THREE::MeshBasicMaterial basic(THREE::Color(0xFF8855));
    THREE::Mesh unlit(boxGeometry, basic);
    unlit.position.set(2, 1, 1);
    scene.add(unlit);
    bulb({2, 3, 2}, 3, 1.5);
    for (int i = 0; i < 3; ++i)
        bulb({-2, 2.0 + i, 2}, 3, 2);
    const BothWays both = bothWays();
    const lighting::Variant& v = drawOf(both.skipped.plan, unlit).variant;
    EXPECT_FALSE(v.lit);
    EXPECT_EQ(v.point() + v.directional, 0);
    EXPECT_EQ(v.terms, 0U);
    EXPECT_STREQ(render::shaderFiles(v).fragment, "unlit.frag");
}

// Solids seen from outside, in any pose: their back faces are never the nearest.
TEST_F(SkippedMeshes, HiddenFacesOfClosedOnes) {
    all.remove(knot);
    THREE::BoxGeometry cube(1, 1.5, 0.7, 2, 3, 1);
    THREE::SphereGeometry ball(1, 24, 12), half(1, 12, 8, 0, 2 * std::numbers::pi, 0, 1);
    THREE::CylinderGeometry can(0.5, 1, 1.5, 12, 3), cone(0, 1, 1.5, 12, 2), pipe(1, 1, 1.5, 12, 1, true);
    THREE::TorusGeometry ring(0.9, 0.35, 16, 32), spindle(0.5, 0.7, 16, 32);
    THREE::TorusKnotGeometry tube(0.7, 0.22, 120, 12);
    green.side = THREE::DoubleSide;
    const struct {
        const char* name;
        THREE::BufferGeometry& geometry;
        bool closed;
    } shapes[] = {{"box", cube, true},     {"sphere", ball, true}, {"half a sphere", half, false},
                  {"cylinder", can, true}, {"cone", cone, true},   {"open cylinder", pipe, false},
                  {"torus", ring, true},   {"knot", tube, true},   {"torus through itself", spindle, false}};
    for (const auto& shape : shapes)
        for (int pose = 0; pose < 6; ++pose) {
            SCOPED_TRACE(testing::Message() << shape.name << ", pose " << pose);
            THREE::Mesh mesh(shape.geometry, green);
            all.add(mesh);
            mesh.position.set(0.1 * pose, 1.6, 0);
            mesh.rotation.set(0.7 * pose, 0.4 * pose, 0.3);
            mesh.scale.set(pose % 2 == 0 ? 1 : -0.8, 1 + 0.2 * pose, pose == 3 ? 0.2 : 1.1);
            const BothWays both = bothWays();
            EXPECT_EQ(both.tells(mesh, "back faces are hidden"), shape.closed);
            const lighting::Draw& draw = drawOf(both.skipped.plan, mesh);
            EXPECT_EQ(draw.side, shape.closed ? THREE::FrontSide : THREE::DoubleSide);
            EXPECT_EQ(draw.variant.doubleSided, !shape.closed);
            EXPECT_EQ(both.skipped.stats.sidesSkipped, shape.closed ? 2 : 1) << "the stage's box is one";
            EXPECT_EQ(drawOf(both.whole.plan, mesh).side, THREE::DoubleSide);
            EXPECT_EQ(both.whole.stats.sidesSkipped, 0);
        }
}

TEST_F(SkippedMeshes, FacesOfClosedOnesThatAreSeenFromInside) {
    green.side = THREE::DoubleSide;
    box.rotation.set(0, 0, 0);
    box.position.set(0, 1.25, 0);
    box.scale.set(8, 4, 32);  // around the camera
    EXPECT_FALSE(bothWays().tells(box, "back faces are hidden"));
    box.scale.set(2, 1, 10);
    box.position.set(2, 2.5, -0.1);  // its front face between the eye and the near plane
    camera.near = 4;
    EXPECT_FALSE(bothWays().tells(box, "back faces are hidden"));
    box.scale.set(1, 1, 1);
    box.position.set(-2, 1.2, 0.5);
    camera.near = 0.1;
    EXPECT_TRUE(bothWays().tells(box, "back faces are hidden"));
    for (std::size_t i = 0; i + 2 < boxGeometry.index.size(); i += 3)
        std::swap(boxGeometry.index[i], boxGeometry.index[i + 1]);
    boxGeometry.needsUpdate();
    EXPECT_FALSE(bothWays().tells(box, "back faces are hidden")) << "inside out";
}

// Scales that are as good as nothing in one direction, or so small that the product of the three leaves the range of doubles.
TEST_F(SkippedMeshes, FlattenedAndTinyClosedOnes) {
    all.remove(floor);
    green.side = THREE::DoubleSide;
    THREE::SphereGeometry ballGeometry(0.7, 24, 12);
    THREE::Mesh ball(ballGeometry, green);
    all.add(ball);
    box.position.set(-1, 1.2, 1.5);
    ball.position.set(1.2, 1.2, 1.5);
    for (const double flat : {0.0, 1e-300, 1e-30, 1e-9, 1e-7, 1e-5, 1e-3})
        for (const double sign : {1.0, -1.0}) {
            SCOPED_TRACE(testing::Message() << "scale " << sign * flat);
            box.scale.set(1, 1, sign * flat);
            ball.scale.set(1, 1, sign * flat);
            for (const double z : {6.0, -6.0}) {
                eye.z = z;
                bothWays();
            }
        }
    for (const double tiny : {1e-100, 1e-115}) {
        SCOPED_TRACE(testing::Message() << "size " << tiny);
        eye.z = 6;
        box.scale.set(-1, 1, 1);
        ball.scale.set(-1, 1, 1);
        all.scale.setScalar(tiny);
        camera.near = 0.1 * tiny;
        camera.far = 100 * tiny;
        const BothWays both = bothWays();
        EXPECT_TRUE(drawOf(both.skipped.plan, ball).mirrored);
    }
}

TEST_F(SkippedMeshes, FrontToBack) {
    std::vector<std::unique_ptr<THREE::Mesh>> row;
    for (int i = 0; i < 6; ++i) {
        row.push_back(std::make_unique<THREE::Mesh>(boxGeometry, green));
        row.back()->position.set(0.3 * i, 1 + 0.2 * i, -8 + 1.5 * i);  // added back to front
        all.add(*row.back());
    }
    const BothWays both = bothWays();
    for (std::size_t i = 1; i < both.skipped.plan.draws.size(); ++i)
        EXPECT_LE(both.skipped.plan.draws[i - 1].nearestDepth, both.skipped.plan.draws[i].nearestDepth);
    EXPECT_EQ(both.whole.plan.draws[0].mesh, &knot) << "the scene's own order";
    EXPECT_EQ(both.whole.plan.draws[3].mesh, row[0].get());
}

TEST_F(SkippedMeshes, NothingIsUploadedTwice) {
    bulb({2, 3, 2}, 3, 1);
    bulb({-2, 2, 2}, 3, 2);
    place();
    support::makeReady(scene, camera, options);
    const auto fresh = support::freshRenderer();
    const auto bytes = [&] {
        scene.updateMatrixWorld();
        fresh->render(scene, camera, options.settings, {60, 52, false});
        return fresh->stats().uploadedBytes;
    };
    EXPECT_GT(bytes(), knotGeometry.vertexCount() * 24);
    EXPECT_EQ(bytes(), 0U);
    camera.position.x += 0.1;
    EXPECT_EQ(bytes(), 0U) << "the camera is no data of the scene";
    options.settings.skip = false;
    const std::uint64_t all_ = bytes();
    EXPECT_GT(all_, knotGeometry.vertexCount() * 24);
    EXPECT_EQ(bytes(), all_) << "--no-skip sends everything again";
    options.settings.skip = true;
    options.settings.constantLights = 0;
    EXPECT_LE(bytes(), 2 * (3 * 48 + 12))
        << "three lights of three vec4 and the ambient one, for each of two shaders";
    EXPECT_EQ(bytes(), 0U);
    bulbs[0]->intensity = 2;
    const std::uint64_t lights = bytes();
    EXPECT_GT(lights, 0U);
    EXPECT_LE(lights, 2 * 3 * 48);
    ambient.intensity = 0.5;
    EXPECT_EQ(bytes(), 12U) << "the three meshes have one shader";
    boxGeometry.attributes.at("position").array[0] += 0.1;
    boxGeometry.needsUpdate();
    const std::uint64_t changed = bytes();
    EXPECT_GT(changed, 0U);
    EXPECT_LT(changed, 24 * 24 + 36 * 4 + 1) << "the box alone";
}

// Which lights have a sum of their own must not depend on meshes that are not in view.
TEST_F(SkippedMeshes, SumsOfMeshesOutOfView) {
    std::vector<std::unique_ptr<THREE::Mesh>> outside;
    bulb({2, 3, 2}, 0.7, 0);
    for (int i = 0; i < 12; ++i) {
        bulb({-4.0 + 0.7 * i, 0.5 + 0.2 * i, 2}, 0.3, 0, i % 2 == 0 ? 0 : 9);
        bulb({100.0 + 10 * i, 0, 40}, 1, 0, 6);
        outside.push_back(std::make_unique<THREE::Mesh>(boxGeometry, green));
        outside.back()->position.set(100 + 10 * i, 0, 40);
        all.add(*outside.back());
    }
    const BothWays both = bothWays();
    EXPECT_EQ(both.skipped.stats.meshesSkipped, 12);
}

}  // namespace
