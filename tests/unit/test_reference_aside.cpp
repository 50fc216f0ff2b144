// The reference on its own thread: the same frames, given up at once, its failures kept.
// SPDX-License-Identifier: MIT
#include "lab/live/reference_aside.hpp"
#include "render/reference_renderer.hpp"
#include "three/three.hpp"

#include <chrono>
#include <condition_variable>
#include <ctime>
#include <deque>
#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <mutex>
#include <thread>

namespace {

using lab::ReferenceAside;
using namespace std::chrono_literals;

struct Stage {
    THREE::Scene scene;
    THREE::PerspectiveCamera camera{50, 1, 0.1, 100};
    THREE::TorusKnotGeometry shape{0.9, 0.34, 60, 12};
    THREE::MeshLambertMaterial material{THREE::Color(0xFF8855)};
    THREE::Mesh knot{shape, material};
    THREE::DirectionalLight sun;
    Stage() {
        sun.position.set(0, 3, 2);
        scene.add(knot, sun);
        camera.position.set(0, 0.5, 4);
        camera.lookAt(0, 0, 0);
        scene.updateMatrixWorld();
        camera.updateWorldMatrix();
    }
    image::Frame expected(const render::FrameRequest& request) {
        return render::ReferenceRenderer().render(scene, camera, lighting::Settings(), request);
    }
};

// Waits as a window does: asleep until it is woken.
class Window {
  public:
    std::function<void()> wake() {
        return [this] {
            {
                const std::lock_guard lock(mutex_);
                ++calls_;
            }
            woken_.notify_all();
        };
    }
    std::optional<image::Frame> wait(ReferenceAside& aside) {
        for (int seen = 0; seen < 100000;) {
            if (auto frame = aside.take())
                return frame;
            std::unique_lock lock(mutex_);
            if (!woken_.wait_for(lock, 60s, [&] { return calls_ > seen; }))
                return std::nullopt;
            seen = calls_;
        }
        return std::nullopt;
    }
    int calls() {
        const std::lock_guard lock(mutex_);
        return calls_;
    }

  private:
    std::mutex mutex_;
    std::condition_variable woken_;
    int calls_ = 0;
};

TEST(ReferenceAside, DrawsTheSameFrame) {
    Stage s;
    const render::FrameRequest request{80, 60, false};
    Window window;
    ReferenceAside aside(window.wake());
    EXPECT_FALSE(aside.busy());
    EXPECT_FALSE(aside.take());
    aside.ask(s.scene, s.camera, {}, request);
    const auto frame = window.wait(aside);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->pixels, s.expected(request).pixels);
    EXPECT_EQ(aside.share(), 1);
    EXPECT_FALSE(aside.busy());
    EXPECT_FALSE(aside.take()) << "once";
    EXPECT_GT(window.calls(), 2) << "it tells how far it is";
    aside.ask(s.scene, s.camera, {}, {80, 60, true});
    EXPECT_EQ(window.wait(aside)->pixels, s.expected({80, 60, true}).pixels);
}

TEST(ReferenceAside, TheSceneMayChangeAndGoMeanwhile) {
    auto s = std::make_unique<Stage>();
    const render::FrameRequest request{300, 300, false};
    const image::Frame expected = s->expected(request);
    Window window;
    ReferenceAside aside(window.wake());
    aside.ask(s->scene, s->camera, {}, request);
    s->material.color.set(0.0, 0.0, 0.0);
    s->material.side = THREE::BackSide;
    s->sun.intensity = 9;
    s->knot.position.x = 5;
    s->shape.attributes["position"].array.clear();
    s.reset();
    const auto frame = window.wait(aside);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->pixels, expected.pixels);
}

TEST(ReferenceAside, ANewQuestionReplacesTheOldOne) {
    Stage s;
    Window window;
    ReferenceAside aside(window.wake());
    for (int i = 0; i < 30; ++i) {
        aside.ask(s.scene, s.camera, {}, {2000, 2000, false});
        EXPECT_TRUE(aside.busy());
        EXPECT_LT(aside.share(), 1);
    }
    aside.ask(s.scene, s.camera, {}, {20, 10, false});
    const auto frame = window.wait(aside);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->width, 20);
    EXPECT_EQ(frame->pixels, s.expected({20, 10, false}).pixels);
}

TEST(ReferenceAside, GivenUpNothingComes) {
    Stage s;
    Window window;
    ReferenceAside aside(window.wake());
    aside.ask(s.scene, s.camera, {}, {40, 40, false});
    EXPECT_TRUE(window.wait(aside));
    aside.ask(s.scene, s.camera, {}, {40, 40, false});
    while (aside.busy())
        std::this_thread::sleep_for(1ms);
    aside.cancel();
    EXPECT_FALSE(aside.take()) << "finished, but forgotten";
    aside.ask(s.scene, s.camera, {}, {4000, 4000, false});
    aside.cancel();
    EXPECT_FALSE(aside.busy());
    EXPECT_EQ(aside.share(), 0);
    std::this_thread::sleep_for(30ms);
    EXPECT_FALSE(aside.take());
}

TEST(ReferenceAside, ItsEndDoesNotWaitForTheFrame) {
    Stage s;
    std::deque<THREE::PointLight> lights;
    for (int i = 0; i < 1000; ++i)
        s.scene.add(lights.emplace_back());
    s.scene.updateMatrixWorld();
    const render::FrameRequest request{600, 600, false};
    std::clock_t start = std::clock();  // of all threads
    s.expected(request);
    const std::clock_t whole = std::clock() - start;
    start = std::clock();
    for (int i = 0; i < 3; ++i) {
        ReferenceAside aside;
        aside.ask(s.scene, s.camera, {}, request);
        std::this_thread::sleep_for(5ms);
    }
    EXPECT_LT(std::clock() - start, whole) << "three that are given up against one";
}

TEST(ReferenceAside, FailuresAreTold) {
    Stage s;
    s.sun.color.r = std::numeric_limits<double>::quiet_NaN();  // not validated: codes cannot be had of it
    Window window;
    ReferenceAside aside(window.wake());
    aside.ask(s.scene, s.camera, {}, {40, 40, false});
    EXPECT_THROW(window.wait(aside), image::Error);
    EXPECT_FALSE(aside.take()) << "once";
    s.sun.color.r = 1;
    aside.ask(s.scene, s.camera, {}, {40, 40, false});
    EXPECT_TRUE(window.wait(aside));
}

}  // namespace
