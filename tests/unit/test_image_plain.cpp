// The smallest program that links `image` and not OpenImageIO: writes a 2x2 frame to each given path.
// SPDX-License-Identifier: MIT
#include "image/write.hpp"

#include <cstdio>

int main(int argc, char** argv) {
    const image::Frame frame = {2, 2, image::Bytes{255, 0, 0, 0, 255, 0, 0, 0, 255, 9, 8, 7}};
    for (int i = 1; i < argc; ++i) {
        try {
            image::write(argv[i], frame, {{"lesson", "test"}});
        } catch (const image::Error& error) {
            std::fprintf(stderr, "%s\n", error.what());
            return 5;
        }
    }
    return 0;
}
