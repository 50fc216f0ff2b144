// What the lab does with a scene before it is drawn: orbit, jitter, bringing into view, the equation's text.
// SPDX-License-Identifier: MIT
#include "lab/equation.hpp"
#include "lab/jitter.hpp"
#include "lab/orbit.hpp"
#include "lab/stats.hpp"
#include "lab/view.hpp"
#include "three/three.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace {

using lighting::Term;
using lighting::TermSet;
using THREE::Vector3;

void expectNear(const Vector3& found, const Vector3& expected, double bound = 1e-12) {
    EXPECT_NEAR(found.x, expected.x, bound);
    EXPECT_NEAR(found.y, expected.y, bound);
    EXPECT_NEAR(found.z, expected.z, bound);
}

TEST(Orbit, TurnsAboutTheTargetAsTheMouseMoves) {
    THREE::PerspectiveCamera camera;
    camera.position.set(1, 2, 8);
    lab::Orbit orbit(camera, {1, 2, 3});
    orbit.rotate(0.25, 0);  // a quarter of a circle to the right: the camera goes left
    expectNear(camera.position, {-4, 2, 3});
    orbit.rotate(0, 0.25);  // the mouse down: the camera up
    EXPECT_GT(camera.position.y, 2 + 3);
    EXPECT_NEAR(orbit.distance(), 5, 1e-12);
    orbit.rotate(0, 10);  // never over the pole
    expectNear(camera.position, {1, 7, 3}, 1e-2);
    orbit.place({1, 2, 8}, {1, 2, 3});
    expectNear(camera.position, {1, 2, 8}, 0);
}

TEST(Orbit, GoesOnAfterADragAndComesToRest) {
    THREE::PerspectiveCamera camera;
    camera.position.set(1, 2, 8);
    lab::Orbit orbit(camera, {1, 2, 3});
    EXPECT_FALSE(orbit.coast(0.02));
    orbit.fling(0.5, 0, false);
    EXPECT_TRUE(orbit.coast(0.02));
    const double x = camera.position.x;
    EXPECT_LT(x, 1);
    int frames = 0;
    while (orbit.coast(0.02) && frames < 1000)
        ++frames;
    EXPECT_GT(frames, 5);
    EXPECT_LT(frames, 100) << "two seconds";
    EXPECT_LT(camera.position.x, x);
    EXPECT_NEAR(orbit.distance(), 5, 1e-12);
    EXPECT_FALSE(orbit.coast(0.02));
    orbit.fling(0.5, 0, true);
    orbit.stop();
    EXPECT_FALSE(orbit.coast(0.02));
}

TEST(Orbit, ZoomsWithinBoundsAndPans) {
    THREE::PerspectiveCamera camera(90, 1, 0.1, 100);
    camera.position.set(0, 0, 10);
    lab::Orbit orbit(camera, {});
    orbit.zoom(1);
    EXPECT_NEAR(camera.position.z, 9.5, 1e-12);
    orbit.zoom(1e9);
    EXPECT_GT(orbit.distance(), 0.1);
    orbit.zoom(-1e9);
    EXPECT_LT(orbit.distance(), 100);
    orbit.place({0, 0, 10}, {});
    orbit.pan(0.5, 0);  // half the height at 90 degrees: 10 units at distance 10
    expectNear(orbit.target(), {-10, 0, 0});
    expectNear(camera.position, {-10, 0, 10});
}

TEST(Orbit, NeverJumpsWhereTheSceneIsNearFarOrNear) {
    THREE::PerspectiveCamera camera(50, 1, 3, 5);
    camera.position.set(0, 0, 4);
    lab::Orbit orbit(camera, {});
    orbit.zoom(-1);
    EXPECT_NEAR(orbit.distance(), 4, 1e-12)
        << "far is 5: farther than half of that it was already, but no nearer";
    orbit.zoom(1);
    EXPECT_NEAR(orbit.distance(), 3.8, 1e-12);
}

