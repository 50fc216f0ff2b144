// scene_viewer: any three.js scene, with the lessons' window, keys and options
//
// Takes a file that `scene.toJSON()` or the three.js editor wrote, or a Wavefront .obj.
// Its first camera is used; without one, the whole scene is brought into view.
//
// SPDX-License-Identifier: MIT
#include "lab/lab.hpp"

int main(int argc, char** argv) {
    lab::App app(argc, argv, "scene_viewer");
    return app.runFile();
}
