// Lights as the floats that shaders read, in the order of their loops.
// SPDX-License-Identifier: MIT
#include "render/light_numbers.hpp"
#include "render/program.hpp"
#include "render/shader_source.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <regex>

namespace {

constexpr float largest = std::numeric_limits<float>::max();

// A sun and three bulbs, one of them with numbers that no float holds.
lighting::FramePlan fourLights() {
    lighting::FramePlan plan;
    plan.directional.push_back({{0, 0, 1}, {0.1, 0.2, 0.3}, 0.5});
    plan.point.push_back({{1, 2, 3}, {4, 5, 6}, 7, 0, 0});
    plan.point.push_back({{-1, 0.1, 1e-3}, {1, 1, 1}, 1, 1.5, 8});
    plan.point.push_back({{1e39, -1e39, 0}, {1e300, 0, 0}, 1e300, 2, 1e-300, -40});
    plan.lightSets.push_back({{0, 1, 2}});
    plan.lightSets.push_back({{0, 2}});
    plan.lightSets.push_back({{}, true});
    return plan;
}

TEST(LightNumbers, StandAsTheShadersReadThem) {
    const render::LightNumbers all = render::numbersOf(fourLights());
    ASSERT_EQ(all.count(), 4U);
    EXPECT_EQ(all.geometry[0], glm::vec4(0, 0, 1, 0));
    EXPECT_EQ(all.radiance[0], glm::vec4(0.1, 0.2, 0.3, 0.5));
    EXPECT_EQ(all.falloff[0], glm::vec4(0));
    EXPECT_EQ(all.geometry[1], glm::vec4(1, 2, 3, 0)) << "without a distance its inverse is 0";
    EXPECT_EQ(all.geometry[2].w, 0.125F);
    EXPECT_EQ(all.falloff[2], glm::vec4(1.5, 0, 0, 0));
    EXPECT_EQ(all.geometry[3], glm::vec4(largest, -largest, 0, largest));
    EXPECT_EQ(all.radiance[3], glm::vec4(largest, 0, 0, largest));
    EXPECT_EQ(all.falloff[3], glm::vec4(2, -40, 0, 0));
    EXPECT_EQ(all.moves, std::vector<bool>(4, false));
}

TEST(LightNumbers, OfASetWithAllDirectionalOnesFirst) {
    const lighting::FramePlan plan = fourLights();
    const render::LightNumbers all = render::numbersOf(plan);
    const auto set = [&](std::size_t i) { return render::pick(all, plan, plan.lightSets[i]); };
    EXPECT_EQ(set(0).geometry, all.geometry);
    EXPECT_EQ(set(1).radiance, (std::vector<glm::vec4>{all.radiance[0], all.radiance[1], all.radiance[3]}));
    EXPECT_EQ(set(1).moves.size(), 3U);
    EXPECT_EQ(set(2).count(), 0U);
}

// What is written into a shader reads back as the same float; a light that moves is not written.
TEST(LightNumbers, ConstantsReadBackExactly) {
    lighting::FramePlan plan = fourLights();
    plan.point[0].color = {1.0 / 3, 1e-42, 0x1.fffffep-3};
    plan.point[1].position = {0.1, 1e30, -1e-30};
    render::LightNumbers lights = render::numbersOf(plan);
    lighting::Variant variant;
    variant.lit = true;
    variant.directional = 1;
    variant.decay0 = variant.decayOther = variant.decay2 = 1;
    variant.storage = lighting::LightStorage::constants;
    lights.moves[2] = true;
    const std::string text = render::preamble(variant, lights, true);
    std::vector<float> found;
    const std::regex vector("vec4\\(([^,]+), ([^,]+), ([^,]+), ([^)]+)\\)");
    for (std::sregex_iterator it(text.begin(), text.end(), vector), end; it != end; ++it)
        for (std::size_t c = 1; c <= 4; ++c)
            found.push_back(std::strtof((*it)[c].str().c_str(), nullptr));
    std::vector<float> expected;
    for (const auto* const values : {&lights.geometry, &lights.radiance, &lights.falloff})
        for (std::size_t i = 0; i < 4; ++i)
            for (int c = 0; c < 4; ++c)
                expected.push_back(i == 2 ? 0 : (*values)[i][c]);
    EXPECT_EQ(found, expected);
    EXPECT_NE(text.find("UNIFORM_LIGHT[4] = int[4](-1, -1, 0, -1)"), std::string::npos) << text;
    EXPECT_NE(text.find("#define SOME_LIGHTS_MOVE 1\n#define NUM_UNIFORM_LIGHTS 1\n"), std::string::npos);
}

}  // namespace