TEST(Orbit, TurnsAboutTheCamerasOwnUp) {
    THREE::PerspectiveCamera camera;
    camera.up.set(0, 0, 1);
    camera.position.set(5, 0, 2);
    camera.lookAt(0, 0, 0);
    lab::Orbit orbit(camera, {});
    orbit.rotate(0.25, 0);
    EXPECT_NEAR(camera.position.z, 2, 1e-12) << "a drag sideways keeps the height";
    EXPECT_NEAR(camera.position.x, 0, 1e-12);
    EXPECT_NEAR(camera.position.y, -5, 1e-12);
}

TEST(View, ADragIsNotLostWithJitter) {
    THREE::Scene scene;
    THREE::BoxGeometry box;
    THREE::Mesh mesh(box);
    scene.add(mesh);
    THREE::PerspectiveCamera camera;
    camera.position.z = 5;
    lab::Options options;
    options.jitter = 5;
    const lab::Animation still;
    lab::Controls controls;
    lab::View view(scene, camera, still, options, controls);
    view.update(0, 64, 64);
    const Vector3 before = camera.position;
    view.orbit().rotate(0.1, 0);
    view.update(0, 64, 64);
    EXPECT_GT(Vector3(camera.position).sub(before).length(), 1);
}

TEST(Jitter, MovesALittleTheSameEachTimeAndBackAgain) {
    THREE::Scene scene;
    THREE::BoxGeometry box;
    THREE::Mesh mesh(box);
    THREE::PointLight light;
    light.position.set(2, 1.5, 5);
    scene.add(mesh, light);
    THREE::PerspectiveCamera camera;
    camera.position.set(0, 1, 5);
    std::vector<Vector3> places[3];
    for (const auto& [run, seed] : {std::pair{0, 7U}, std::pair{1, 7U}, std::pair{2, 8U}}) {
        lab::Jitter jitter(seed);
        jitter.apply(scene, camera, {});
        places[run] = {mesh.position, light.position, camera.position};
        EXPECT_NE(mesh.quaternion.w, 1);
        jitter.undo();
        expectNear(mesh.position, {}, 0);
        expectNear(light.position, {2, 1.5, 5}, 0);
        EXPECT_EQ(mesh.quaternion.w, 1);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        expectNear(places[0][i], places[1][i], 0);
        EXPECT_FALSE(places[0][i] == places[2][i]);
    }
    EXPECT_LT(Vector3(places[0][1]).sub({2, 1.5, 5}).length(), 1);
    EXPECT_GT(Vector3(places[0][1]).sub({2, 1.5, 5}).length(), 1e-3);
}

// A grader gives the same seed to a student's scene and to its own.
TEST(Jitter, IsTheSameWhateverTheOrderAndHoweverLongADirectionIs) {
    THREE::BoxGeometry box;
    const auto places = [&box](bool reversed, double length) {
        THREE::Scene scene;
        THREE::Mesh one(box), two(box);
        one.position.set(1, 2, 3);
        two.position.set(-3, 0, 1);
        THREE::DirectionalLight sun;
        sun.position.set(0, 3 * length, -2 * length);
        THREE::PointLight bulb;
        bulb.position.set(2, 1.5, 5);
        std::vector<THREE::Object3D*> all{&one, &two, &sun, &bulb};
        if (reversed)
            std::reverse(all.begin(), all.end());
        for (THREE::Object3D* object : all)
            scene.add(*object);
        THREE::PerspectiveCamera camera;
        camera.position.set(0, 1, 5);
        lab::Jitter(7).apply(scene, camera, {});
        return std::vector<Vector3>{one.position, two.position, sun.position.multiplyScalar(1 / length),
                                    bulb.position};
    };
    const auto expected = places(false, 1), found = places(true, 4);
    for (std::size_t i = 0; i < expected.size(); ++i)
        expectNear(found[i], expected[i], 1e-14);
}

