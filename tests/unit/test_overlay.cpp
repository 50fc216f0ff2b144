// What is drawn over the picture: places against the camera's own matrices, clipping, and arrows at the
// probed point.
// SPDX-License-Identifier: MIT
#include "lab/live/overlay.hpp"
#include "support/probed.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <random>

namespace {

using lab::Ink;
using lab::Overlay;
using lab::PanelPoint;
using lab::PanelStroke;
using lab::Projection;
using support::Floor;

THREE::PerspectiveCamera& placed(THREE::PerspectiveCamera& camera) {
    camera.position.set(1, 2, 5);
    camera.lookAt(0.5, 0, -1);
    camera.zoom = 1.25;
    camera.updateWorldMatrix();
    return camera;
}

const PanelStroke* arrowOf(const Overlay& overlay, Ink ink) {
    const auto found = std::find_if(overlay.strokes.begin(), overlay.strokes.end(),
                                    [ink](const PanelStroke& s) { return s.arrow && s.ink == ink; });
    return found == overlay.strokes.end() ? nullptr : &*found;
}

bool hasTag(const Overlay& overlay, const std::string& text) {
    return std::any_of(overlay.tags.begin(), overlay.tags.end(),
                       [&text](const lab::PanelTag& tag) { return tag.text == text; });
}

TEST(Projection, IsTheCamerasProjectionMatrix) {
    THREE::PerspectiveCamera camera(50, 1.5, 0.1, 100);
    const Projection projection(placed(camera));
    std::mt19937 random(1);
    std::uniform_real_distribution<double> any(-3, 3);
    int before = 0;
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 p(any(random), any(random), any(random) + 3);
        const glm::dvec4 clip =
            camera.projectionMatrix().elements * camera.matrixWorldInverse().elements * glm::dvec4(p, 1);
        const auto found = projection.point(p);
        ASSERT_EQ(found.has_value(), clip.w >= camera.near);
        if (!found)
            continue;
        ++before;
        EXPECT_NEAR(found->x, 0.5 + 0.5 * clip.x / clip.w, 1e-9 * (1 + std::abs(found->x)));
        EXPECT_NEAR(found->y, 0.5 - 0.5 * clip.y / clip.w, 1e-9 * (1 + std::abs(found->y)));
        // and back
        const glm::dvec3 again = projection.world(projection.ray(*found) * clip.w);
        EXPECT_NEAR(glm::length(again - p), 0, 1e-9);
    }
    EXPECT_GT(before, 100);
    EXPECT_LT(before, 200);
}

TEST(Projection, LinesEndAtTheNearPlaneAndBesideThePicture) {
    THREE::PerspectiveCamera camera(90, 1, 0.5, 100);
    camera.updateWorldMatrix();
    const Projection projection(camera);
    // From depth 2 on the axis to behind the eye, half a unit to the right at the near plane's depth.
    const auto cut = projection.stroke({0, 0, -2}, {2.0 / 3 * 2, 0, 2}, Ink::light, true);
    ASSERT_TRUE(cut);
    EXPECT_NEAR(cut->from.x, 0.5, 1e-12);
    EXPECT_NEAR(cut->to.x, 0.5 + 0.5 * (2.0 / 3 * 2 * 1.5 / 4) / 0.5, 1e-12) << "where z = -0.5";
    EXPECT_FALSE(cut->arrow) << "its head is behind the camera";
    EXPECT_FALSE(projection.stroke({0, 0, 1}, {0, 0, 2}, Ink::light));
    EXPECT_FALSE(projection.stroke({50, 0, -1}, {90, 0, -1}, Ink::light)) << "far beside the picture";
    const auto wide = projection.stroke({-1e6, 0, -1}, {1e6, 0, -1}, Ink::light, true);
    ASSERT_TRUE(wide);
    EXPECT_NEAR(wide->from.x, -1, 1e-6);
    EXPECT_NEAR(wide->to.x, 2, 1e-6);
    const auto whole = projection.stroke({0, 0, -2}, {1, 1, -2}, Ink::light, true);
    ASSERT_TRUE(whole);
    EXPECT_TRUE(whole->arrow);
    EXPECT_NEAR(whole->to.x, 0.75, 1e-12);
    EXPECT_NEAR(whole->to.y, 0.25, 1e-12);
}

TEST(Projection, NothingButFiniteNumbers) {
    std::mt19937 random(3);
    const double odd[] = {0, -0.0, 1, -1, 1e-300, 1e36, -1e36, 0.1, -3, 1e-9};
    const auto any = [&] { return odd[random() % 10]; };
    for (int i = 0; i < 5000; ++i) {
        THREE::PerspectiveCamera camera(i % 2 == 0 ? 179.9 : 0.01, 1e-3, 1e-9, 1e9);
        camera.position.set(any(), any(), any());
        camera.scale.set(1, i % 7 == 0 ? 0 : 1, 1);
        camera.updateWorldMatrix();
        const Projection projection(camera);
        if (const auto s = projection.stroke({any(), any(), any()}, {any(), any(), any()}, Ink::text)) {
            for (const double x : {s->from.x, s->from.y, s->to.x, s->to.y})
                ASSERT_TRUE(x >= -1 && x <= 2) << x;
        }
        if (const auto p = projection.point({any(), any(), any()})) {
            ASSERT_TRUE(std::isfinite(p->x) && std::isfinite(p->y));
        }
    }
}

