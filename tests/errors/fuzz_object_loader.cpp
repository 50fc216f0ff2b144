// Fuzzing of the scene loader: a spoilt file gives a scene or a SceneError, never a crash or another exception.
// SPDX-License-Identifier: MIT
#include "three/geometries.hpp"
#include "three/lights.hpp"
#include "three/object_loader.hpp"
#include "three/validate.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <iterator>
#include <random>
#include <string>
#include <unistd.h>

namespace {

int iterations() {
    const char* const wanted = std::getenv("LAMBERT_FUZZ_ITERATIONS");
    return wanted != nullptr ? std::atoi(wanted) : 300;
}

// Deterministic: the same spoilt files on every machine, whatever its standard library's distributions do.
class Spoiler {
  public:
    explicit Spoiler(unsigned seed) : random_(seed) {}

    std::string spoil(std::string text) {
        for (std::size_t i = 0, times = 1 + below(3); i < times && !text.empty(); ++i)
            once(text);
        return text;
    }

  private:
    std::size_t below(std::size_t end) { return static_cast<std::size_t>(random_() % end); }

    void once(std::string& text) {
        switch (below(6)) {
        case 0:
            text[below(text.size())] ^= static_cast<char>(1U << below(8));
            break;
        case 1:
            text.resize(below(text.size()));
            break;
        case 2:
            text.erase(below(text.size()), 1 + below(40));
            break;
        case 3:
            replaceNumber(text);
            break;
        case 4: {  // a piece of the file once more, somewhere else
            const std::string piece = text.substr(below(text.size()), 1 + below(60));
            text.insert(below(text.size()), piece);
            break;
        }
        default:
            replaceWord(text);
        }
    }

    // None that would be accepted as a number of segments and then fill the memory.
    void replaceNumber(std::string& text) {
        static const char* const numbers[] = {"-1",   "0",     "0.5", "1e9",  "1e36",       "-1e36", "1e300",
                                              "-0.0", "1e999", "3",   "null", "4294967296", "1e-300"};
        const std::size_t begin = text.find_first_of("0123456789", below(text.size()));
        if (begin == std::string::npos)
            return;
        const std::size_t end = std::min(text.find_first_not_of("0123456789.eE+-", begin), text.size());
        text.replace(begin, end - begin, numbers[below(std::size(numbers))]);
    }

    // A text by another of the same file: types, uuids and keys change places.
    void replaceWord(std::string& text) {
        const auto word = [&](std::size_t& begin, std::size_t& end) {
            begin = text.find('"', below(text.size()));
            end = begin == std::string::npos ? begin : text.find('"', begin + 1);
            return end != std::string::npos;
        };
        std::size_t begin = 0;
        std::size_t end = 0;
        if (!word(begin, end))
            return;
        const std::string taken = text.substr(begin, end - begin);
        if (word(begin, end))
            text.replace(begin, end - begin, taken);
    }

    std::mt19937 random_;
};

std::string richScene() {
    THREE::TorusKnotGeometry knot(1, 0.4, 5, 3);
    THREE::BoxGeometry box;
    THREE::SphereGeometry edited(1, 4, 3);
    edited.attributes.at("position").array[4] += 0.5;
    THREE::MeshLambertMaterial odd(THREE::Color(0.1, 2, 0.3));
    THREE::MeshBasicMaterial flat(THREE::Color(0x123456));
    THREE::Mesh a(knot, odd);
    THREE::Mesh b(box, flat);
    THREE::Mesh c(edited, odd);
    THREE::Group group;
    THREE::DirectionalLight sun;
    THREE::PointLight lamp;
    THREE::AmbientLight ambient;
    THREE::PerspectiveCamera camera;
    THREE::Scene scene;
    scene.background = THREE::Color(0.25, 0.5, 0.75);
    sun.target.position.set(1, 2, 3);
    b.rotation.set(0.1, 0.2, 0.3);
    group.add(a, b);
    scene.add(group, c, sun, lamp, ambient);
    return toJSON(scene, &camera);
}

// Loaded, or refused with a text that names the file; whatever loads must also stand being drawn or refused by name.
bool loads(const std::function<THREE::LoadedScene()>& load, const std::string& file) {
    try {
        THREE::LoadedScene loaded = load();
        EXPECT_NE(loaded.scene, nullptr);
        loaded.scene->updateMatrixWorld();
        THREE::PerspectiveCamera camera;
        try {
            THREE::validate(*loaded.scene, loaded.camera != nullptr ? *loaded.camera : camera);
            toJSON(*loaded.scene);
        } catch (const THREE::SceneError&) {
        }
        return true;
    } catch (const THREE::SceneError& error) {
        EXPECT_EQ(std::string(error.what()).find(file), 0U) << error.what();
        return false;
    }
}

TEST(FuzzObjectLoader, givesASceneOrASceneError) {
    const std::string good = richScene();
    ASSERT_TRUE(loads([&] { return THREE::ObjectLoader().parse(good, "scena.json"); }, "scena.json"));
    int loaded = 0;
    for (int i = 0; i < iterations(); ++i) {
        SCOPED_TRACE("iteration " + std::to_string(i));
        const std::string bad = Spoiler(static_cast<unsigned>(i)).spoil(good);
        loaded += loads([&] { return THREE::ObjectLoader().parse(bad, "scena.json"); }, "scena.json");
    }
    EXPECT_LT(loaded, iterations()) << "nothing was spoilt, so nothing was tested";
    EXPECT_GT(loaded, 0) << "everything was spoilt beyond the parser, so the loader was not tested";
}

TEST(FuzzObjLoader, givesASceneOrASceneError) {
    const std::string good =
        "o a\ns 1\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 2 0\nvt 0 1\nvn 0 0 1\n"
        "usemtl x\nf 1/1/1 2/1/1 3/1/1\ng b\nf 1 2 3 4\nf -1 -2 -3 -4 -5\nl 1 2\nt a 1/0/0 3\n";
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("lambert_fuzz_" + std::to_string(::getpid()) + ".obj");
    int loaded = 0;
    for (int i = 0; i < iterations(); ++i) {
        SCOPED_TRACE("iteration " + std::to_string(i));
        std::ofstream(file, std::ios::binary) << Spoiler(static_cast<unsigned>(i)).spoil(good);
        loaded += loads([&] { return THREE::loadObj(file.string()); }, file.string());
    }
    std::filesystem::remove(file);
    EXPECT_LT(loaded, iterations());
    EXPECT_GT(loaded, 0);
}

}  // namespace
