// App: decides between window and frame, and turns every failure into a message and a status.
// SPDX-License-Identifier: MIT
#include "lab/app.hpp"

#include "image/frame.hpp"
#include "lab/live.hpp"
#include "lab/stills.hpp"
#include "lab/view.hpp"
#include "lab/window.hpp"
#include "render/error.hpp"
#include "three/object_loader.hpp"
#include "three/validate.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <new>

namespace lab {

namespace {

enum Status { done = 0, wrongUsage = 2, noRenderer = 3, unusableScene = 4, cannotWrite = 5 };

// Runs `work`; whatever goes wrong becomes one message and the status that the command line promises.
template <class Work>
int guarded(const std::string& who, const Work& work) {
    const auto failed = [&who](const std::string& message, Status status) {
        std::cout.flush();
        std::cerr << who << ": " << message << std::endl;
        return status;
    };
    try {
        work();
        return flushOutput(who) ? done : cannotWrite;
    } catch (const render::NoRenderer& error) {
        return failed(error.what(), noRenderer);
    } catch (const render::ShaderError& error) {
        return failed(error.what(), noRenderer);
    } catch (const THREE::SceneError& error) {
        return failed(error.what(), unusableScene);
    } catch (const image::Error& error) {
        return failed(error.what(), cannotWrite);
    } catch (const std::bad_alloc&) {
        return failed("not enough memory for this scene at this size; choose a smaller --size", noRenderer);
    } catch (const std::exception& error) {
        return failed(error.what(), unusableScene);
    }
}

// Near and far for an eye of the user's choice: nothing of the scene is cut off.
void reachEverything(THREE::PerspectiveCamera& camera, const THREE::Sphere& bounds,
                     const CameraOption& wanted) {
    const THREE::Vector3 eye(wanted.position[0], wanted.position[1], wanted.position[2]);
    camera.far = std::max(camera.far, 2 * (eye.distanceTo(bounds.center) + bounds.radius));
    camera.near = std::min(camera.near, camera.far * 1e-5);
}

void present(View& view, Options& options) {
    if (options.wantsWindow()) {
        std::string reason;
        const std::unique_ptr<Window> window =
            openWindow(options.width.value_or(960), options.height.value_or(600), options.lesson, reason);
        if (window != nullptr)
            return runLive(view, *window, options);
        options.frame = options.lesson + ".png";
        std::cout << options.lesson << say({": nessuno schermo (", ": no display ("}, options.language)
                  << reason << say({"), scrivo l'immagine ", "), writing the frame "}, options.language)
                  << options.frame << std::endl;
    }
    runStills(view, options);
}

}  // namespace

App::App(int argc, char** argv, const std::string& lesson)
    : options_(readOptions(argc, argv, lesson, lesson == "scene_viewer")) {}

int App::run(THREE::Scene& scene, THREE::PerspectiveCamera& camera, const Animation& animation) {
    // What is wrong with a scene file is said with its name.
    const std::string who = options_.lesson + (options_.sceneFile.empty() ? "" : ": " + options_.sceneFile);
    if (const std::string wrong = controls_.set(options_.set); !wrong.empty()) {
        std::cerr << options_.lesson << ": " << wrong << '\n';
        return wrongUsage;
    }
    const int status = guarded(who, [&] {
        View view(scene, camera, animation, options_, controls_);
        present(view, options_);
    });
    // All is written; the driver's own clean-up would only cost time, a tenth of a whole frame.
    std::cout.flush();
    std::fflush(nullptr);
    std::_Exit(status);
}

int App::runFile() {
    THREE::LoadedScene loaded;
    const int status = guarded(options_.lesson, [&] {
        loaded = THREE::ObjectLoader().load(options_.sceneFile);
        for (const std::string& note : loaded.notes)
            std::cerr << options_.lesson << ": " << note << '\n';
        loaded.scene->updateMatrixWorld();
        // Before its size is measured; a camera that sees as far as anything may be.
        THREE::validate(*loaded.scene, THREE::PerspectiveCamera(50, 1, 1e30, 1e36));
    });
    if (status != done)
        return status;
    // A camera of its own, in world space, so that it can be turned whatever it hangs on in the file.
    THREE::PerspectiveCamera camera(40);
    if (loaded.camera != nullptr) {
        camera.fov = loaded.camera->fov;
        camera.near = loaded.camera->near;
        camera.far = loaded.camera->far;
        camera.zoom = loaded.camera->zoom;
        camera.up = loaded.camera->up;
        camera.applyMatrix4(loaded.camera->matrixWorld);
    } else {
        camera.aspect =
            options_.width && options_.height ? static_cast<double>(*options_.width) / *options_.height : 1;
        bringIntoView(camera, *loaded.scene);
        if (options_.camera)
            reachEverything(camera, worldBounds(*loaded.scene), *options_.camera);
    }
    return run(*loaded.scene, camera);
}

}  // namespace lab
