// Unit tests of frames to files and back: exact values, top row first, metadata, the same bytes each time.
// SPDX-License-Identifier: MIT
#include "image/compare.hpp"
#include "image/oiio.hpp"
#include "image/write.hpp"
#include "test_image_support.hpp"

#include <chrono>
#include <sys/stat.h>
#include <thread>

namespace {

using namespace image_tests;

// As wide as high, each quarter of its own colour, so that lossy formats show top, left and channels too.
Frame quarters() {
    Frame frame = {64, 64, Floats(64 * 64 * 3)};
    for (std::size_t i = 0; i < 64 * 64; ++i) {
        const bool right = i % 64 >= 32;
        const bool bottom = i / 64 >= 32;
        const float values[] = {right ? 1.0F : 0.0F, bottom ? 1.0F : 0.0F, right == bottom ? 0.5F : 0.0F};
        std::copy_n(values, 3, std::get<Floats>(frame.pixels).begin() + static_cast<std::ptrdiff_t>(i * 3));
    }
    return frame;
}

bool sameBits(const Floats& a, const Floats& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

const Floats& floatsOf(const Frame& frame) { return std::get<Floats>(frame.pixels); }

TEST_F(Image, CodesComeBackExactly) {
    for (const std::string name : {"a.png", "a.PnG", "a.tif", "a.bmp", "a.exr"}) {
        image::write(name, codes(), {});
        const Frame read = image::readFrame(name);
        EXPECT_EQ(read.width, 17);
        EXPECT_EQ(read.height, 31);
        EXPECT_EQ(image::toBytes(read), std::get<Bytes>(codes().pixels)) << name;
        EXPECT_TRUE(sameBits(floatsOf(read), image::toFloats(codes()))) << name;
    }
}

TEST_F(Image, FloatsComeBackBitForBit) {
    for (const std::string name : {"a.exr", "a.EXR", "a.tif"}) {
        image::write(name, wildFloats(), {});
        EXPECT_TRUE(sameBits(floatsOf(image::readFrame(name)), floatsOf(wildFloats()))) << name;
    }
    image::write("nan.exr", {1, 1, Floats{notANumber, 1, 2}}, {});
    EXPECT_TRUE(std::isnan(floatsOf(image::readFrame("nan.exr"))[0]));
}

TEST_F(Image, PfmIsHeaderAndFloatsFromBelow) {
    image::write("a.pfm", {2, 2, Floats{1, 2, 3, 4, 5, 6, 7, 8, -infinite, 10, 11, 12}},
                 {{"lesson", "none"}});
    const Floats stored = {7, 8, -infinite, 10, 11, 12, 1, 2, 3, 4, 5, 6};
    std::string expected = "PF\n2 2\n-1.0\n";
    expected.append(reinterpret_cast<const char*>(stored.data()), stored.size() * sizeof(float));
    EXPECT_EQ(contents("a.pfm"), expected);
    image::write("b.PFM", wildFloats(), {});
    EXPECT_EQ(contents("b.PFM").size(),
              std::string("PF\n13 40\n-1.0\n").size() + 13 * 40 * 3 * sizeof(float));
    image::write("codes.pfm", codes(), {});
    image::write("floats.pfm", {17, 31, image::toFloats(codes())}, {});
    EXPECT_EQ(contents("codes.pfm"), contents("floats.pfm"));
}

TEST_F(Image, FloatsToCodes) {
    const float half = 0.5F;  // 127.5, a true half: to the even 128; its neighbour below goes down
    const Frame frame = {
        3, 1,
        Floats{half, std::nextafter(half, 0.0F), 1.0F / 255, -1, 2, -0.0F, infinite, -infinite, 0.999F}};
    const Bytes expected = {128, 127, 1, 0, 255, 0, 255, 0, 255};
    EXPECT_EQ(image::toBytes(frame), expected);
    image::write("a.png", frame, {});
    EXPECT_EQ(image::toBytes(image::readFrame("a.png")), expected);
}

TEST_F(Image, TopRowFirstInEveryFormat) {
    for (const std::string& extension : extensions) {
        image::write("a" + extension, quarters(), {});
        const Frame read = image::readFrame("a" + extension);
        ASSERT_EQ(floatsOf(read).size(), floatsOf(quarters()).size()) << extension;
        for (const std::size_t pixel : {16U * 64 + 16, 16U * 64 + 48, 48U * 64 + 16, 48U * 64 + 48}) {
            for (std::size_t i = pixel * 3; i < pixel * 3 + 3; ++i) {
                EXPECT_NEAR(floatsOf(read)[i], floatsOf(quarters())[i], 0.04) << extension << " number " << i;
            }
        }
    }
}

TEST_F(Image, MetadataComesBack) {
    const Metadata metadata = {{"lesson", "lesson_04_ambient"},
                               {"terms", "D,n.w"},
                               {"renderer", "un più veloce"},
                               {"version", "0.1.0"}};
    for (const std::string name : {"a.png", "a.exr"}) {
        image::write(name, codes(), metadata);
        const Metadata read = image::readMetadata(name);
        for (const auto& pair : metadata) {
            EXPECT_EQ(std::count(read.begin(), read.end(), pair), 1) << name << " " << pair.first;
        }
    }
    // What is beyond ASCII needs PNG's international chunk, as its plain one holds Latin-1.
    EXPECT_NE(contents("a.png").find("iTXtrenderer"), std::string::npos);
    EXPECT_NE(contents("a.png").find("tEXtlesson"), std::string::npos);

    image::write("a.tif", codes(), metadata);
    const std::pair<std::string, std::string> whole = {
        "ImageDescription",
        "lesson: lesson_04_ambient\nterms: D,n.w\nrenderer: un più veloce\nversion: 0.1.0"};
    const Metadata read = image::readMetadata("a.tif");
    EXPECT_EQ(std::count(read.begin(), read.end(), whole), 1);
}

TEST_F(Image, SameBytesLater) {
    const Metadata metadata = {{"lesson", "x"}};
    const auto writeAll = [&](const std::string& stem) {
        for (const std::string& extension : extensions) {
            image::write(stem + extension, quarters(), metadata);
        }
    };
    writeAll("first");
    // Formats that note the time do so in seconds.
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    writeAll("second");
    for (const std::string& extension : extensions) {
        EXPECT_EQ(contents("first" + extension), contents("second" + extension)) << extension;
        EXPECT_GT(contents("first" + extension).size(), 100U) << extension;
    }
}

TEST_F(Image, ReplacesFilesAndFollowsLinks) {
    putContents("old.png", "old");
    fs::create_symlink("old.png", "link.png");
    image::write("link.png", codes(), {});
    EXPECT_TRUE(fs::is_symlink("link.png"));
    EXPECT_EQ(image::toBytes(image::readFrame("old.png")), std::get<Bytes>(codes().pixels));
    EXPECT_EQ(files(), (std::vector<std::string>{"link.png", "old.png"}));

    const mode_t mask = ::umask(027);
    image::write("new.png", codes(), {});
    ::umask(mask);
    EXPECT_EQ(fs::status("new.png").permissions(), fs::perms(0640));
}

TEST_F(Image, ReadsGreyAndDropsAlpha) {
    putContents("grey.pgm", std::string("P5 2 1 255\n") + '\x10' + '\xff');
    EXPECT_EQ(image::toBytes(image::readFrame("grey.pgm")), (Bytes{16, 16, 16, 255, 255, 255}));

    // TGA, uncompressed, 1x1, 32 bits with 8 of alpha: blue, green, red, alpha.
    const char header[18] = {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 32, 0x28};
    putContents("alpha.tga", std::string(header, 18) + '\x30' + '\x20' + '\x64' + '\x01');
    EXPECT_EQ(image::toBytes(image::readFrame("alpha.tga")), (Bytes{100, 32, 48}));
}

TEST_F(Image, DifferencePicture) {
    const Frame expected = {1, 2, Bytes{10, 20, 30, 40, 50, 60}};
    const Frame found = {1, 2, Bytes{11, 20, 27, 40, 50, 60}};
    image::writeDifferencePicture("a.png", expected, found, 20);
    const Frame read = image::readFrame("a.png");
    EXPECT_EQ(read.width, 3);
    EXPECT_EQ(read.height, 2);
    EXPECT_EQ(image::toBytes(read),
              (Bytes{10, 20, 30, 11, 20, 27, 20, 0, 60, 40, 50, 60, 40, 50, 60, 0, 0, 0}));

    // PNG holds no NaN: magenta instead.
    image::writeDifferencePicture("a.png", {1, 1, Floats{0.5F, 0.5F, 0.5F}},
                                  {1, 1, Floats{0.5F, notANumber, 0.5F}}, 1);
    EXPECT_EQ(image::toBytes(image::readFrame("a.png")), (Bytes{128, 128, 128, 255, 0, 255, 255, 0, 255}));
}

}  // namespace
