// Color: CSS notations, hexadecimal, arithmetic, and what is refused.
// SPDX-License-Identifier: MIT
#include "three/color.hpp"
#include "three/color_names.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <stdexcept>
#include <string>

using THREE::Color;

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

void expectColor(const Color& color, double r, double g, double b, double tolerance = 0) {
    EXPECT_NEAR(color.r, r, tolerance);
    EXPECT_NEAR(color.g, g, tolerance);
    EXPECT_NEAR(color.b, b, tolerance);
}

std::string refusal(std::string_view css) {
    try {
        Color color(css);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST(Color, IsWhiteByDefault) { expectColor(Color(), 1, 1, 1); }

TEST(Color, TakesBytesWithoutDecoding) {
    expectColor(Color(0xFF8855), 1, 0x88 / 255.0, 0x55 / 255.0);
    expectColor(Color(0xAB123456), 0x12 / 255.0, 0x34 / 255.0, 0x56 / 255.0);
    expectColor(Color(0), 0, 0, 0);
    expectColor(Color().setHex(0x0000FF), 0, 0, 1);
}

TEST(Color, EveryByteComesBack) {
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        const std::uint32_t hex = byte << 16 | (255 - byte) << 8 | (byte ^ 0x55);
        EXPECT_EQ(Color(hex).getHex(), hex);
    }
}

TEST(Color, RoundsToTheNearestCode) {
    EXPECT_EQ(Color(0.5, 127.49 / 255, 127.51 / 255).getHex(), 0x807F80u);
    EXPECT_EQ(Color(1.0 - 1e-9, 0.49 / 255, 0.51 / 255).getHex(), 0xFF0001u);
}

TEST(Color, ClampsWhatNoCodeHolds) {
    EXPECT_EQ(Color(-1, 2, 1e300).getHex(), 0x00FFFFu);
    EXPECT_EQ(Color(notANumber, infinity, -infinity).getHex(), 0x00FF00u);
    EXPECT_EQ(Color(notANumber, notANumber, notANumber).getHexString(), "000000");
}

TEST(Color, WritesSixDigits) {
    EXPECT_EQ(Color(0xFF8855).getHexString(), "ff8855");
    EXPECT_EQ(Color(0x00000A).getHexString(), "00000a");
}

TEST(Color, KnowsEveryCssName) {
    for (const THREE::NamedColor& named : THREE::namedColors)
        EXPECT_EQ(Color(named.name).getHex(), named.hex) << named.name;
    EXPECT_EQ(Color("orange").getHex(), 0xFFA500u);
    EXPECT_EQ(Color("rebeccapurple").getHex(), 0x663399u);
    EXPECT_EQ(Color("aliceblue").getHex(), 0xF0F8FFu);
    EXPECT_EQ(Color("yellowgreen").getHex(), 0x9ACD32u);
    EXPECT_EQ(Color("PowderBlue").getHex(), 0xB0E0E6u);
    for (const char* stem : {"", "dark", "darkslate", "dim", "light", "lightslate", "slate"})
        EXPECT_EQ(Color(std::string(stem) + "gray"), Color(std::string(stem) + "grey")) << stem;
}

TEST(Color, ReadsHexadecimalText) {
    EXPECT_EQ(Color("#f85").getHex(), 0xFF8855u);
    EXPECT_EQ(Color("#FF8855").getHex(), 0xFF8855u);
    EXPECT_EQ(Color(std::string("#000")).getHex(), 0x000000u);
    EXPECT_EQ(Color().setStyle("#0a0B0c").getHex(), 0x0A0B0Cu);
}

TEST(Color, ReadsRgb) {
    expectColor(Color("rgb(255, 136, 85)"), 1, 136 / 255.0, 85 / 255.0);
    expectColor(Color("RGB( 0,1 ,\t255 )"), 0, 1 / 255.0, 1);
    expectColor(Color("rgb(100%, 53%, 33%)"), 1, 0.53, 0.33);
    expectColor(Color("rgb(0%,12.5%,.5%)"), 0, 0.125, 0.005);
}

TEST(Color, ReadsHsl) {
    // Lightness 0.67 and full saturation: the highest channel is 1, the lowest 0.34; 20 degrees are a third
    // of the way up the ramp from red to yellow.
    expectColor(Color("hsl(20, 100%, 67%)"), 1, 0.34 + 0.66 / 3, 0.34, 1e-15);
    expectColor(Color("hsl(120, 100%, 50%)"), 0, 1, 0, 1e-15);
    expectColor(Color("hsl(240,50%,25%)"), 0.125, 0.125, 0.375, 1e-15);
    expectColor(Color("hsl(480, 100%, 50%)"), 0, 1, 0, 1e-14);
    expectColor(Color("hsl(77, 0%, 40%)"), 0.4, 0.4, 0.4, 1e-15);
}

TEST(Color, HueWrapsRoundAndTheRestIsClamped) {
    const double sixth = 1.0 / 6;
    const double expected[6][3] = {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}, {1, 0, 1}};
    for (int i = -12; i < 12; ++i) {
        const double* e = expected[(i + 12) % 6];
        expectColor(Color().setHSL(i * sixth, 1, 0.5), e[0], e[1], e[2], 1e-14);
    }
    expectColor(Color().setHSL(0, 5, 0.5), 1, 0, 0, 1e-15);
    expectColor(Color().setHSL(0.3, 1, 7), 1, 1, 1);
    expectColor(Color().setHSL(0.3, -1, 0.25), 0.25, 0.25, 0.25);
    expectColor(Color().setHSL(-1e-20, 1, 0.5), 1, 0, 0, 1e-15);
}

