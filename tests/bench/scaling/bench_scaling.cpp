// How a frame's time grows with lights, triangles, pixels and meshes, and how the driver's own floor does.
// SPDX-License-Identifier: MIT
//
//   bench_scaling DIR [--quick | --smoke]       writes DIR/scaling.json, .csv, .benchmark.json
//
// The floor is a hand-written program's frame of the same meshes in one flat colour; both in random turns.
#include "bench/report.hpp"
#include "bench/scaling/fit.hpp"
#include "bench/scenes.hpp"
#include "bench/timing.hpp"
#include "render/context.hpp"
#include "render/error.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>

namespace {

using Clock = std::chrono::steady_clock;

std::string whole(double x) { return std::to_string(static_cast<long long>(x)); }

struct Bench {
    const bench::Options options;
    bench::Report report;
    bench::Timing timing;
    std::string csv = "series,x,frame_ms,floor_ms\n";

    /// As many as fit into some seconds.
    int rounds(double frameSeconds) const {
        const double seconds = options.quick ? 0.6 : 3;
        return options.smoke ? 2 : std::clamp(static_cast<int>(seconds / frameSeconds), 2, 25);
    }
    double slowestSeconds() const { return options.quick ? 0.3 : 2; }
    int size() const { return options.smoke ? 64 : 512; }
    /// The sizes up to the last that this run goes to.
    std::vector<int> steps(std::vector<int> all, int quickLast, int smokeLast) const {
        std::erase_if(all, [this, quickLast, smokeLast](int x) {
            return (options.smoke && x > smokeLast) || (options.quick && x > quickLast);
        });
        return all;
    }
};

// A curve: points are added as long as frames are not too slow, then it is fitted.
class Series {
  public:
    Series(Bench& bench, std::string name, std::string unit)
        : bench_(bench), name_(std::move(name)), unit_(std::move(unit)) {}
    /// Measures a point; false: the next one would take too long.
    bool add(double x, bench::Stage& stage, int width) {
        std::fprintf(stderr, "   %s: %g\n", name_.c_str(), x);
        bench::Ours ours(stage, width, width);
        const Clock::time_point start = Clock::now();
        try {
            ours.draw();
        } catch (const render::NoRenderer& error) {
            std::fprintf(stderr, "   left out: %s\n", error.what());
            return false;
        }
        const double first = std::chrono::duration<double>(Clock::now() - start).count();
        ours.settle();
        const Clock::time_point later = Clock::now();
        ours.draw();
        const double again = std::chrono::duration<double>(Clock::now() - later).count();
        bench::Probe floor(stage, width, width, bench::flatShader);
        const std::string point = name_ + " " + whole(x);
        const auto ms =
            bench_.timing.measure({{point, [&] { ours.draw(); }}, {point + ", floor", [&] { floor.draw(); }}},
                                  bench_.rounds(again));
        points_.push_back({x, ms.at(point)});
        floors_.push_back({x, ms.at(point + ", floor")});
        bench_.csv += name_ + "," + whole(x) + "," + bench::digits(points_.back().ms) + "," +
                      bench::digits(floors_.back().ms) + "\n";
        // A first frame may compile a shader, which is no reason to stop by itself.
        return points_.back().ms / 1000 < patience * bench_.slowestSeconds() &&
               first < 10 * bench_.slowestSeconds();
    }
    void finish() {
        bench_.csv += "\n\n";  // gnuplot's mark between data sets
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const std::string x = name_ + " " + whole(points_[i].x);
            bench_.report.add(x, points_[i].ms, "ms");
            bench_.report.add(x + ", floor", floors_[i].ms, "ms");
        }
        if (points_.size() < 2)
            return;
        const bench::Line line = bench::fitLine(points_), floor = bench::fitLine(floors_);
        addSlope(": per ", line.slope);
        addSlope(": floor per ", floor.slope);
        bench_.report.add(name_ + ": exponent of the upper half", bench::fitExponent(points_),
                          "log-log slope");
    }

    double patience = 1;  ///< factor of the slowest frame after which the series goes on

