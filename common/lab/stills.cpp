// Frames without a window: written, timed, counted, dumped.
// SPDX-License-Identifier: MIT
#include "lab/stills.hpp"

#include "image/write.hpp"
#include "lab/equation.hpp"
#include "lab/stats.hpp"
#include "render/context.hpp"
#include "render/gl_renderer.hpp"
#include "render/reference_renderer.hpp"
#include "render/shader_source.hpp"
#include "three/object_loader.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <set>
#include <unistd.h>

namespace lab {

namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// Formats that keep more than 8 bits get the float frame.
bool wantsFloats(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension == ".exr" || extension == ".tif" || extension == ".tiff" || extension == ".hdr";
}

image::Metadata metadata(const Options& options, lighting::TermSet terms, const std::string& renderer) {
    return {{"lesson", options.lesson},
            {"terms", terms.text()},
            {"equation", equationText(terms)},
            {"renderer", renderer},
            {"version", LAMBERT_VERSION}};
}

void dumpShaders(const lighting::FramePlan& plan, const std::string& directory) {
    std::set<lighting::Variant> seen;
    for (const lighting::Draw& draw : plan.draws)
        if (seen.insert(draw.variant).second)
            std::cout << "// ==== variant: " << variantText(draw.variant) << '\n'
                      << render::dumpShaders(directory, draw.variant);
}

// A bar on stderr for what takes longer than two seconds, where somebody looks.
class Progress {
  public:
    explicit Progress(int total) : total_(total) {}
    ~Progress() {
        if (shown_)
            std::cerr << '\n';
    }
    void step(int done) {
        if (millisecondsSince(start_) < 2000 || isatty(STDERR_FILENO) == 0)
            return;
        constexpr int width = 40;
        const int filled = static_cast<int>(static_cast<long long>(width) * done / total_);
        if (filled == filled_)
            return;
        filled_ = filled;
        shown_ = true;
        std::cerr << "\r[" << std::string(static_cast<std::size_t>(filled), '#')
                  << std::string(static_cast<std::size_t>(width - filled), ' ') << "] " << done << '/'
                  << total_ << std::flush;
    }

  private:
    int total_;
    int filled_ = -1;
    bool shown_ = false;
    Clock::time_point start_ = Clock::now();
};

// The renderer that the command line asks for, with the context it needs.
class Drawing {
  public:
    explicit Drawing(const Options& options) {
        if (options.renderer == RendererKind::reference) {
            renderer_ = std::make_unique<render::ReferenceRenderer>(
                [this](double share) { progress_.step(static_cast<int>(share * 1000)); });
        } else {
            context_.emplace();
            renderer_ = std::make_unique<render::GlRenderer>(render::findShaderDirectory(options.shaders));
        }
    }
    render::Renderer& renderer() { return *renderer_; }

  private:
    Progress progress_{1000};
    std::optional<render::HeadlessContext> context_;
    std::unique_ptr<render::Renderer> renderer_;
};

std::vector<double> timeFrames(View& view, render::Renderer& renderer, const render::FrameRequest& request,
                               const Options& options) {
    std::vector<double> times;
    Progress progress(options.frames);
    for (int i = 0; i < options.frames; ++i) {
        const Clock::time_point start = Clock::now();
        view.update(options.time, request.width, request.height);
        renderer.renderOnly(view.scene(), view.camera(), view.settings(options.terms), request);
        times.push_back(millisecondsSince(start));
        progress.step(i + 1);
    }
    return times;
}

void tellTimes(std::vector<double> times, const render::FrameRequest& request) {
    std::sort(times.begin(), times.end());
    std::cout << times.size() << " frames of " << request.width << 'x' << request.height << ": median "
              << times[times.size() / 2] << " ms, fastest " << times.front() << ", slowest " << times.back()
              << '\n';
}

}  // namespace

void writePicture(View& view, render::Renderer& renderer, const std::string& path, double time,
                  lighting::TermSet terms, int width, int height, const Options& options) {
    view.update(time, width, height);
    const image::Frame frame = renderer.render(view.scene(), view.camera(), view.settings(terms),
                                               {width, height, wantsFloats(path)});
    image::write(path, frame, metadata(options, terms, renderer.name()));
}

void runStills(View& view, const Options& options) {
    const render::FrameRequest request{options.width.value_or(512), options.height.value_or(512),
                                       wantsFloats(options.frame)};
    view.update(options.time, request.width, request.height);
    if (!options.dumpScene.empty())
        image::writeText(options.dumpScene, THREE::toJSON(view.scene(), &view.camera()));
    if (options.dumpShader)
        dumpShaders(view.plan(options.terms), render::findShaderDirectory(options.shaders));
    if (options.frame.empty() && options.frames == 0 && !options.stats)
        return;

    Drawing drawing(options);
    render::Renderer& renderer = drawing.renderer();
    lighting::Settings settings = view.settings(options.terms);
    const Clock::time_point start = Clock::now();
    const image::Frame frame = renderer.render(view.scene(), view.camera(), settings, request);
    StatsReport report{renderer.name(),
                       request.width,
                       request.height,
                       millisecondsSinceProcessStart(),
                       {millisecondsSince(start)}};
    render::FrameStats stats = renderer.stats();
    if (!options.frame.empty())
        image::write(options.frame, frame, metadata(options, options.terms, report.renderer));
    if (options.frames > 0) {
        report.frameMilliseconds = timeFrames(view, renderer, request, options);
        if (!options.stats)
            tellTimes(report.frameMilliseconds, request);
    }
    if (options.stats) {
        if (!stats.nonfinite) {
            // Counted by a shader of its own, so that neither the picture nor its time is that shader's.
            settings.countNonfinite = true;
            renderer.render(view.scene(), view.camera(), settings, request);
            stats.nonfinite = renderer.stats().nonfinite;
        }
        std::cout << statsJson(report, stats) << '\n';
    }
}

}  // namespace lab
