// A session without a window: its sides, its neighbours, its pin, and the panel that is built of it.
// SPDX-License-Identifier: MIT
#include "lab/failure.hpp"
#include "lab/live/neighbours.hpp"
#include "lab/live/panel_builder.hpp"
#include "lab/live/pin.hpp"
#include "lab/live/programs.hpp"
#include "lab/live/side_prober.hpp"
#include "support/desk.hpp"

#include <gtest/gtest.h>
#include <set>

namespace {

using lighting::Term;
using lighting::ViewMode;
using support::Desk;

TEST(Session, HasOneSideOrTwo) {
    Desk desk;
    desk.begin();
    ASSERT_EQ(desk.session->sides(100, nullptr).size(), 1U);
    desk.say("term cosine off");
    desk.say("split term");
    desk.say("divider 0.3");
    const std::vector<lab::Side> sides = desk.session->sides(100, nullptr);
    ASSERT_EQ(sides.size(), 2U);
    EXPECT_EQ(sides[0].endColumn, 30);
    EXPECT_EQ(sides[1].firstColumn, 30);
    EXPECT_FALSE(sides[0].settings.terms.has(Term::cosine));
    EXPECT_TRUE(sides[1].settings.terms.has(Term::cosine)) << "although it is off now";
    EXPECT_TRUE(sides[0].settings.terms.has(Term::albedo));
    desk.say("divider 0");
    ASSERT_EQ(desk.session->sides(100, nullptr).size(), 1U);
    EXPECT_EQ(desk.session->sides(100, nullptr)[0].endColumn, 100);
    desk.say("split lesson");
    EXPECT_EQ(desk.session->sides(100, nullptr).size(), 1U) << "as long as that lesson is not there";
}

TEST(Session, ViewsOfAFactorAreOfTheChosenLightOrOfOneThatHasIt) {
    Desk desk;
    desk.begin();
    EXPECT_EQ(desk.session->settings().only, nullptr);
    desk.say("view attenuation");
    EXPECT_EQ(desk.session->settings().only, &desk.bulb) << "the sun has no distance";
    desk.say("view w");
    EXPECT_EQ(desk.session->settings().only, &desk.sun);
    desk.say("choose 2");
    EXPECT_EQ(desk.session->settings().only, &desk.bulb);
    desk.say("choose 3");
    EXPECT_EQ(desk.session->settings().only, &desk.sun) << "ambient light has no direction";
    desk.say("only 2");
    EXPECT_EQ(desk.session->settings().only, &desk.bulb);
}

TEST(Session, FollowsAnAnimationThatAddsAndRemovesLights) {
    Desk desk;
    std::optional<THREE::PointLight> flash;
    desk.begin();
    desk.animation = [&](double t) {
        if (t > 1 && !flash)
            desk.scene.add(flash.emplace(0x00FF00));
        if (t > 2)
            flash.reset();
    };
    desk.say("time 1.5");
    EXPECT_EQ(desk.say("light 4 color"), "ok light 4 color 0x00FF00");
    EXPECT_EQ(desk.say("light 4 color red"), "ok light 4 color 0xFF0000");
    desk.say("only 4");
    desk.say("time 2.5");
    EXPECT_EQ(desk.session->lights().size(), 3U);
    EXPECT_EQ(desk.session->only, 3);
    EXPECT_EQ(desk.say("light 4 color").substr(0, 5), "error");
    EXPECT_EQ(desk.say("light 3 off"), "ok light 3 on off");
}

TEST(Neighbours, AreOneStepAwayAndLeaveTheSceneAsItWas) {
    Desk desk;
    desk.begin();
    const lab::State before = desk.session->state();
    const std::size_t objects = desk.scene.children().size();
    std::set<unsigned> terms;
    std::set<ViewMode> views;
    std::set<int> lights;
    std::size_t count = 0;
    for (std::optional<lighting::FramePlan> plan; (plan = lab::neighbourPlan(*desk.session, count));
         ++count) {
        ASSERT_FALSE(plan->draws.empty());
        terms.insert(plan->draws[0].variant.terms);
        views.insert(plan->view);
        lights.insert(plan->lightsUsed);
    }
    EXPECT_GE(count, 9U + 4U + 3U + 3U + lighting::viewCount);
    EXPECT_GE(terms.size(), 8U) << "each symbol that counts here, switched";
    EXPECT_EQ(views.size(), static_cast<std::size_t>(lighting::viewCount));
    EXPECT_TRUE(lights.contains(2)) << "one light less";
    EXPECT_TRUE(lights.contains(4)) << "one light more";
    EXPECT_EQ(desk.scene.children().size(), objects);
    EXPECT_EQ(desk.session->state(), before);
    EXPECT_TRUE(desk.sun.visible && desk.bulb.visible && desk.sky.visible);
}

TEST(Neighbours, OfLargeScenesAreNotPlanned) {
    Desk desk;
    std::deque<THREE::Mesh> many;
    for (int i = 0; i < 1200; ++i)
        desk.scene.add(many.emplace_back(desk.box, desk.material));
    desk.begin();
    EXPECT_FALSE(lab::neighbourPlan(*desk.session, 0).has_value());
}

TEST(Pin, ReadsBackAndRefusesWhatIsNotThere) {
    Desk desk;
    desk.begin();
    const lab::SurfacePoint point{&desk.mesh, 5, {0.1, 0.2, 0.7}};
    const std::string text = lab::pinText(point, desk.scene);
    EXPECT_EQ(text, "1,5,0.1,0.2,0.7");
    const std::optional<lab::SurfacePoint> again = lab::readPin(text, desk.scene);
    ASSERT_TRUE(again.has_value());
    EXPECT_EQ(again->mesh, &desk.mesh);
    EXPECT_EQ(again->triangle, 5U);
    EXPECT_EQ(again->weights.y, 0.2);
    EXPECT_FALSE(lab::readPin("none", desk.scene).has_value());
    for (const char* wrong : {"", "1", "0,0,1,0,0", "2,0,1,0,0", "1,12,1,0,0", "1,0.5,1,0,0", "1,-1,1,0,0",
                              "1,0,1,1,0", "a,b,c,d,e"})
        EXPECT_THROW(lab::readPin(wrong, desk.scene), lab::UsageError) << wrong;
    const THREE::Mesh elsewhere(desk.box, desk.material);
    EXPECT_EQ(lab::pinText(lab::SurfacePoint{&elsewhere, 0, {1, 0, 0}}, desk.scene), "none");
}

lab::Panel panelOf(Desk& desk, lab::PanelFacts facts = {}) { return lab::buildPanel(*desk.session, facts); }

TEST(Panel, TheEquationHasEachSymbolWithItsKeySlideAndCommand) {
    Desk desk;
    desk.begin();
    desk.say("term albedo off");
    const lab::Panel panel = panelOf(desk);
    std::set<std::string> keys;
    for (const lab::PanelSymbol& symbol : panel.equation) {
        if (symbol.command.empty())
            continue;
        if (!symbol.key.empty()) {
            EXPECT_TRUE(keys.insert(symbol.key).second) << symbol.text;
        }
        EXPECT_EQ(symbol.tone == lab::Tone::off, symbol.command == "term albedo toggle") << symbol.text;
        EXPECT_NE(symbol.help.find("off: "), std::string::npos) << symbol.text;
        EXPECT_EQ(desk.say(symbol.command).substr(0, 3), "ok ");
        desk.say(symbol.command);
    }
    EXPECT_EQ(keys, (std::set<std::string>{"1", "2", "3", "4", "5", "6", "7", "8", "9"}));
    const auto attenuation = std::find_if(panel.equation.begin(), panel.equation.end(),
                                          [](const lab::PanelSymbol& symbol) { return symbol.key == "5"; });
    EXPECT_EQ(attenuation->tone, lab::Tone::idle);
    EXPECT_NE(attenuation->help.find("k = 0"), std::string::npos) << attenuation->help;
}

TEST(Panel, EveryControlWithAGroupIsAWidgetInBothLanguages) {
    Desk desk;
    desk.begin();
    std::set<std::string> expected;
    for (const lab::Control& control : desk.session->table.all())
        if (!control.group.empty())
            expected.insert(control.name);
    std::set<std::string> labels[2];
    for (const int language : {0, 1}) {
        desk.say(language == 0 ? "language it" : "language en");
        std::set<std::string> found;
        for (const lab::WidgetGroup& group : panelOf(desk).groups)
            for (const lab::Widget& widget : group.widgets) {
                labels[language].insert(widget.label);
                const std::set<std::string> refused{"next", "previous", "undo", "redo", "light chosen remove",
                                                    "save"};
                if (widget.kind != lab::WidgetKind::action) {
                    found.insert(widget.command);
                } else if (!refused.contains(widget.command)) {
                    EXPECT_NE(desk.say(widget.command).substr(0, 5), "error") << widget.command;
                }
                desk.say("reset");
            }
        EXPECT_EQ(found, expected);
    }
    EXPECT_GT(labels[0].size(), 30U);
    std::set<std::string> both;
    std::set_intersection(labels[0].begin(), labels[0].end(), labels[1].begin(), labels[1].end(),
                          std::inserter(both, both.begin()));
    EXPECT_TRUE(both.empty()) << *both.begin() << " is the same in both languages";
    desk.say("panel off");
    EXPECT_TRUE(panelOf(desk).groups.empty());
}

TEST(Panel, ViewsHaveLegendsAndTheDividerSaysWhatIsWhere) {
    Desk desk;
    desk.begin();
    EXPECT_FALSE(panelOf(desk).legend.has_value());
    for (const lighting::ViewInfo& row : lighting::views()) {
        desk.say(std::string("view ") + row.name);
        const lab::Panel panel = panelOf(desk);
        if (row.view == ViewMode::final)
            continue;
        ASSERT_TRUE(panel.legend.has_value()) << row.name;
        EXPECT_EQ(panel.legend->title.find(row.meaning.en), 0U) << panel.legend->title;
        EXPECT_EQ(panel.legend->entries.empty(), lighting::legend(row.view).empty()) << row.name;
        EXPECT_LE(panel.legend->entries.size(), 12U) << row.name;
        EXPECT_EQ(panel.legend->title.find(", light ") != std::string::npos, row.needsLight)
            << panel.legend->title;
    }
    desk.say("term ambient off");
    desk.say("split term");
    ASSERT_TRUE(panelOf(desk).divider.has_value());
    EXPECT_EQ(panelOf(desk).divider->left, "without D⊗L_A");
    EXPECT_EQ(panelOf(desk).divider->right, "with D⊗L_A");
    EXPECT_TRUE(panelOf(desk).handles.empty());
    desk.say("helpers on");
    EXPECT_FALSE(panelOf(desk).handles.empty());
}

TEST(Panel, AProbedPointFillsTheEquation) {
    Desk desk;
    desk.begin();
    lab::SideProber prober;
    lab::PanelFacts facts;
    facts.probe = prober.look(*desk.session, nullptr, lab::PanelPoint{0.5, 0.75}, 96, 60);
    ASSERT_TRUE(facts.probe.has_value());
    ASSERT_TRUE(facts.probe->point.has_value()) << "the box is there";
    facts.width = 1920;
    lab::Panel panel = panelOf(desk, facts);
    EXPECT_FALSE(panel.probe.empty());
    EXPECT_FALSE(panel.curves.empty());
    EXPECT_FALSE(panel.strokes.empty());
    EXPECT_FALSE(panel.groups.empty());
    std::string text;
    for (const lab::PanelSymbol& symbol : panel.equation)
        text += symbol.text;
    EXPECT_NE(text.find("1.00, 0.53, 0.33"), std::string::npos) << "D as numbers: " << text;
    facts.width = 960;
    panel = panelOf(desk, facts);
    EXPECT_TRUE(panel.groups.empty()) << "in a narrow window the numbers take their place";
    // The same pixel without a term, left of the divider.
    desk.say("split term");
    prober.changed();
    const auto left = prober.look(*desk.session, nullptr, lab::PanelPoint{0.45, 0.75}, 96, 60);
    const auto right = prober.look(*desk.session, nullptr, lab::PanelPoint{0.55, 0.75}, 96, 60);
    EXPECT_FALSE(left->on(Term::ambient));
    EXPECT_TRUE(right->on(Term::ambient));
}

TEST(Programs, FollowTheSlides) {
    const std::vector<std::string> order = lab::programOrder();
    ASSERT_EQ(order.size(), 12U);
    EXPECT_EQ(order.front(), "lesson_00_scene");
    EXPECT_EQ(order[1], "interlude_brdf");
    EXPECT_EQ(lab::neighbour("lesson_04_ambient", 1), "lesson_05_attenuation");
    EXPECT_EQ(lab::neighbour("lesson_02_directional_light", -1), "interlude_cosine_law");
    EXPECT_THROW(lab::neighbour(order.back(), 1), lab::UsageError);
    EXPECT_EQ(lab::programNamed("3"), "lesson_03_point_light");
    EXPECT_EQ(lab::programNamed("03"), "lesson_03_point_light");
    EXPECT_EQ(lab::programNamed("cosine"), "interlude_cosine_law");
    EXPECT_THROW(lab::programNamed("lesson"), lab::UsageError);
    EXPECT_THROW(lab::programNamed(""), lab::UsageError);
    EXPECT_THROW(lab::programNamed("77"), lab::UsageError);
    EXPECT_EQ(lab::slidesOf("lesson_06_many_lights"), "38-39");
    EXPECT_EQ(lab::slidesOf("nothing"), "");
}

}  // namespace
