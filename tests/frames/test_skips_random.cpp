// Random scenes, drawn with their skips and without, and with their lights in constants, uniforms and a texture: the same bytes.
// A failing one prints the seed that makes it again (RC_PARAMS, RapidCheck's documentation) and shrinks the scene.
// SPDX-License-Identifier: MIT
#include "support/both_ways.hpp"
#include "support/random_lab.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace {

using support::RandomLab;

void expectNoDifference(const support::Frames& a, const support::Frames& b) {
    const std::string where = support::difference(a, b);
    RC_LOG() << '\n' << where;
    RC_ASSERT(where.empty());
}

void checkSkips(RandomLab& lab) {
    support::makeReady(lab.scene, lab.camera, lab.options);
    RC_LOG() << lab.text();
    lab.options.settings.skip = true;
    const support::Frames skipped = support::drawFrames(lab.scene, lab.camera, lab.options);
    lab.options.settings.skip = false;
    const support::Frames whole = support::drawFrames(
        support::withFacesAndOrderOf(skipped.plan,
                                     lighting::planFrame(lab.scene, lab.camera, lab.options.settings)),
        lab.options);
    RC_CLASSIFY(!skipped.plan.skipped.empty(), "something is skipped");
    RC_CLASSIFY(skipped.stats.pairsSkipped > 0, "lights end before meshes");
    RC_CLASSIFY(skipped.plan.sidesSkipped > 0, "back faces are hidden");
    RC_CLASSIFY(skipped.stats.clusters > 0, "clusters");
    expectNoDifference(skipped, whole);
}

RC_GTEST_PROP(Skips, ChangeNoByte, ()) {
    RandomLab lab({});
    checkSkips(lab);
}

RC_GTEST_PROP(Skips, ChangeNoByteOfManyMeshes, ()) {
    RandomLab lab({.lights = 10, .meshes = 25});
    checkSkips(lab);
}

RC_GTEST_PROP(Skips, ChangeNoByteOfClusters, ()) {
    RandomLab lab({.lights = 120});
    lab.options.settings.uniformLights = 0;
    lab.options.settings.shading = lighting::Shading::pixel;
    checkSkips(lab);
}

RC_GTEST_PROP(Storage, ChangesNoByte, ()) {
    const bool ending = support::chance(50);
    RandomLab lab({.ending = ending,
                   .endless = !ending});  // clusters put those that end last: another order, another rounding
    support::makeReady(lab.scene, lab.camera, lab.options);
    RC_LOG() << lab.text();
    lighting::Settings& s = lab.options.settings;
    s.constantLights = 64;
    const auto fresh = support::freshRenderer();
    const support::Frames constants =
        support::drawFrames(lighting::planFrame(lab.scene, lab.camera, s), lab.options, *fresh);
    s.constantLights = 0;
    const support::Frames uniforms = support::drawFrames(lab.scene, lab.camera, lab.options);
    s.uniformLights = 0;
    const support::Frames texture = support::drawFrames(lab.scene, lab.camera, lab.options);
    expectNoDifference(constants, uniforms);
    expectNoDifference(uniforms, texture);
}

}  // namespace
