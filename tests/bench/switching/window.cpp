// A window without its window: planning, drawPicture() until the picture is there, and prepare() in between.
// SPDX-License-Identifier: MIT
#include "bench/switching/window.hpp"

#include "bench/scenes.hpp"
#include "lighting/views.hpp"
#include "render/shader_source.hpp"
#include "three/validate.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <ctime>
#include <deque>
#include <mutex>
#include <thread>

namespace bench {

namespace {

constexpr int size = 512;

double threadMilliseconds() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) / 1e6;
}

// A scene like a lesson's, a base colour with a highlight, and lights.
struct Lesson : Stage {
    THREE::TorusKnotGeometry knot{0.9, 0.34, 400, 64};
    THREE::PlaneGeometry square{8, 8};
    THREE::MeshPhongMaterial orange{THREE::Color(0xFF8855)};
    THREE::MeshLambertMaterial blue{THREE::Color(0x7788AA)};
    std::string name;
    lighting::Settings settings;

    Lesson(std::string called, int ring, lighting::Shading shading) : name(std::move(called)) {
        mesh(knot, orange);
        mesh(square, blue).position.z = -2;
        lectureLights();
        point({-3, 2, 1}, 6, 0, 2);
        lightsAround(ring);
        settings.shading = shading;
    }
};

class Window {
  public:
    explicit Window(Lesson& lesson)
        : renderer_(render::findShaderDirectory(""), render::Compile::aside), lesson_(lesson) {
        renderer_.onCompiled([this] {
            const std::lock_guard lock(mutex_);
            compiled_ = true;
            changed_.notify_one();
        });
    }

    // Shows the scene as it is now, and tells what that took.
    void show(const std::string& group, const std::string& what, const lighting::Settings& settings) {
        using Clock = std::chrono::steady_clock;
        const Clock::time_point start = Clock::now();
        const double cpu = threadMilliseconds();
        const lighting::FramePlan plan = planned(settings);
        const render::Part whole{&plan, &settings, 0, size};
        while (!renderer_.drawPicture({&whole, 1}, size, size)) {
            std::unique_lock lock(mutex_);  // as a loop that waits for events
            changed_.wait_for(lock, std::chrono::milliseconds(100), [this] { return compiled_; });
            compiled_ = false;
        }
        renderer_.finishDrawing();
        const double took = threadMilliseconds() - cpu;
        const double wall = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
        if (group.empty())
            return;
        std::printf("%s, CPU\t%s: %s\t%.4f\n", group.c_str(), lesson_.name.c_str(), what.c_str(), took);
        std::printf("%s, until shown\t%s: %s\t%.4f\n", group.c_str(), lesson_.name.c_str(), what.c_str(),
                    wall);
    }

    // As a window that has nothing to do: what a key may want next.
    void prepareNeighbours(const lighting::Settings& settings) {
        for (const lighting::TermInfo& row : lighting::terms()) {
            lighting::Settings next = settings;
            next.terms = settings.terms.toggled(row.term);
            renderer_.prepare(planned(next));
        }
        renderer_.finishCompiling();
        std::this_thread::sleep_for(std::chrono::milliseconds(50));  // nobody is quicker at the keys
    }

    void rest() { renderer_.finishCompiling(); }

  private:
    lighting::FramePlan planned(const lighting::Settings& settings) {
        lesson_.camera.aspect = 1;
        lesson_.scene.updateMatrixWorld();
        lesson_.camera.updateWorldMatrix();
        THREE::validate(lesson_.scene, lesson_.camera);
        return lighting::planFrame(lesson_.scene, lesson_.camera, settings);
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    bool compiled_ = false;
    render::GlRenderer renderer_;
    Lesson& lesson_;
};

struct Amount {
    std::size_t firsts, seconds;
    int frames;
};
Amount amountOf(const std::string& text) {
    const std::size_t all = lighting::terms().size();
    return text == "--smoke"   ? Amount{1, 1, 4}
           : text == "--quick" ? Amount{all, 2, 20}
                               : Amount{all, all, 60};
}

// From all symbols on: each one off, from there each other one off, and back.
void toggle(Lesson& lesson, bool prepared, const Amount& amount) {
    Window window(lesson);
    lighting::Settings settings = lesson.settings;
    const auto& terms = lighting::terms();
    const std::string how = prepared ? ", prepared" : ", not prepared";
    const auto to = [&](const std::string& group, const std::string& what, const lighting::TermSet& set) {
        settings.terms = set;
        window.show(group, what, settings);
        if (prepared)
            window.prepareNeighbours(settings);
    };
    to("", "", lighting::TermSet::all());
    for (std::size_t i = 0; i < amount.firsts; ++i) {
        const std::string name = terms[i].name;
        const lighting::TermSet one = lighting::TermSet::all().without(terms[i].term);
        to("toggle" + how, name + " off", one);
        for (std::size_t j = i + 1; j < std::min(i + 1 + amount.seconds, terms.size()); ++j) {
            to("toggle" + how, name + " off then " + terms[j].name + " off", one.without(terms[j].term));
            to("back", std::string(terms[j].name) + " on, " + name + " off", one);
        }
        to("back", name + " on", lighting::TermSet::all());
    }
}

void chooseViews(Lesson& lesson, const Amount& amount) {
    Window window(lesson);
    lighting::Settings settings = lesson.settings;
    window.show("", "", settings);
    for (const lighting::ViewInfo& row : lighting::views()) {
        if (static_cast<std::size_t>(row.view) > amount.firsts * 2)
            continue;
        settings.view = row.view;
        window.show("choose a view, not prepared", row.name, settings);
        settings.view = lighting::ViewMode::final;
        window.show("back", row.name, settings);
    }
}

// A light that comes, is dragged, and goes.
void changeLights(Lesson& lesson, const Amount& amount) {
    Window window(lesson);
    window.show("", "", lesson.settings);
    for (int turn = 0; turn < 2; ++turn) {
        THREE::PointLight& light = lesson.point({1, 2, 3}, 1, 0, 2);
        window.show("add a light, not prepared", turn == 0 ? "first" : "again", lesson.settings);
        const auto drag = [&](const std::string& what, const auto& change) {
            for (int frame = 0; frame < amount.frames; ++frame) {
                change(0.01 * frame);
                window.show("drag a light", what + ", frame " + std::to_string(frame), lesson.settings);
            }
        };
        drag("position", [&light](double t) { light.position.set(1 + t, 2 - t, 3); });
        drag("intensity", [&light](double t) { light.intensity = 1 + t; });
        drag("colour", [&light](double t) { light.color.setRGB(1, t, 0.5); });
        window.rest();
        light.visible = false;
        window.show("back", "the light is gone", lesson.settings);
    }
}

}  // namespace

void changes(const std::string& amount, bool prepared) {
    const Amount a = amountOf(amount);
    std::deque<Lesson> lessons;
    lessons.emplace_back("the lecture's lights", 0, lighting::Shading::pixel);
    if (amount != "--smoke") {
        lessons.emplace_back("a ring of 12 more", 12, lighting::Shading::pixel);
        lessons.emplace_back("per vertex", 0, lighting::Shading::vertex);
    }
    for (Lesson& lesson : lessons) {
        toggle(lesson, prepared, a);
        if (prepared)
            continue;
        chooseViews(lesson, a);
        changeLights(lesson, a);
    }
}

}  // namespace bench
