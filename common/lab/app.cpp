// App: decides between window and frame, and turns every failure into a message and a status.
// SPDX-License-Identifier: MIT
#include "lab/app.hpp"

#include "lab/failure.hpp"
#include "lab/frame_batch.hpp"
#include "lab/live/live.hpp"
#include "lab/live/state_file.hpp"
#include "lab/scene_files.hpp"
#include "lab/stills.hpp"
#include "lab/view.hpp"
#include "lab/window.hpp"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <utility>

namespace lab {

namespace {

// Near and far for an eye of the user's choice: nothing of the scene is cut off.
void reachEverything(THREE::PerspectiveCamera& camera, const THREE::Sphere& bounds,
                     const CameraOption& wanted) {
    const THREE::Vector3 eye(wanted.position[0], wanted.position[1], wanted.position[2]);
    camera.far = std::max(camera.far, 2 * (eye.distanceTo(bounds.center) + bounds.radius));
    camera.near = std::min(camera.near, camera.far * 1e-5);
}

void openFile(const Options& options, THREE::LoadedScene& loaded) {
    loaded = loadScene(options.sceneFile);
    for (const std::string& note : loaded.notes)
        std::cerr << options.lesson << ": " << note << '\n';
}

// The camera of a scene file, or one that brings all of it into view.
void aim(THREE::PerspectiveCamera& camera, const THREE::LoadedScene& loaded, const Options& options) {
    loaded.scene->updateMatrixWorld();
    if (loaded.camera != nullptr) {
        return takeCamera(camera, *loaded.camera);
    }
    camera.aspect =
        options.width && options.height ? static_cast<double>(*options.width) / *options.height : 1;
    bringIntoView(camera, *loaded.scene);
    if (options.camera)
        reachEverything(camera, worldBounds(*loaded.scene), *options.camera);
}

// The window, or the picture that takes its place.
void showOne(View& view, Options& options, Renderers& renderers, Phases& phases, Handover& handover) {
    if (options.wantsWindow()) {
        std::string reason;
        if (handover.window == nullptr)
            handover.window =
                openWindow(options.width.value_or(960), options.height.value_or(600), options.lesson, reason);
        if (handover.window != nullptr) {
            std::signal(SIGPIPE, SIG_IGN);  // the lecture goes on when whoever read the answers has gone
            return runLive(view, options, handover);
        }
        options.frame = options.lesson + ".png";
        std::cout << options.lesson << say({": nessuno schermo (", ": no display ("}, options.language)
                  << reason << say({"), scrivo l'immagine ", "), writing the frame "}, options.language)
                  << options.frame << std::endl;
    }
    drawStill(view, options, renderers, phases);
}

// Programs that are run in the window of the first, one after the other, until one of them does not name another.
int runFollowers(Handover& handover) {
    int status = done;
    while (!handover.program.empty()) {
        const std::string program = std::exchange(handover.program, {});
        status = runProgram(program, std::exchange(handover.arguments, {}), handover);
    }
    return status;
}

// Loading the program and its libraries takes processor time and little else, and that clock is exact.
Phases sinceProcessStart() {
    timespec used{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
    Phases phases;
    phases.add("load", static_cast<double>(used.tv_sec) * 1e3 + static_cast<double>(used.tv_nsec) / 1e6);
    return phases;
}

int tell(const Failure& failure, const Options& options) {
    std::cout.flush();
    std::cerr << options.lesson << ": " << messageOf(failure, options.sceneFile) << std::endl;
    return failure.status;
}

}  // namespace

App::App(int argc, char** argv, const std::string& lesson)
    : phases_(sinceProcessStart()), options_(readOptions(argc, argv, lesson, lesson == "scene_viewer")) {
    phases_.mark("options");
}

int App::present(const WithView& withView) {
    Handover* const first = std::exchange(lambertHandover, nullptr);
    if (first != nullptr &&
        first->guest) {  // another lesson shows this one's scene; what is thrown is that one's affair
        withView(options_, first->guest);
        return done;
    }
    Renderers renderers;  // never destroyed: the driver's own clean-up would cost a tenth of a whole frame
    Handover own;
    Handover& handover = first != nullptr ? *first : own;
    int status = done;
    std::optional<Failure> failure = attempt([&] {
        if (!options_.framesFrom.empty()) {
            status = drawFrames(options_, controls_, withView, renderers, phases_);
            return;
        }
        if (const std::string wrong = controls_.set(options_.set); !wrong.empty())
            throw UsageError(wrong);
        takeStateSize(options_);
        withView(options_, [&](View& view) { showOne(view, options_, renderers, phases_, handover); });
    });
    if (!failure && first == nullptr)
        failure = attempt([&] { status = handover.program.empty() ? status : runFollowers(handover); });
    if (failure)
        status = tell(*failure, options_);
    if (first != nullptr)
        return status;
    handover.window.reset();  // before the process goes, and its libraries with it
    if (!flushOutput(options_.lesson) && status == done)
        status = cannotWrite;
    std::fflush(nullptr);
    std::_Exit(status);
}

int App::run(THREE::Scene& scene, THREE::PerspectiveCamera& camera, const Animation& animation) {
    std::optional<THREE::Vector3> middle;
    if (!options_.framesFrom.empty()) {  // before the first frame's animation moves anything
        scene.updateMatrixWorld();
        middle = worldBounds(scene).center;
    }
    return present([&](const Options& options, const std::function<void(View&)>& use) {
        View view(scene, camera, animation, options, controls_, middle);
        use(view);
    });
}

int App::runFile() {
    THREE::LoadedScene loaded;
    if (const std::optional<Failure> failure = attempt([&] { openFile(options_, loaded); }))
        return tell(*failure, options_);
    const Animation none;
    return present([&](const Options& options, const std::function<void(View&)>& use) {
        THREE::PerspectiveCamera camera(40);
        aim(camera, loaded, options);
        View view(*loaded.scene, camera, none, options, controls_);
        use(view);
    });
}

}  // namespace lab