TEST(Overlay, NormalAndLightsStartInThePoint) {
    Floor f;
    const Overlay overlay = lab::pointOverlay(f.middle(), f.camera, {1});
    const PanelStroke* const n = arrowOf(overlay, Ink::normal);
    ASSERT_NE(n, nullptr);
    EXPECT_NEAR(n->from.x, 0.5, 1e-9);
    EXPECT_NEAR(n->from.y, 0.5, 1e-9);
    EXPECT_NEAR(n->to.x, 0.5, 1e-9) << "straight up";
    EXPECT_LT(n->to.y, 0.45);
    for (const char* tag : {"n", "ω₁", "ω₂"})
        EXPECT_TRUE(hasTag(overlay, tag)) << tag;
    EXPECT_TRUE(hasTag(overlay, "33.7°")) << "acos(3 / sqrt(13))";
    EXPECT_FALSE(hasTag(overlay, "v")) << "nothing shines";
    const PanelStroke* const chosen = arrowOf(overlay, Ink::light);
    ASSERT_NE(chosen, nullptr);
    EXPECT_GT(chosen->width, 3);
}

TEST(Overlay, ArrowsHaveTheSameSizeFromAfar) {
    Floor f;
    const auto height = [&f](double away) {
        f.camera.position.set(0, 0.001 * away, away);
        f.camera.lookAt(0, 0, 0);
        f.see();
        const lab::SurfacePoint middle{&f.floor, 0, {0, 0.5, 0.5}};
        const Overlay overlay = lab::pointOverlay(*f.prober.at(middle), f.camera);
        return arrowOf(overlay, Ink::normal)->from.y - arrowOf(overlay, Ink::normal)->to.y;
    };
    EXPECT_NEAR(height(3), lab::OverlayOptions().length, 1e-3);
    EXPECT_NEAR(height(30), height(3), 1e-3);
}

TEST(Overlay, WhatShinesHasItsMirrorAndTheEye) {
    Floor f;
    f.paint.specular = THREE::Color(1, 1, 1);
    f.bulb.position.set(2, -1.5, 5);
    const Overlay overlay = lab::pointOverlay(f.middle(), f.camera, {2});
    EXPECT_TRUE(hasTag(overlay, "R₁"));
    EXPECT_FALSE(hasTag(overlay, "R₂")) << "light from behind is not mirrored";
    EXPECT_TRUE(hasTag(overlay, "v"));
    EXPECT_NE(arrowOf(overlay, Ink::faint), nullptr) << "light 2 is behind";
    EXPECT_TRUE(hasTag(overlay, "105.6°")) << "acos(-1.5 / sqrt(31.25))";
    const glm::dvec3 w = glm::normalize(glm::dvec3(0, 3, -2));
    const glm::dvec3 R = lab::mirrored({0, 1, 0}, w);
    EXPECT_NEAR(glm::length(R - glm::normalize(glm::dvec3(0, 3, 2))), 0, 1e-15);
    EXPECT_NEAR(lab::degreesBetween(w, w), 0, 1e-6);
    EXPECT_NEAR(lab::degreesBetween(w, -w), 180, 1e-6);
}

TEST(Overlay, HiddenIsFaintAndNothingIsNothing) {
    Floor f;
    lab::ProbeReport r = f.middle();
    r.sight = lighting::reference::Sight::hidden;
    for (const PanelStroke& stroke : lab::pointOverlay(r, f.camera).strokes)
        EXPECT_EQ(stroke.ink, Ink::faint);
    f.camera.position.set(0, 2, -3);  // the point is behind the camera
    f.camera.lookAt(0, 2, -9);
    f.see();
    EXPECT_TRUE(lab::pointOverlay(r, f.camera).strokes.empty());
    f.scene.remove(f.floor);
    EXPECT_TRUE(lab::pointOverlay(f.middle(), f.camera).strokes.empty()) << "the background";
}

TEST(Overlay, LightInThePointAndNoNormalDrawNothingOdd) {
    Floor f;
    f.bulb.position.set(0, 0, 0);
    f.sheet.setAttribute("normal", std::vector<double>(12, 0), 3);
    f.see();
    for (const int chosen : {1, 2, 3, 99}) {
        const Overlay overlay = lab::pointOverlay(*f.prober.at(lab::SurfacePoint{&f.floor, 0, {0, 0.5, 0.5}}),
                                                  f.camera, {chosen, true});
        EXPECT_FALSE(hasTag(overlay, "n"));
        for (const PanelStroke& s : overlay.strokes)
            EXPECT_TRUE(std::isfinite(s.from.x + s.from.y + s.to.x + s.to.y));
    }
}

}  // namespace
