// Unit tests of frames that cannot be written or read: what the message says, and that nothing is left.
// SPDX-License-Identifier: MIT
#include "image/oiio.hpp"
#include "image/write.hpp"
#include "test_image_support.hpp"

#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>

namespace {

using namespace image_tests;
using ImageErrors = Image;

// The message of the error that writing must end with.
std::string errorOf(const std::string& path, const Frame& frame = codes(), const Metadata& metadata = {}) {
    try {
        image::write(path, frame, metadata);
    } catch (const image::Error& error) {
        return error.what();
    }
    return "no error";
}

std::string readErrorOf(const std::string& path) {
    try {
        image::readFrame(path);
    } catch (const image::Error& error) {
        return error.what();
    }
    return "no error";
}

void expectHas(const std::string& text, const std::vector<std::string>& parts) {
    for (const std::string& part : parts) {
        EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in: " << text;
    }
}

TEST_F(ImageErrors, PathsThatCannotBeWritten) {
    fs::create_directory("dir.png");
    putContents("file", "x");
    ASSERT_EQ(::mkfifo("pipe.png", 0600), 0);
    fs::create_symlink(
        "pipe.png", "link.png");  // never a device of the machine: as root, a broken check would replace it
    const auto before = files();
    expectHas(errorOf(""), {"cannot write ''", "the path is empty", "expected a file name"});
    expectHas(errorOf("dir.png"), {"'dir.png'", "it is a directory", "dir.png/frame.png"});
    expectHas(errorOf("new.png/"), {"it is a directory"});
    expectHas(errorOf("none/a.png"),
              {"'none/a.png'", "No such file or directory", "directory 'none'", "create it"});
    expectHas(errorOf("file/a.exr"), {"'file/a.exr'", "Not a directory"});
    expectHas(errorOf("pipe.png"), {"a device, a pipe or a socket", "expected a regular file"});
    expectHas(errorOf("link.png"), {"a device, a pipe or a socket"});
    expectHas(errorOf("frame"), {"'frame'", "no extension", "expected .png", "add one"});
    expectHas(errorOf(".png"), {"no extension"});
    expectHas(errorOf("a."), {"no extension"});
    expectHas(errorOf("a.xyz"), {"'a.xyz'", "extension .xyz", ".tif", "choose one"});
    expectHas(errorOf("a.fits"), {"extension .fits"});  // OpenImageIO's writer does not notice a full disk
    expectHas(errorOf("a.jp2"), {"extension .jp2"});  // nor this one that it encoded nothing
    expectHas(errorOf(std::string(300, 'a') + ".png"), {"File name too long", "choose another name"});
    EXPECT_EQ(files(), before);
}

TEST_F(ImageErrors, ProtectedDirectoryAndFile) {
    putContents("a.png", "old");
    fs::permissions("a.png", fs::perms(0444));
    fs::permissions(".", fs::perms(0555));
    const bool root = ::geteuid() == 0;  // whom nothing stops
    ASSERT_TRUE(!root || ::setresuid(65534, 65534, 0) == 0);
    const std::string directoryError = errorOf("b.png");
    const std::string fileError = errorOf("a.png");
    ASSERT_TRUE(!root || ::setresuid(0, 0, 0) == 0);
    fs::permissions(".", fs::perms(0755));
    expectHas(directoryError, {"'b.png'", "Permission denied", "directory '.' that you may write to"});
    expectHas(fileError, {"'a.png'", "Permission denied", "expected a file that you may replace"});
    EXPECT_EQ(files(), std::vector<std::string>{"a.png"});
    EXPECT_EQ(contents("a.png"), "old");
}

// A limit on the size of files fails as a full disk does: some bytes go in, then no more.
TEST_F(ImageErrors, FullDiskInEveryFormat) {
    rlimit limit = {};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    for (const std::string& extension : extensions) {
        const std::string name = "a" + extension;
        image::write(name, wildFloats(), {});
        const rlim_t whole = fs::file_size(name);
        for (const rlim_t bytes : {rlim_t(0), rlim_t(100), whole - 1}) {
            putContents(name, "old");
            const rlimit small = {bytes, limit.rlim_max};
            ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
            const std::string error = errorOf(name, wildFloats());
            ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
            expectHas(error, {"'" + name + "'", "File too large while writing", "free space on that disk"});
            EXPECT_EQ(contents(name), "old") << bytes << " of " << whole;
        }
    }
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(files().size(), extensions.size());
}

TEST_F(ImageErrors, FramesThatCannotBeWritten) {
    Frame bad = {4, 3, Floats(36)};
    std::get<Floats>(bad.pixels)[(2 * 4 + 1) * 3 + 1] = notANumber;
    for (const std::string name : {"a.png", "a.jpg"}) {
        expectHas(errorOf(name, bad), {name, "pixel (1, 2) is NaN in G", "write an .exr"});
    }
    expectHas(errorOf("a.png", {2, 2, Bytes(11)}), {"2x2 but holds 11 numbers", "expected 12"});
    expectHas(errorOf("a.exr", {0, 5, Floats()}), {"0x5", "at least 1x1"});
    expectHas(errorOf("a.exr", {-1, -1, Floats(3)}), {"-1x-1"});
    expectHas(errorOf("a.jpg", {65501, 1, Bytes(65501 * 3)}), {"larger than 65500"});
    expectHas(errorOf("a.png", codes(), {{"", "x"}}), {"metadata key ''"});
    expectHas(errorOf("a.exr", codes(), {{"a b", "x"}}), {"metadata key 'a b'"});
    expectHas(errorOf("a.png", codes(), {{std::string(80, 'k'), "x"}}), {"1 to 79"});
    expectHas(errorOf("a.png", codes(), {{"key", std::string("a\0b", 3)}}), {"value of 'key' holds a NUL"});
    EXPECT_TRUE(files().empty());
}

TEST_F(ImageErrors, FilesThatCannotBeRead) {
    putContents("text.png", "this is no picture");
    putContents("huge.ppm", "P6 20000 1 255\n");
    // A FITS cube of 5x4 pixels and three channels, for which OpenImageIO makes one name.
    std::string cube;
    for (const auto& [key, value] : Metadata{{"SIMPLE", "T"},
                                             {"BITPIX", "8"},
                                             {"NAXIS", "3"},
                                             {"NAXIS1", "3"},
                                             {"NAXIS2", "5"},
                                             {"NAXIS3", "4"}}) {
        const std::string card = key + std::string(8 - key.size(), ' ') + "=" + std::string(20, ' ') + value;
        cube += card + std::string(80 - card.size(), ' ');
    }
    cube += "END";
    putContents("cube.fits", cube + std::string(2880 - cube.size(), ' ') + std::string(2880, '\0'));
    image::write("whole.exr", wildFloats(), {});
    putContents("cut.exr", contents("whole.exr").substr(0, 700));
    expectHas(readErrorOf("none.png"), {"cannot read 'none.png'", "No such file or directory"});
    expectHas(readErrorOf("."), {"cannot read '.'", "not a regular file"});
    expectHas(readErrorOf("text.png"), {"cannot read 'text.png'", "expected a picture"});
    expectHas(readErrorOf("huge.ppm"), {"'huge.ppm'", "it is 20000x1", "16384"});
    expectHas(readErrorOf("cut.exr"), {"cannot read 'cut.exr'", "complete"});
    EXPECT_EQ(image::readFrame("cube.fits").width, 5);  // and the process goes on
}

}  // namespace
