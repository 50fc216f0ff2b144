// Sliders and readings: steps of round numbers, --set, and what a frame knows of them.
// SPDX-License-Identifier: MIT
#include "lab/controls.hpp"
#include "lab/live/control.hpp"
#include "lab/options.hpp"
#include "lab/stats.hpp"
#include "lab/view.hpp"
#include "three/three.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace {

using lab::Controls;
using Assignments = std::vector<std::string>;

std::string set(Controls& controls, const Assignments& assignments) { return controls.set(assignments); }

// A slider as the table of controls has it.
struct Stepped {
    lab::Slider& slider;
    lab::ControlTable table;
    lab::Control& control;

    explicit Stepped(lab::Slider& s)
        : slider(s), control(table.addNumber("slider", "", {}, s.min, s.max, s.value, s.own)) {
        control.step = s.step();
    }
    void move(int steps) { table.set(control, control.next(steps)); }
};

TEST(Slider, MovesByRoundStepsAndStaysInItsRange) {
    Controls controls;
    const double& share = controls.add("share", 0.57, 0, 1, {"", ""});
    Stepped slider(controls.sliders().back());
    slider.move(1);
    EXPECT_EQ(share, 0.58) << "the very double of these digits";
    for (int i = 0; i < 7; ++i)
        slider.move(-1);
    EXPECT_EQ(share, 0.51);
    slider.move(10);
    EXPECT_EQ(share, 0.61);
    slider.move(100);
    EXPECT_EQ(share, 1);
    slider.move(-1000);
    EXPECT_EQ(share, 0);
}

TEST(Slider, FindsTheGridFromWhereverItStands) {
    Controls controls;
    const double& alpha = controls.add("alpha", 41.3, 0, 180, {"", ""});  // steps of 2
    Stepped slider(controls.sliders().back());
    slider.move(1);
    EXPECT_EQ(alpha, 42);
    slider.move(-2);
    EXPECT_EQ(alpha, 38);
    const double& phi = controls.add("phi", -180, -180, 180, {"", ""});  // steps of 5
    Stepped(controls.sliders().back()).move(3);
    EXPECT_EQ(phi, -165);
    const double& tiny = controls.add("tiny", 0, -1e-9, 1e-9, {"", ""});
    Stepped(controls.sliders().back()).move(1);
    EXPECT_EQ(tiny, 2e-11);
    EXPECT_EQ(alpha, 38) << "references stay good when sliders are added";
}

TEST(Controls, SetPutsSlidersAndResetBringsThemBackThere) {
    Controls controls;
    const double& a = controls.add("a", 1, 0, 2, {"", ""});
    const double& b = controls.add("b", -3, -4, 4, {"", ""});
    EXPECT_EQ(set(controls, {"a=0.25", "b=+2e0", "a=2"}), "");
    EXPECT_EQ(a, 2) << "the last one counts";
    EXPECT_EQ(b, 2);
    EXPECT_EQ(controls.text(), "a=2 b=2");
    controls.sliders()[0].value = 0.5;
    controls.reset();
    EXPECT_EQ(a, 2);
}

TEST(Controls, SetSaysWhatThereIs) {
    Controls controls;
    EXPECT_NE(set(controls, {"a=1"}).find("no sliders"), std::string::npos);
    controls.add("alpha", 40, 0, 180, {"", ""});
    controls.add("k", 0.5, 0, 1, {"", ""});
    for (const char* wrong : {"beta=1", "alpha", "alpha=", "=1", "", "alpha=x", "alpha=1x", "alpha=nan",
                              "alpha=inf", "alpha=180.001", "alpha=-1e-300", "k=1e999", "alpha =1"}) {
        const std::string message = set(controls, {wrong});
        EXPECT_EQ(message, "--set: expected NAME=VALUE with one of alpha (0 to 180), k (0 to 1), found '" +
                               std::string(wrong) + "'");
    }
    EXPECT_EQ(controls.text(), "alpha=40 k=0.5") << "nothing was changed";
}

TEST(Controls, RefusesSlidersThatMakeNoSense) {
    Controls controls;
    controls.add("a", 1, 0, 2, {"", ""});
    for (const auto& [name, start, min, max] : {std::tuple{"a", 1.0, 0.0, 2.0},
                                                {"", 1.0, 0.0, 2.0},
                                                {"b=c", 1.0, 0.0, 2.0},
                                                {"b", 3.0, 0.0, 2.0},
                                                {"b", 0.0, 0.0, 0.0},
                                                {"b", 1.0, 2.0, 0.0},
                                                {"b", 0.0, -1e308, 1e308},
                                                {"b", std::nan(""), 0.0, 2.0}})
        EXPECT_THROW(controls.add(name, start, min, max, {"", ""}), std::invalid_argument)
            << name << min << max;
    EXPECT_EQ(controls.sliders().size(), 1U);
}

TEST(Controls, ValuesReadWell) {
    for (const auto& [value, text] : {std::pair{0.0, "0"},
                                      {-0.0, "0"},
                                      {42.0, "42"},
                                      {-3.0, "-3"},
                                      {100000.0, "100000"},
                                      {0.5, "0.5"},
                                      {2.0 / 3, "0.6667"},
                                      {-0.001234567, "-0.001235"},
                                      {1e-9, "1e-09"}})
        EXPECT_EQ(lab::valueText(value), text);
}

TEST(Options, CollectsEverySetAsItStands) {
    const Assignments arguments{"--set", "alpha=60", "--size", "20x10", "--set=k=1", "--set", "", "--stats"};
    const auto parsed = lab::parseOptions(arguments, "lesson", false);
    ASSERT_TRUE(std::holds_alternative<lab::Options>(parsed)) << std::get<lab::Ending>(parsed).err;
    EXPECT_EQ(std::get<lab::Options>(parsed).set, (Assignments{"alpha=60", "k=1", ""}));
    EXPECT_TRUE(std::get<lab::Options>(parsed).stats);
    EXPECT_EQ(std::get<lab::Ending>(lab::parseOptions(Assignments{"--set"}, "lesson", false)).status, 2);
}

TEST(View, ReadsSlidersAndShowsEachReadingOncePerFrame) {
    THREE::Scene scene;
    THREE::PerspectiveCamera camera;
    const lab::Options options;
    Controls controls;
    const double& height = controls.add("height", 2, 0, 4, {"", ""});
    THREE::PointLight lamp;
    scene.add(lamp);
    const lab::Animation animation = [&](double t) {
        lamp.position.y = height + t;
        controls.readings.push_back({{"altezza", "height"}, lamp.position.y});
    };
    lab::View view(scene, camera, animation, options, controls);
    view.update(0, 10, 10);
    controls.sliders()[0].value = 2.5;
    view.update(1, 10, 10);
    EXPECT_EQ(lamp.position.y, 2.5 + 1);
    ASSERT_EQ(controls.readings.size(), 1U);
    EXPECT_EQ(controls.readings[0].value, 3.5);

    lab::StatsReport report;
    report.controls = controls;
    const auto json = nlohmann::json::parse(lab::statsJson(report, {}));
    EXPECT_EQ(json["sliders"], nlohmann::json({{"height", 2.5}}));
    EXPECT_EQ(json["readings"], nlohmann::json::array({{{"what", "height"}, {"value", 3.5}}}));
}

}  // namespace