  private:
    void addSlope(const std::string& what, double ms) {
        const bool large = std::abs(ms) >= 1;
        const bool small = std::abs(ms) < 1e-3;
        bench_.report.add(name_ + what + unit_,
                          large   ? ms
                          : small ? ms * 1e6
                                  : ms * 1e3,
                          large   ? "ms"
                          : small ? "ns"
                                  : "us");
    }
    Bench& bench_;
    std::string name_, unit_;
    std::vector<bench::Point> points_, floors_;
};

void lights(Bench& b) {
    const std::vector<int> numbers = b.steps(
        {1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192, 16384, 32768, 65536}, 65536, 16);
    THREE::TorusKnotGeometry knot(0.9, 0.34, b.options.smoke ? 60 : 400, b.options.smoke ? 12 : 64);
    THREE::MeshLambertMaterial material(THREE::Color(0xFF8855));
    const THREE::Vector3 half = knot.boundingBox().max;
    for (const bool reach : {false, true}) {
        Series series(b, reach ? "lights with a reach of 1/40" : "lights without end", "light");
        if (reach)
            series.patience =
                5;  // from some number on lights are sorted by where they reach, and frames get faster
        for (const int n : numbers) {
            bench::Stage stage;
            stage.mesh(knot, material);
            if (reach)
                stage.lightsWithin(n, half, knot.boundingSphere().radius / 20);
            else
                stage.lightsAround(n);
            if (!series.add(n, stage, b.size()))
                break;
        }
        series.finish();
    }
}

void triangles(Bench& b) {
    Series series(b, "triangles", "triangle");
    THREE::MeshLambertMaterial material(THREE::Color(0xFF8855));
    for (const int wanted :
         b.steps({1000, 3000, 10'000, 30'000, 100'000, 300'000, 1'000'000, 3'000'000, 10'000'000}, 300'000,
                 3000)) {
        const int meshes =
            wanted > 2'500'000 ? (wanted + 2'499'999) / 2'500'000 : 1;  // parametric geometries have an end
        const int around = std::max(6, static_cast<int>(std::sqrt(wanted / meshes / 12.5)));
        THREE::TorusKnotGeometry knot(0.9, 0.34, wanted / meshes / 2 / around, around);
        bench::Stage stage;
        for (int i = 0; i < meshes; ++i)
            stage.mesh(knot, material).rotation.y = i;
        stage.lectureLights();
        if (!series.add(static_cast<double>(knot.triangleCount()) * meshes, stage, b.size()))
            break;
    }
    series.finish();
}

void pixels(Bench& b) {
    Series series(b, "pixels", "pixel");
    THREE::TorusKnotGeometry knot(0.9, 0.34, 100, 16);
    THREE::MeshLambertMaterial material(THREE::Color(0xFF8855));
    for (const int side : b.steps({64, 128, 256, 512, 1024, 2048, 4096}, 1024, 128)) {
        bench::Stage stage;
        stage.mesh(knot, material);
        stage.lectureLights();
        if (!series.add(static_cast<double>(side) * side, stage, side))
            break;
    }
    series.finish();
}

void meshes(Bench& b) {
    Series series(b, "meshes", "mesh");
    THREE::BoxGeometry box(0.02, 0.02, 0.02);
    THREE::MeshLambertMaterial material(THREE::Color(0xFF8855));
    for (const int n : b.steps({1, 3, 10, 30, 100, 300, 1000, 3000, 10'000}, 3000, 10)) {
        bench::Stage stage;
        for (int i = 0; i < n; ++i)  // a spiral on a disc that faces the camera
            stage.mesh(box, material)
                .position.set(1.5 * std::sqrt((i + 0.5) / n) * std::cos(i * 2.399963),
                              1.5 * std::sqrt((i + 0.5) / n) * std::sin(i * 2.399963), 0);
        stage.lectureLights();
        if (!series.add(n, stage, b.size()))
            break;
    }
    series.finish();
}

void measure(const bench::Options& options) {
    const render::HeadlessContext context;
    bench::Stage nothing;
    Bench b{options, bench::Report("scaling", bench::Ours(nothing, 8, 8).renderer.name()), {}};
    pixels(b);
    meshes(b);
    triangles(b);
    lights(b);
    b.timing.write(options.out / "scaling.benchmark.json");
    b.report.write(options.out, b.csv);
}

}  // namespace

int main(int count, char** arguments) {
    return bench::guarded("bench_scaling", measure, bench::readOptions(count, arguments));
}
