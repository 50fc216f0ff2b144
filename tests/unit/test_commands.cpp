// Commands, undo and the table of controls, without a window.
// SPDX-License-Identifier: MIT
#include "lab/live/control_json.hpp"
#include "lab/live/keys.hpp"
#include "support/desk.hpp"

#include <gtest/gtest.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

namespace {

using lighting::Term;
using support::Desk;

TEST(Commands, SwitchTermsAndTellThem) {
    Desk desk;
    desk.begin();
    EXPECT_EQ(desk.say("term ambient off"), "ok term ambient off");
    EXPECT_FALSE(desk.session->switches.terms.has(Term::ambient));
    EXPECT_EQ(desk.say("term ambient"), "ok term ambient off");
    EXPECT_EQ(desk.say("term ambient toggle"), "ok term ambient on");
    EXPECT_EQ(desk.say("term clamp reset"), "ok term clamp on");
    EXPECT_EQ(desk.say("terms -clamp,-ambient"),
              "ok terms albedo,cosine,light_color,attenuation,directional,point,specular");
    EXPECT_EQ(desk.say("terms all"), "ok terms all");
}

TEST(Commands, EveryWrongLineIsAnsweredWithWhatWasExpected) {
    Desk desk;
    desk.begin();
    const lab::State before = desk.session->state();
    for (const char* line : {"term ambient maybe",
                             "term ambient on off",
                             "term",
                             "nonsense",
                             "light 9 color red",
                             "light 2 color nocolour",
                             "light 2 color 0xGG0000",
                             "light 2 color 1,2",
                             "light 2 color -1,0,0",
                             "light 2 intensity -1",
                             "light 2 position 1,2",
                             "light 2 position nan,0,0",
                             "light 2 position 1e37,0,0",
                             "light 1 direction 0,0,0",
                             "light 1 position 1,2,3",
                             "light add lamp",
                             "light 1 remove",
                             "light 0 remove",
                             "camera 1,2,3",
                             "camera 1,2,3,1,2,3",
                             "camera 0,0,5,0,0,0,180",
                             "slider strength 6",
                             "slider sideways",
                             "view sideways",
                             "only light 4",
                             "split maybe",
                             "undo",
                             "redo",
                             "load",
                             "load /nowhere.json",
                             "shot a b c",
                             "shot a.png 0x5",
                             "probe 2 0",
                             "probe 1",
                             "choose 4",
                             "lesson nonsense",
                             "next more",
                             "font size 49",
                             "font size nan",
                             "time inf",
                             "jitter -1",
                             "decay -1",
                             "pin 0 0 0",
                             "'unfinished",
                             "divider 1.5",
                             "last term nothing",
                             "shading sideways",
                             "terms",
                             "terms -nothing",
                             "quit now",
                             "material 7 color red"}) {
        const std::string answer = desk.say(line);
        EXPECT_EQ(answer.substr(0, 6), "error ") << line << " -> " << answer;
        EXPECT_EQ(answer.find('\n'), std::string::npos);
    }
    EXPECT_EQ(desk.session->state(), before);
    EXPECT_TRUE(desk.host.asked.empty());
    EXPECT_EQ(desk.say(""), "");
    EXPECT_EQ(desk.say("  # nothing"), "");
}

TEST(Commands, LightsAndMaterialsTakeValuesOverTheAnimation) {
    Desk desk;
    desk.begin();
    EXPECT_EQ(desk.say("light 2 color 0xDD6600"), "ok light 2 color 0xDD6600");
    EXPECT_EQ(desk.bulb.color, THREE::Color(0xDD6600));
    EXPECT_EQ(desk.say("light 2 intensity 0.25"), "ok light 2 intensity 0.25");
    EXPECT_EQ(desk.bulb.intensity, 0.25) << "although the animation says 1";
    EXPECT_EQ(desk.say("light 2 position 1,-2.5,1e-3"), "ok light 2 position 1,-2.5,0.001");
    EXPECT_EQ(desk.bulb.position.y, -2.5);
    EXPECT_EQ(desk.say("light 1 direction 1,1,1"), "ok light 1 direction 1,1,1");
    EXPECT_EQ(desk.say("light 2 decay 2"), "ok light 2 decay 2");
    EXPECT_EQ(desk.say("light 3 off"), "ok light 3 on off");
    EXPECT_FALSE(desk.sky.visible);
    EXPECT_EQ(desk.say("material 1 color orange"), "ok material 1 color 0xFFA500");
    EXPECT_EQ(desk.say("material 1 shininess 12"), "ok material 1 shininess 12");
    EXPECT_EQ(desk.material.shininess, 12);
    EXPECT_EQ(desk.say("light 2 intensity reset"), "ok light 2 intensity 1");
    desk.say("reset");
    EXPECT_EQ(desk.bulb.color, THREE::Color(0xDD6666));
    EXPECT_EQ(desk.bulb.intensity, 1);
    EXPECT_EQ(desk.bulb.decay, 0);
    EXPECT_TRUE(desk.sky.visible);
    EXPECT_EQ(desk.material.color, THREE::Color(0xFF8855));
    EXPECT_TRUE(desk.session->state().empty());
}

TEST(Commands, LightsCanBeAddedAndTakenOut) {
    Desk desk;
    desk.begin();
    EXPECT_EQ(desk.say("light add point"), "ok light 4");
    EXPECT_EQ(desk.say("light 4 color red"), "ok light 4 color 0xFF0000");
    EXPECT_EQ(desk.say("light add directional"), "ok light 5");
    EXPECT_EQ(desk.session->lights().size(), 5U);
    EXPECT_EQ(desk.say("only light 5"), "ok only light 5");
    EXPECT_EQ(desk.say("light 4 remove"), "ok light 4 removed");
    EXPECT_EQ(desk.session->lights().size(), 4U);
    EXPECT_EQ(desk.session->only, 0);
    EXPECT_EQ(desk.say("undo"), "ok undo");
    EXPECT_EQ(desk.session->lights().size(), 5U);
    EXPECT_EQ(desk.say("light 4 color"), "ok light 4 color 0xFF0000") << "it is as it was";
    EXPECT_EQ(desk.session->only, 5);
    desk.say("reset");
    EXPECT_EQ(desk.session->lights().size(), 3U);
}

TEST(Commands, WrongKindsOfLightsLeaveThoseThatAreThere) {
    Desk desk;
    desk.begin();
    for (const char* line : {"light add point", "light 4 color red", "light add directional", "only light 5"})
        ASSERT_EQ(desk.say(line).substr(0, 3), "ok ") << line;
    const lab::State before = desk.session->state();
    std::string many = "point";
    for (std::size_t i = 0; i < lab::mostControlledLights; ++i)
        many += ",ambient";
    for (const std::string& kinds :
         {std::string("lamp"), std::string("point,lamp"), std::string("point,"), many}) {
        EXPECT_EQ(desk.say("added lights " + kinds).substr(0, 5), "error") << kinds;
        EXPECT_EQ(desk.session->state(), before) << kinds;
    }
    EXPECT_EQ(desk.say("chosen light"), "ok chosen light 5");
}

// With the sanitizers: what update() put on a light is taken off before the light goes.
TEST(Commands, LightsGoWhateverWasGivenToThem) {
    Desk desk;
    desk.begin();
    for (const char* line :
         {"decay 2", "jitter 3", "light add point", "light 4 position 1,2,3", "light 4 decay 1",
          "light 4 remove", "light add point", "undo", "light add point"})
        ASSERT_EQ(desk.say(line).substr(0, 3), "ok ") << line;
    desk.commands.reset();
    desk.session.reset();
    EXPECT_EQ(desk.scene.children().size(), 4U);
    desk.view.reset();
    EXPECT_EQ(desk.bulb.decay, 0);
}

TEST(Commands, OneOfManyLightsCanShineAlone) {
    Desk desk;
    std::vector<std::unique_ptr<THREE::PointLight>> lamps;
    for (int i = 0; i < 97; ++i)
        desk.scene.add(*lamps.emplace_back(std::make_unique<THREE::PointLight>()));
    desk.begin();
    EXPECT_EQ(desk.say("only 100"), "ok only light 100");
    EXPECT_EQ(desk.say("only light"), "ok only light 100");
    EXPECT_EQ(desk.session->state().at("only light"), "100");
    EXPECT_EQ(desk.say("only light 99"), "ok only light 99");
    EXPECT_EQ(desk.say("only 101").substr(0, 5), "error");
}

TEST(Commands, NothingIsShownBesideTheFirstLesson) {
    Desk desk;
    desk.host.isFirst = true;
    desk.begin();
    EXPECT_EQ(desk.say("split lesson"), "error split: there is none");
    EXPECT_EQ(desk.say("split"), "ok split off");
    EXPECT_EQ(desk.say("split next"), "ok split term");
    EXPECT_EQ(desk.say("split next").substr(0, 5), "error");
    EXPECT_EQ(desk.say("split"), "ok split off") << "the key goes on";
}

// The mouse moves the camera by no command; the window's next draw mends it.
TEST(Commands, AreAnsweredWhereNothingCanBeDrawn) {
    Desk desk;
    desk.begin();
    desk.view->orbit().place({1e36, 0, 0}, {0, 0, 0});
    EXPECT_EQ(desk.commands->run("term ambient off").substr(0, 5), "error");
    EXPECT_EQ(desk.commands->run("camera reset").substr(0, 22), "ok camera 2.2,2.7,6.4,");
}

TEST(Commands, UndoAndRedoGoThroughAllThatWasMoved) {
    Desk desk;
    desk.begin();
    const std::vector<std::string> lines = {"term ambient off",       "light 2 color 0x112233",
                                            "view normals",           "camera 1,2,3,0,0,0,40",
                                            "slider strength 2.5",    "light add ambient",
                                            "shading flat",           "split term",
                                            "material 1 color 0x10,", "decay 1.5"};
    std::vector<lab::State> states{desk.session->state()};
    for (const std::string& line : lines)
        if (desk.say(line).starts_with("ok"))
            states.push_back(desk.session->state());
    EXPECT_EQ(states.size(), lines.size());
    for (std::size_t i = states.size() - 1; i > 0; --i) {
        EXPECT_EQ(desk.say("undo"), "ok undo");
        EXPECT_EQ(desk.session->state(), states[i - 1]) << i;
    }
    EXPECT_EQ(desk.say("undo").substr(0, 5), "error");
    for (std::size_t i = 1; i < states.size(); ++i) {
        EXPECT_EQ(desk.say("redo"), "ok redo");
        EXPECT_EQ(desk.session->state(), states[i]) << i;
    }
    EXPECT_EQ(desk.say("redo").substr(0, 5), "error");
}

TEST(Commands, ADragIsOneStepOfUndo) {
    Desk desk;
    desk.begin();
    for (const char* place : {"1,1,1", "1.5,1,1", "2,1,1"})
        desk.say(std::string("light 2 position ") + place, true);
    desk.commands->endGesture();
    for (const char* place : {"3,1,1", "4,1,1"})
        desk.say(std::string("light 2 position ") + place, true);
    desk.say("undo");
    EXPECT_EQ(desk.say("light 2 position"), "ok light 2 position 2,1,1");
    desk.say("undo");
    EXPECT_EQ(desk.say("light 2 position"), "ok light 2 position 2,1.5,5");
}

TEST(Commands, TheCameraComesBackToTheSameBits) {
    Desk desk;
    desk.begin();
    EXPECT_FALSE(desk.view->cameraMoved());
    desk.view->orbit().rotate(0.1234567, -0.0312);
    desk.view->orbit().pan(0.211, 0.1);
    desk.view->orbit().zoom(2);
    const std::string text = desk.view->cameraText();
    const THREE::Vector3 eye = desk.camera.position;
    const THREE::Quaternion turn = desk.camera.quaternion;
    desk.say("reset");
    EXPECT_FALSE(desk.view->cameraMoved());
    EXPECT_EQ(desk.say("camera " + text), "ok camera " + text);
    EXPECT_EQ(desk.camera.position.x, eye.x);
    EXPECT_EQ(desk.camera.quaternion.x, turn.x);
    EXPECT_EQ(desk.camera.quaternion.w, turn.w);
}

TEST(Commands, AskTheHostForTheRest) {
    Desk desk;
    desk.begin();
    EXPECT_EQ(desk.say("shot x.png"), "ok shot x.png");
    EXPECT_EQ(desk.say("shot 'two words.png' 64x48"), "ok shot two words.png");
    EXPECT_EQ(desk.say("lesson 3"), "ok lesson lesson_03_point_light");
    EXPECT_EQ(desk.say("next"), "ok lesson lesson_00_scene")
        << "a program that is none of the lessons stands before the first";
    EXPECT_EQ(desk.say("previous").substr(0, 5), "error");
    EXPECT_EQ(desk.say("open a.json"), "ok open a.json");
    EXPECT_EQ(desk.say("open -a.json"), "ok open -a.json");
    EXPECT_EQ(desk.say("cost"), "ok cost 1 ms");
    EXPECT_EQ(desk.say("places"), "ok places symbol term ambient 1 2;widget term ambient 3 4;");
    EXPECT_EQ(desk.say("quit"), "ok quit");
    const std::vector<std::string> expected{"shot x.png 0x0",
                                            "shot two words.png 64x48",
                                            "go lesson_03_point_light",
                                            "go lesson_00_scene",
                                            "go scene_viewer a.json",
                                            "go scene_viewer ./-a.json",
                                            "leave"};
    EXPECT_EQ(desk.host.asked, expected);
}

TEST(Commands, TheTableIsComplete) {
    Desk desk;
    desk.begin();
    std::set<std::string> names;
    for (const lab::Control& control : desk.session->table.all())
        EXPECT_TRUE(names.insert(control.name).second) << control.name << " is there twice";
    for (const std::string& name : names) {
        const lab::Control control = *desk.session->table.find(name);  // what is said may make the table anew
        EXPECT_NE(control.help.it, nullptr) << control.name;
        EXPECT_NE(control.help.en, nullptr) << control.name;
        EXPECT_FALSE(control.moved()) << control.name;
        const std::string value = control.get();
        EXPECT_EQ(desk.say(control.name + " " + value), "ok " + control.name + " " + value)
            << "what it is can be said";
        for (const lab::ControlChoice& choice : control.choices)
            EXPECT_EQ(desk.say(control.name + " " + choice.name), "ok " + control.name + " " + choice.name);
        desk.say(control.name + " reset");
        if (control.name == "last term")
            continue;  // its own value is none
        EXPECT_EQ(desk.session->table.find(control.name)->get(), value) << control.name;
    }
    EXPECT_GE(names.size(), 45U);
    const nlohmann::json json = nlohmann::json::parse(lab::controlsJson(desk.session->table));
    EXPECT_EQ(json.size(), names.size());
    EXPECT_EQ(json[0]["name"], "added lights");
}

TEST(Commands, EveryKeySaysACommandThatIsUnderstood) {
    for (const lab::Key& key : lab::keyTable()) {
        Desk desk;
        desk.begin();
        desk.say("light add point");
        desk.say("term albedo off");
        if (std::string(key.command) == "redo")
            desk.say("undo");
        const std::string answer = desk.say(key.command);
        const std::set<std::string> refused{"previous", "shot",
                                            "save"};  // before the first lesson; where nothing may be written
        if (!refused.contains(key.command)) {
            EXPECT_NE(answer.substr(0, 5), "error") << key.name << ": " << key.command << " -> " << answer;
        }
        lab::Event event{
            .kind = lab::Event::Kind::key, .key = key.code, .modified = key.shift, .control = key.control};
        EXPECT_EQ(lab::commandOf(event), key.command) << key.name << " means two things";
    }
}

}  // namespace
