// scene_viewer, with both renderers, against the float frames that three.js r146 drew of the same files.
// SPDX-License-Identifier: MIT
#include "image/compare.hpp"
#include "image/oiio.hpp"
#include "lighting/reference/reference.hpp"
#include "support/program.hpp"
#include "three/object_loader.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <tuple>

namespace {

const std::string folder = LAMBERT_SOURCE_DIR "/tests/threejs/";

class ThreeJs : public testing::TestWithParam<std::tuple<const char*, const char*>> {
  protected:
    // 1 away from edges, by the reference's own information
    static std::vector<std::uint8_t> mask(const std::string& scene) {
        THREE::LoadedScene loaded = THREE::ObjectLoader().load(scene);
        loaded.camera->aspect = 1;
        const lighting::reference::Reference<double> reference(*loaded.scene, *loaded.camera,
                                                               lighting::TermSet::all(), 256, 256);
        std::vector<std::uint8_t> away = reference.edges();
        for (std::uint8_t& pixel : away)
            pixel = pixel == 0 ? 1 : 0;
        return away;
    }
};

TEST_P(ThreeJs, TheSameFrame) {
    const std::string name = std::get<0>(GetParam()), renderer = std::get<1>(GetParam());
    const support::TemporaryDirectory directory;
    for (const char* file : {"f.exr", "f.png"}) {
        const support::Outcome drawn = support::run({"scene_viewer", folder + name + ".json", "--frame", file,
                                                     "--size", "256x256", "--renderer", renderer},
                                                    directory.path());
        ASSERT_EQ(drawn.status, 0) << drawn.err;
    }
    const image::Frame expected = image::readFrame(folder + name + ".exr");
    const std::vector<std::uint8_t> away = mask(folder + name + ".json");
    const auto compared = std::count(away.begin(), away.end(), 1);
    EXPECT_GT(compared, 256 * 256 * 85 / 100) << "too much is masked";

    const image::Difference floats =
        image::compare(expected, image::readFrame(directory.file("f.exr")), 1 / 255.0, away);
    // Measured: 7.4e-6 on llvmpipe (s03), 1.6e-5 with the reference (s05), less in all others.
    EXPECT_LT(floats.worst, 3e-5) << "pixel " << floats.x << ',' << floats.y;
    EXPECT_EQ(floats.above, 0U);

    image::Frame codes = expected;
    codes.pixels = image::toBytes(expected);
    const image::Difference bytes = image::compare(codes, image::readFrame(directory.file("f.png")), 0, away);
    EXPECT_LE(bytes.worst, 1.001 / 255) << "pixel " << bytes.x << ',' << bytes.y;
    if (HasFailure())
        image::writeDifferencePicture("difference_" + name + "_" + renderer + ".png", expected,
                                      image::readFrame(directory.file("f.exr")), 1000);
    std::cout << name << ", " << renderer << ": worst " << floats.worst << ", mean " << floats.mean
              << ", worst of 8 bit " << bytes.worst * 255 << " codes, " << 256 * 256 - compared
              << " of 65536 pixels masked\n";
}

INSTANTIATE_TEST_SUITE_P(
    r146, ThreeJs,
    testing::Combine(testing::Values("s01_dark", "s02_directional", "s03_point_decay0", "s04_point_decay2",
                                     "s05_point_decay1", "s06_dir_point", "s07_ambient", "s08_lez04"),
                     testing::Values("gl", "reference")),
    [](const auto& test) { return std::string(std::get<0>(test.param)) + "_" + std::get<1>(test.param); });

}  // namespace
