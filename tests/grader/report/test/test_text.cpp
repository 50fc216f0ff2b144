// Text made harmless, numbers and base64.
// SPDX-License-Identifier: MIT
#include "grader/report/text.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

using namespace grader;

TEST(ReportText, keepsWhatIsHarmless) {
    const std::string text = "n . w = 0.5\twhere \xC3\xA8 \xE2\x82\xAC \xF0\x9F\x98\x80\n";
    EXPECT_EQ(harmless(text), text);
}

TEST(ReportText, brokenUtf8BecomesReplacements) {
    const std::string r = "\xEF\xBF\xBD";
    EXPECT_EQ(harmless("a\xFF"
                       "b"),
              "a" + r + "b");
    EXPECT_EQ(harmless("\xC0\xAF"), r + r);  // overlong
    EXPECT_EQ(harmless("\xED\xA0\x80"), r + r + r);  // half of a surrogate pair
    EXPECT_EQ(harmless("\xF4\x90\x80\x80"), r + r + r + r);  // beyond U+10FFFF
    EXPECT_EQ(harmless("\xE2\x82"), r + r);  // cut short
}

TEST(ReportText, nothingSteersTerminalsOrBrowsers) {
    const std::string r = "\xEF\xBF\xBD";
    EXPECT_EQ(harmless("\x1B[1;31mred\x1B[0m"), "red");
    EXPECT_EQ(harmless("\x1B[31"), "");
    EXPECT_EQ(harmless("\x1B]0;title\x07"), "]0;title" + r);
    EXPECT_EQ(harmless("a\x01\x08\x7F"), "a" + r + r + r);
    EXPECT_EQ(harmless("\xE2\x80\xAE"), r);  // right-to-left override
    EXPECT_EQ(harmless("\xEF\xBF\xBF"), r);  // no XML character
    EXPECT_EQ(harmless(std::string("a\0b", 3)), "a" + r + "b");
}

TEST(ReportText, everyLineEndIsOne) {
    EXPECT_EQ(harmless("a\r\nb\rc\vd\fe\xC2\x85"
                       "f\xE2\x80\xA8g"),
              "a\nb\nc\nd\ne\nf\ng");
    EXPECT_EQ(oneLine("a\r\n\tb"), "a  b");
}

TEST(ReportText, everyByteStaysHarmless) {
    for (int first = 0; first < 256; ++first)
        for (int second = 0; second < 256; ++second) {
            const std::string once = harmless({static_cast<char>(first), static_cast<char>(second), 'x'});
            ASSERT_EQ(harmless(once), once) << first << ' ' << second;
        }
}

TEST(ReportText, markupIsEscaped) { EXPECT_EQ(escaped("<a b='\"'>&"), "&lt;a b=&#39;&quot;&#39;&gt;&amp;"); }

TEST(ReportText, cutsBetweenCharacters) {
    EXPECT_EQ(shortened("abc", 3), "abc");
    EXPECT_EQ(shortened("abcd", 3), "abc...");
    EXPECT_EQ(shortened("a\xE2\x82\xACz", 3), "a...");
}

TEST(ReportText, numbers) {
    EXPECT_EQ(number(0.1), "0.1");
    EXPECT_EQ(number(14), "14");
    EXPECT_EQ(number(std::numeric_limits<double>::infinity()), "?");
    EXPECT_EQ(points(2.0 / 3), "0.67");
    EXPECT_EQ(points(2.999999999), "3");
    EXPECT_EQ(percent(0.9999), "99 %");
    EXPECT_EQ(percent(0.0001), "1 %");
    EXPECT_EQ(percent(1), "100 %");
    EXPECT_EQ(percent(0), "0 %");
    EXPECT_EQ(percent(std::nan("")), "?");
}

TEST(ReportText, base64) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xFF\xFE\xFD"), "//79");
}
