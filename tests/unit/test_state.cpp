// State files: written, read again, and refused with file and field.
// SPDX-License-Identifier: MIT
#include "image/write.hpp"
#include "lab/failure.hpp"
#include "support/desk.hpp"

#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>

namespace {

using support::Desk;

std::string temporary(const std::string& name) { return testing::TempDir() + name; }

std::string refusal(const std::string& file) {
    try {
        lab::readState(file, "desk");
    } catch (const lab::UsageError& error) {
        return error.what();
    }
    return "nothing was refused";
}

TEST(StateFile, BringsEverythingBack) {
    Desk desk;
    desk.begin();
    for (const char* line : {"term clamp off",
                             "light 2 position 0.1,0.2,0.30000000000000004",
                             "light add directional",
                             "light 4 color 0.1,0.2,0.3",
                             "light 4 direction 1,2,3",
                             "camera 1,2,3,0.1,0,0,41",
                             "time 1.25",
                             "view bands",
                             "only light 4",
                             "split term",
                             "divider 0.25",
                             "slider strength 0.7",
                             "shading vertex",
                             "specular blinn",
                             "decay 2",
                             "jitter 7",
                             "renderer reference",
                             "material 1 specular 0x808080",
                             "choose 2",
                             "light cut 1"})
        ASSERT_EQ(desk.say(line).substr(0, 3), "ok ") << line;
    const std::string file = temporary("all.json");
    image::writeText(file, lab::stateText(desk.host.savedState(), false));

    Desk again;
    again.options.state = file;
    again.begin();
    EXPECT_EQ(again.session->state(), desk.session->state());
    EXPECT_EQ(again.session->state().size(), 21U) << "all twenty of these, and the last term";
    EXPECT_EQ(again.session->lights().size(), 4U);
    EXPECT_EQ(again.bulb.position.z, desk.bulb.position.z);
    again.say("term albedo off");
    again.say("reset");
    EXPECT_EQ(again.session->state(), desk.session->state())
        << "R goes back to the state that it started from";
    std::filesystem::remove(file);
}

TEST(StateFile, IsRefusedWithFileAndField) {
    const std::string file = temporary("wrong.json");
    const auto says = [&file](const std::string& text, const std::string& expected) {
        image::writeText(file, text);
        const std::string found = refusal(file);
        EXPECT_NE(found.find(file), std::string::npos) << found;
        EXPECT_NE(found.find(expected), std::string::npos) << found;
    };
    says("", "JSON object");
    says("[1", "JSON object");
    says("[]", "JSON object");
    says("{}", "lambert_lab");
    says(R"({"lambert_lab": 2})", "expected 1, found 2");
    says(R"({"lambert_lab": 1, "program": "other"})", "program");
    says(R"({"lambert_lab": 1, "program": "desk"})", "size");
    says(R"({"lambert_lab": 1, "program": "desk", "size": [0, 5]})", "[0,5]");
    says(R"({"lambert_lab": 1, "program": "desk", "size": [10, 9000]})", "size");
    says(R"({"lambert_lab": 1, "program": "desk", "size": [10, 10], "controls": []})", "controls");
    says(R"({"lambert_lab": 1, "program": "desk", "size": [10, 10], "controls": {"time": 1}})",
         "controls: time");
    says(std::string(2'000'000, ' '), "1 MiB");
    std::filesystem::remove(file);
    EXPECT_NE(refusal(temporary("nowhere.json")).find("cannot read"), std::string::npos);
    EXPECT_NE(refusal(testing::TempDir()).find("no file"), std::string::npos);
}

TEST(StateFile, WrongControlsAreRefusedByName) {
    const std::string file = temporary("controls.json");
    for (const auto& [control, expected] :
         {std::pair{R"("lamp 1 color": "red")", "unknown control 'lamp 1 color'"},
          std::pair{R"("light 9 color": "red")", "light 9"},
          std::pair{R"("light 2 color": "nocolour")", "light 2 color"},
          std::pair{R"("probe": "on")", "unknown control 'probe'"},
          std::pair{R"("added lights": "lamp")", "lamp"}}) {
        image::writeText(
            file, std::string(R"({"lambert_lab": 1, "program": "desk", "size": [9, 9], "controls": {)") +
                      control + "}}");
        Desk desk;
        desk.options.state = file;
        try {
            desk.begin();
            ADD_FAILURE() << control << " was taken";
        } catch (const lab::UsageError& error) {
            EXPECT_NE(std::string(error.what()).find(expected), std::string::npos) << error.what();
            EXPECT_NE(std::string(error.what()).find(file), std::string::npos) << error.what();
        }
    }
    std::filesystem::remove(file);
}

TEST(StateFile, AFreeNameWritesOverNothing) {
    const std::string base = temporary("free");
    std::filesystem::remove(base + ".png");
    std::filesystem::remove(base + "-1.json");
    EXPECT_EQ(lab::freeName(base, {".png", ".json"}), base);
    image::writeText(base + ".png", "x");
    EXPECT_EQ(lab::freeName(base, {".png", ".json"}), base + "-1");
    image::writeText(base + "-1.json", "x");
    EXPECT_EQ(lab::freeName(base, {".png", ".json"}), base + "-2");
    std::filesystem::remove(base + ".png");
    std::filesystem::remove(base + "-1.json");
}

TEST(Values, ReadBackTheSame) {
    for (const double x : {0.0, 0.1, 1.0 / 3, 1e-300, -1e36, 123456789.125})
        EXPECT_EQ(lab::readVector(lab::vectorText({x, -x, 1})).x, x);
    for (const THREE::Color& color :
         {THREE::Color(0xDD6666), THREE::Color(0.1, 0.2, 3), THREE::Color(1 / 255.0, 0, 0.5)})
        EXPECT_TRUE(lab::readColor(lab::colorText(color)) == color) << lab::colorText(color);
    EXPECT_EQ(lab::colorText(THREE::Color(0xDD6666)), "0xDD6666");
    EXPECT_EQ(lab::colorText(THREE::Color(0.5, 2, 0)), "0.5,2,0");
}

}  // namespace