TEST(Color, BadHslNumbersStayVisible) {
    for (const Color& color : {Color().setHSL(notANumber, 1, 0.5), Color().setHSL(0, notANumber, 0.5),
                               Color().setHSL(0, 1, notANumber), Color().setHSL(infinity, 1, 1)})
        EXPECT_TRUE(std::isnan(color.r) && std::isnan(color.g) && std::isnan(color.b));
}

TEST(Color, RefusesEverythingElse) {
    const char* texts[] = {"",
                           " ",
                           "orang",
                           " orange",
                           "orange ",
                           "oran\tge",
                           "transparent",
                           "#",
                           "#ff",
                           "#ff885",
                           "#ff88555",
                           "#ff8855aa",
                           "#gg8855",
                           "#-f8",
                           "#0x1234",
                           "ff8855",
                           "0xff8855",
                           "rgb",
                           "rgb(",
                           "rgb)",
                           "rgb()",
                           "rgb(1)",
                           "rgb(1,2)",
                           "rgb(1,2,3",
                           "rgb(1,2,3))",
                           "rgb(1,2,3) ",
                           "rgb (1,2,3)",
                           "rgb(1,2,3,4)",
                           "rgb(1,,3)",
                           "rgb(1,2,)",
                           "rgb(1 2 3)",
                           "rgb(1,2,3%)",
                           "rgb(1%,2%,3)",
                           "rgb(1%,2,3)",
                           "rgb(-1,2,3)",
                           "rgb(+1,2,3)",
                           "rgb(256,0,0)",
                           "rgb(101%,0%,0%)",
                           "rgb(1e2,0,0)",
                           "rgb(nan,0,0)",
                           "rgb(inf,0,0)",
                           "rgb(1.,0,0)",
                           "rgb(1.2.3,0,0)",
                           "rgb(.,0,0)",
                           "rgb(%,%,%)",
                           "rgb(0x10,0,0)",
                           "rgba(1,2,3,0.5)",
                           "hsl(20,100,67)",
                           "hsl(20%,100%,67%)",
                           "hsl(20,100%,67)",
                           "hsl(-20,100%,67%)",
                           "hsl(x,100%,67%)",
                           "hsl(20,101%,67%)",
                           "hsla(20,100%,67%,1)",
                           "hwb(1,2,3)",
                           "(1,2,3)",
                           "rgb(hsl(1,2,3))"};
    for (const char* text : texts)
        EXPECT_NE(refusal(text), "") << '"' << text << '"';
    EXPECT_NE(refusal("rgb(" + std::string(400, '9') + ",0,0)"), "");
    EXPECT_NE(refusal(std::string_view("red\0", 4)), "");
}

TEST(Color, SaysWhatWasFoundAndWhatIsAccepted) {
    const std::string message = refusal("orang");
    for (const char* part :
         {"\"orang\"", "CSS name", "#rgb", "#rrggbb", "rgb(255, 136, 85)", "rgb(100%, 53%, 33%)", "hsl("})
        EXPECT_NE(message.find(part), std::string::npos) << part << " in " << message;
    EXPECT_NE(refusal("rgb(300, 0, 0)").find("\"300\", more than 255"), std::string::npos);
    EXPECT_LT(refusal(std::string(1'000'000, 'x')).size(), 500u);
    EXPECT_LT(refusal("rgb(" + std::string(1'000'000, 'x') + ",0,0)").size(), 500u);
}

TEST(Color, KeepsItsValueWhenATextIsRefused) {
    Color color(0.25, 0.5, 0.75);
    EXPECT_THROW(color.set("nonsense"), std::invalid_argument);
    EXPECT_THROW(color.set("rgb(1,2,x)"), std::invalid_argument);
    expectColor(color, 0.25, 0.5, 0.75);
}

TEST(Color, Arithmetic) {
    expectColor(Color(0.5, 1, 2).multiply(Color(0.5, 0.25, 3)), 0.25, 0.25, 6);
    expectColor(Color(0.5, 1, 2).add(Color(0.5, 0.25, 3)), 1, 1.25, 5);
    expectColor(Color(0.5, 1, 2).multiplyScalar(2), 1, 2, 4);
    expectColor(Color().setScalar(0.25), 0.25, 0.25, 0.25);
    expectColor(Color().setRGB(1, 2, 3), 1, 2, 3);
    Color self(1, 2, 3);
    expectColor(self.multiply(self), 1, 4, 9);
}

TEST(Color, LerpEndsExactly) {
    const Color from(0.1, 0.7, 1e20), to(0.3, 0.2, 1);
    EXPECT_EQ(Color(from).lerp(to, 0), from);
    EXPECT_EQ(Color(from).lerp(to, 1), to);
    expectColor(Color(0, 1, 2).lerp(Color(1, 3, 0), 0.25), 0.25, 1.5, 1.5);
}
