// compare_pictures on folders of small pictures: what it lets pass, and what it names.
// SPDX-License-Identifier: MIT
#include "image/write.hpp"
#include "support/program.hpp"

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;

class Pictures : public testing::Test {
  protected:
    Pictures() {
        for (const char* folder : {"committed", "drawn"})
            fs::create_directory(directory.path() / folder);
        put("committed/a.png", 100);
        put("drawn/a.png", 100);
    }
    // 2 x 1 pixels, black and this grey.
    void put(const std::string& file, std::uint8_t code) const {
        image::write(directory.file(file), {2, 1, image::Bytes{0, 0, 0, code, code, code}}, {});
    }
    support::Outcome compare(const std::vector<std::string>& others = {}) const {
        std::vector<std::string> arguments{"compare_pictures", "committed", "drawn"};
        arguments.insert(arguments.end(), others.begin(), others.end());
        return support::run(arguments, directory.path());
    }
    void expectComplaint(const std::string& part, const std::vector<std::string>& others = {}) const {
        const support::Outcome outcome = compare(others);
        EXPECT_EQ(outcome.status, 1);
        EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
    }

    support::TemporaryDirectory directory;
};

TEST_F(Pictures, EqualWithinACodePass) {
    put("drawn/a.png", 101);
    const support::Outcome outcome = compare();
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "1 pictures are what the programs draw\n");
}

TEST_F(Pictures, TwoCodesApartAreNamed) {
    put("drawn/a.png", 98);
    expectComplaint(
        "committed/a.png: differs by up to 2 codes, by more than 1 in 1 of 2 pixels; at (1, 0) it is "
        "(100, 100, 100), the program draws (98, 98, 98)");
}

TEST_F(Pictures, AnotherSizeIsNamed) {
    image::write(directory.file("drawn/a.png"), {1, 1, image::Bytes{0, 0, 0}}, {});
    expectComplaint("committed/a.png: ");
}

TEST_F(Pictures, WhatIsNotCommittedIsNamed) {
    put("drawn/b.png", 1);
    expectComplaint("committed/b.png: is not committed");
}

TEST_F(Pictures, WhatNobodyDrawsIsNamedUnlessItIsAnException) {
    put("committed/chart.png", 1);
    expectComplaint("committed/chart.png: no command draws it");
    EXPECT_EQ(compare({"chart.png"}).status, 0);
    expectComplaint("committed/gone.png: is named as made by another script", {"chart.png", "gone.png"});
}

TEST_F(Pictures, TakesTwoFolders) {
    EXPECT_EQ(support::run({"compare_pictures"}, directory.path()).status, 2);
    EXPECT_EQ(support::run({"compare_pictures", "committed", "nowhere"}, directory.path()).status, 4);
}

}  // namespace
