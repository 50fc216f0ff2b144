// What the reference costs: the lessons' knot under 64 lights, against a bare loop in scalar doubles over the same pixels and
// lights, in turns.
// SPDX-License-Identifier: MIT
//
//   bench_reference DIR [--quick | --smoke]     writes DIR/reference.json, .csv
//
// Measured is processor time, because the reference uses all cores and the bare loop one.
#include "bench/report.hpp"
#include "lighting/reference/reference.hpp"
#include "three/three.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <memory>
#include <mutex>

namespace {

using lighting::reference::Reference;

constexpr int lightCount = 64;

double processorNanoseconds() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) * 1e9 + static_cast<double>(t.tv_nsec);
}

// The same pixels under the same lights without vector instructions, points and normals from a table, no light left out.
class BareLoop {
  public:
    explicit BareLoop(const Reference<double>& reference) {
        std::mutex mutex;
        reference.surfaces([&](int, int, const std::optional<lighting::reference::Surface<double>>& s) {
            const std::lock_guard<std::mutex> lock(mutex);
            if (s)
                surface_.insert(surface_.end(), {s->Q.x, s->Q.y, s->Q.z, s->n.x, s->n.y, s->n.z});
        });
        for (const auto& light : reference.equation().pointLights)
            lights_.insert(lights_.end(),
                           {light.place.x, light.place.y, light.place.z, light.L.x, light.L.y, light.L.z});
        out_.resize(surface_.size() / 2);
    }
    std::size_t pixels() const { return surface_.size() / 6; }
    void run() {
        for (std::size_t p = 0; p < pixels(); ++p) {
            const double* const s = &surface_[p * 6];
            double r = 0, g = 0, b = 0;
            for (std::size_t i = 0; i < lights_.size(); i += 6) {
                const double* const l = &lights_[i];
                const double x = l[0] - s[0], y = l[1] - s[1], z = l[2] - s[2];
                const double d2 = x * x + y * y + z * z, nv = s[3] * x + s[4] * y + s[5] * z;
                const double share = std::max(0.0, nv / (d2 * std::sqrt(d2)));
                r += share * l[3];
                g += share * l[4];
                b += share * l[5];
            }
            out_[p * 3] = r;
            out_[p * 3 + 1] = g;
            out_[p * 3 + 2] = b;
        }
    }
    double checksum() const { return out_[out_.size() / 2]; }

  private:
    std::vector<double> surface_, lights_, out_;
};

void measure(const bench::Options& options) {
    const int size = options.smoke ? 64 : 512, rounds = options.smoke ? 2 : options.quick ? 5 : 15;
    THREE::Scene scene;
    THREE::TorusKnotGeometry geometry(0.9, 0.34, 400, 64);
    THREE::MeshLambertMaterial material(THREE::Color(0xFF8855));
    THREE::Mesh mesh(geometry, material);
    scene.add(mesh);
    std::vector<std::unique_ptr<THREE::PointLight>> lights;
    for (int i = 0; i < lightCount; ++i) {
        lights.push_back(std::make_unique<THREE::PointLight>(THREE::Color(0xDD6666), 0.1, 0, 2));
        lights.back()->position.set(4 * std::cos(i * 2.4), 3 * std::sin(i * 0.7), 4 * std::sin(i * 2.4));
        scene.add(*lights.back());
    }
    THREE::PerspectiveCamera camera(36);
    camera.position.set(0, 0, 4.4);  // the knot fills the picture
    camera.lookAt(0, 0, 0);

    const Reference<double> reference(scene, camera, lighting::TermSet::all(), size, size);
    std::vector<double> red(static_cast<std::size_t>(size * size));
    std::vector<double> ours, bare;
    BareLoop loop(reference);
    const double perPixelLight = 1 / (static_cast<double>(loop.pixels()) * lightCount);
    for (int round = 0; round < rounds; ++round) {
        double start = processorNanoseconds();
        reference.draw(
            [&](int x, int y, const glm::dvec3& P) { red[static_cast<std::size_t>(y * size + x)] = P.x; });
        ours.push_back((processorNanoseconds() - start) * perPixelLight);
        start = processorNanoseconds();
        loop.run();
        bare.push_back((processorNanoseconds() - start) * perPixelLight);
    }
    std::fprintf(stderr, "   %zu pixels covered, checksum %g\n", loop.pixels(), loop.checksum());
    bench::Report report("reference", "none: doubles on the CPU");
    report.add("reference under 64 lights", bench::median(ours), "ns per pixel and light");
    report.add("bare loop in scalar doubles", bench::median(bare), "ns per pixel and light");
    report.add("reference to bare loop", bench::median(ours) / bench::median(bare), "ratio");
    report.write(options.out);
}

}  // namespace

int main(int count, char** arguments) {
    return bench::guarded("bench_reference", measure, bench::readOptions(count, arguments));
}