// However a student puts a mesh or a light where it belongs, it is the same scene.
TEST(Jitter, IsTheSameBelowGroupsOrWithAMatrixByHand) {
    THREE::BoxGeometry box;
    const auto worlds = [&box](int way) {
        THREE::Scene scene;
        THREE::Mesh mesh(box);
        THREE::PointLight bulb;
        THREE::DirectionalLight sun;
        mesh.position.set(1, 2, 3);
        mesh.rotation.set(0.5, 0.3, 0.2);
        bulb.position.set(2, 1.5, 5);
        sun.position.set(0, 3, -2);
        THREE::Group group;
        if (way == 1) {  // the group has the place, its children the rest
            group.position.set(1, 1, 1);
            group.rotation.y = 1;
            group.scale.set(2, 2, 2);
            group.updateMatrix();
            for (THREE::Object3D* object :
                 {static_cast<THREE::Object3D*>(&mesh), static_cast<THREE::Object3D*>(&bulb)}) {
                object->updateMatrix();
                object->applyMatrix4(THREE::Matrix4(group.matrix).invert());
                group.add(*object);
            }
            sun.position.set(1, 4, 0);
            sun.target.position.set(1, 1, 2);
        } else if (way == 2) {
            mesh.updateMatrix();
            mesh.matrixAutoUpdate = false;
            mesh.position.set(0, 0, 0);
        }
        if (way != 1)
            scene.add(mesh, bulb);
        scene.add(sun, group);
        THREE::PerspectiveCamera camera;
        camera.position.set(0, 1, 5);
        lab::Jitter jitter(7);
        jitter.apply(scene, camera, {});
        scene.updateMatrixWorld();
        std::vector<Vector3> points;
        for (const Vector3& point : {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0)})
            points.push_back(mesh.matrixWorld.applyTo(point));
        points.push_back(bulb.getWorldPosition());
        points.push_back(sun.getWorldPosition().sub(sun.target.getWorldPosition()));
        jitter.undo();
        EXPECT_EQ(mesh.matrixAutoUpdate, way != 2);
        return points;
    };
    const auto plain = worlds(0);
    for (const int way : {1, 2}) {
        const auto found = worlds(way);
        for (std::size_t i = 0; i < plain.size(); ++i)
            expectNear(found[i], plain[i]);
    }
}

// An animation writes one angle and keeps the others: these must not come back from the quaternion, rounded.
TEST(Jitter, LeavesTheAnglesThatWereWritten) {
    THREE::Scene scene;
    THREE::BoxGeometry box;
    THREE::Mesh mesh(box);
    scene.add(mesh);
    THREE::PerspectiveCamera camera;
    camera.position.set(0, 1, 5);
    for (int i = 0; i < 20; ++i) {
        mesh.rotation.set(0.1 * i, 0.3, 0.07 * i);
        lab::Jitter jitter(7);
        jitter.apply(scene, camera, {});
        jitter.undo();
        expectNear({mesh.rotation.x, mesh.rotation.y, mesh.rotation.z}, {0.1 * i, 0.3, 0.07 * i}, 0);
    }
}

TEST(View, LeavesEverythingAsItFoundIt) {
    THREE::Scene scene;
    THREE::BoxGeometry box;
    THREE::Mesh mesh(box);
    THREE::PointLight light(0xFFFFFF, 1, 0, 2);
    scene.add(mesh, light);
    THREE::PerspectiveCamera camera(40);
    camera.position.z = 5;
    const lab::Animation still;
    lab::Controls controls;
    lab::Options options;
    options.camera = lab::CameraOption{{1, 2, 3}, {0, 0, 0}, 20};
    options.jitter = 5;
    options.decay = 1;
    {
        lab::View view(scene, camera, still, options, controls);
        view.update(0, 64, 32);
        EXPECT_EQ(camera.fov, 20);
        EXPECT_EQ(camera.aspect, 2);
        EXPECT_EQ(light.decay, 1);
        EXPECT_NE(mesh.position.x, 0);
    }
    EXPECT_EQ(camera.fov, 40);
    EXPECT_EQ(camera.aspect, 1);
    EXPECT_EQ(light.decay, 2);
    expectNear(mesh.position, {}, 0);
    expectNear(camera.position, {0, 0, 5}, 0);
    EXPECT_EQ(camera.rotation.x, 0);
}

