// Frames without a window: written, timed, counted, dumped.
// SPDX-License-Identifier: MIT
#include "lab/stills.hpp"

#include "image/write.hpp"
#include "lab/equation.hpp"
#include "lab/light_cost.hpp"
#include "lab/stats.hpp"
#include "lab/switches.hpp"
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

image::Metadata metadata(const Options& options, const View& view, const lighting::Switches& switches,
                         const render::Renderer& renderer) {
    image::Metadata all{{"lesson", options.lesson},
                        {"terms", switches.terms.text()},
                        {"equation", equationText(switches.terms, renderer.stats().shiny)},
                        {"renderer", renderer.name()},
                        {"version", LAMBERT_VERSION}};
    if (const std::string text = switchesText(switches); !text.empty())
        all.emplace_back("switches", text);
    if (!view.controls().sliders().empty())
        all.emplace_back("sliders", view.controls().text());
    return all;
}

void tellReadings(const Controls& controls, Language language) {
    for (const Reading& reading : controls.readings)
        std::cout << say(reading.label, language) << ": " << valueText(reading.value) << '\n';
}

void dumpShaders(const lighting::FramePlan& plan, const std::string& directory) {
    std::set<lighting::Variant> seen;
    for (const lighting::Draw& draw : plan.draws)
        if (seen.insert(draw.variant).second)
            std::cout << "// ==== variant: " << variantText(draw.variant) << '\n'
                      << render::dumpShaders(directory, plan, draw);
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

void tellTimes(const LightCost& cost, const render::FrameRequest& request) {
    const auto [fastest, slowest] = std::minmax_element(cost.with.begin(), cost.with.end());
    std::cout << cost.with.size() << " frames of " << request.width << 'x' << request.height << ": median "
              << median(cost.with) << " ms, fastest " << *fastest << ", slowest " << *slowest << "; "
              << cost.lights << " lights, each " << cost.each() << " ms\n";
}

}  // namespace

void writePicture(View& view, render::Renderer& renderer, const std::string& path, double time,
                  const lighting::Switches& switches, int width, int height, const Options& options) {
    view.update(time, width, height);
    const image::Frame frame = renderer.render(view.scene(), view.camera(), view.settings(switches),
                                               {width, height, wantsFloats(path)});
    image::write(path, frame, metadata(options, view, switches, renderer));
}

void runStills(View& view, const Options& options) {
    const render::FrameRequest request{options.width.value_or(512), options.height.value_or(512),
                                       wantsFloats(options.frame)};
    view.update(options.time, request.width, request.height);
    if (!options.dumpScene.empty())
        image::writeText(options.dumpScene, THREE::toJSON(view.scene(), &view.camera()));
    if (options.dumpShader)
        dumpShaders(view.plan(options.switches), render::findShaderDirectory(options.shaders));
    if (options.frame.empty() && options.frames == 0 && !options.stats)
        return;

    Drawing drawing(options);
    render::Renderer& renderer = drawing.renderer();
    lighting::Settings settings = view.settings(options.switches);
    const Clock::time_point start = Clock::now();
    const image::Frame frame = renderer.render(view.scene(), view.camera(), settings, request);
    StatsReport report{renderer.name(),
                       request.width,
                       request.height,
                       millisecondsSinceProcessStart(),
                       {millisecondsSince(start)},
                       view.controls(),
                       {}};
    render::FrameStats stats = renderer.stats();
    if (!options.frame.empty())
        image::write(options.frame, frame, metadata(options, view, options.switches, renderer));
    if (!options.frame.empty() && !options.stats)
        tellReadings(view.controls(), options.language);
    if (options.frames > 0) {
        Progress progress(options.frames);
        const LightCost cost = measureLights(view, renderer, options.switches, options.time, request,
                                             options.frames, [&progress](int done) { progress.step(done); });
        report.frameMilliseconds = cost.with;
        report.millisecondsPerLight = cost.each();
        if (!options.stats)
            tellTimes(cost, request);
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