TEST(View, BringsAnySceneIntoView) {
    for (const auto& [size, aspect] :
         {std::pair{1e-6, 1.0}, {1.0, 1.0}, {1e6, 1.0}, {1.0, 0.1}, {1.0, 10.0}}) {
        THREE::Scene scene;
        THREE::SphereGeometry geometry(size);
        THREE::Mesh ball(geometry);
        ball.position.set(100 * size, -30 * size, 7 * size);
        scene.add(ball);
        scene.updateMatrixWorld();
        THREE::PerspectiveCamera camera(40, aspect);
        lab::bringIntoView(camera, scene);
        camera.updateWorldMatrix();
        const glm::dmat4 toClip = camera.projectionMatrix().elements * camera.matrixWorldInverse().elements;
        for (const double side : {-1.0, 0.0, 1.0}) {
            const glm::dvec4 clip =
                toClip * glm::dvec4((100 + side) * size, (-30 + side * side) * size, 7 * size, 1);
            for (int i = 0; i < 3; ++i)
                EXPECT_LT(std::abs(clip[i]), clip.w);
        }
    }
    const THREE::Scene empty;
    EXPECT_EQ(lab::worldBounds(empty).radius, 0);
}

TEST(Equation, SaysWhatIsLeft) {
    EXPECT_EQ(lab::equationText(TermSet::all(), false), "P = Σ max(0, n·ω) f(d) D ⊗ L + D ⊗ L_A");
    EXPECT_EQ(lab::equationText(TermSet::none(), false), "P = 0");
    EXPECT_EQ(lab::equationText(TermSet::all().without(Term::clamp).without(Term::ambient), false),
              "P = Σ (n·ω) f(d) D ⊗ L");
    EXPECT_EQ(lab::equationText(TermSet::all().without(Term::albedo).without(Term::point), false),
              "P = Σdir max(0, n·ω) f(d) 1 ⊗ L + 1 ⊗ L_A");
}

TEST(Equation, ItsSymbolsFollowTheTerms) {
    THREE::Scene scene;
    THREE::BoxGeometry box;
    THREE::MeshLambertMaterial material(THREE::Color(0xFF8855));
    THREE::Mesh mesh(box, material);
    THREE::DirectionalLight sun;
    scene.add(mesh, sun);
    THREE::PerspectiveCamera camera;
    camera.position.z = 5;
    scene.updateMatrixWorld();
    camera.updateWorldMatrix();
    const lighting::FramePlan plan = lighting::planFrame(scene, camera, {});
    const auto stateOf = [&plan](Term term, TermSet on) {
        for (const lab::Symbol& symbol : lab::equation(on, plan))
            if (symbol.term == term)
                return symbol.state;
        return lab::SymbolState::plain;
    };
    EXPECT_EQ(stateOf(Term::cosine, TermSet::all()), lab::SymbolState::active);
    EXPECT_EQ(stateOf(Term::cosine, TermSet::all().without(Term::cosine)), lab::SymbolState::off);
    EXPECT_EQ(stateOf(Term::ambient, TermSet::all()), lab::SymbolState::idle);
}

TEST(Stats, TheClockOfTheProcessRuns) {
    const double first = lab::millisecondsSinceProcessStart();
    EXPECT_GT(first, -20);
    EXPECT_LT(first, 600'000);
    EXPECT_GE(lab::millisecondsSinceProcessStart(), first);
}

}  // namespace
