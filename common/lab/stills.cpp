// Frames without a window: written, timed, counted, dumped.
// SPDX-License-Identifier: MIT
#include "lab/stills.hpp"

#include "image/write.hpp"
#include "lab/equation.hpp"
#include "lab/light_cost.hpp"
#include "lab/progress.hpp"
#include "lab/stats.hpp"
#include "lab/switches.hpp"
#include "render/gl_renderer.hpp"
#include "render/shader_source.hpp"
#include "three/object_loader.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <set>

namespace lab {

namespace {

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

// What --light-cut promises: the only thing a frame may lack.
void tellCut(const render::FrameStats& stats, const Options& options) {
    std::cout << "--light-cut: "
              << say({"a nessun pixel mancano più di ", "no pixel lacks more than "}, options.language)
              << valueText(stats.cutCodes)
              << say({" codici a 8 bit, prima dell'arrotondamento\n", " 8-bit codes, before rounding\n"},
                     options.language);
}

void dumpShaders(const lighting::FramePlan& plan, const std::string& directory) {
    std::set<lighting::Variant> seen;
    for (const lighting::Draw& draw : plan.draws)
        if (seen.insert(draw.variant).second)
            std::cout << "// ==== variant: " << variantText(draw.variant) << '\n'
                      << render::dumpShaders(directory, plan, draw);
}

void tellTimes(const LightCost& cost, const render::FrameRequest& request) {
    const auto [fastest, slowest] = std::minmax_element(cost.with.begin(), cost.with.end());
    std::cout << cost.with.size() << " frames of " << request.width << 'x' << request.height << ": median "
              << median(cost.with) << " ms, fastest " << *fastest << ", slowest " << *slowest << "; "
              << cost.lights << " lights, each " << cost.each() << " ms\n";
}

// Draws the frame, and gives each part of the time a name. What the renderer does not name is drawing.
image::Frame drawFrame(View& view, const Options& options, render::Renderer& renderer,
                       const render::FrameRequest& request, Phases& phases, StatsReport& report) {
    const double compiledBefore = renderer.stats().compileMilliseconds;
    image::Frame frame =
        renderer.render(view.scene(), view.camera(), view.settings(options.switches), request);
    const double all = phases.lap();
    report.frameMilliseconds = {all};
    const render::FrameStats stats = renderer.stats();
    const double compile = stats.compileMilliseconds - compiledBefore;
    phases.add("plan", stats.planMilliseconds);
    phases.add("compile", compile);
    phases.add("draw",
               all - compile - stats.planMilliseconds - stats.finishMilliseconds - stats.readMilliseconds);
    phases.add("finish", stats.finishMilliseconds);
    phases.add("read", stats.readMilliseconds);
    return frame;
}

void timeFrames(View& view, const Options& options, render::Renderer& renderer,
                const render::FrameRequest& request, StatsReport& report) {
    Progress progress;
    const LightCost cost =
        measureLights(view, renderer, options.switches, options.time, request, options.frames, [&](int done) {
            progress.step(static_cast<double>(done) / options.frames,
                          std::to_string(done) + "/" + std::to_string(options.frames));
        });
    report.frameMilliseconds = cost.with;
    report.millisecondsPerLight = cost.each();
    if (!options.stats)
        tellTimes(cost, request);
}

void tellStats(View& view, const Options& options, Renderers& renderers, const render::FrameRequest& request,
               render::FrameStats stats, StatsReport& report) {
    render::Renderer& renderer = renderers.get(options);
    report.frame = options.frame;
    report.renderer = renderer.name();
    report.width = request.width;
    report.height = request.height;
    report.firstFrameMilliseconds =
        millisecondsSinceProcessStart() - renderers.millisecondsSinceFirstPicture();
    report.controls = view.controls();
    if (!stats.nonfinite) {
        // Counted by a shader of its own, so that neither the picture nor its time is that shader's.
        lighting::Settings settings = view.settings(options.switches);
        settings.countNonfinite = true;
        renderer.render(view.scene(), view.camera(), settings, request);
        stats.nonfinite = renderer.stats().nonfinite;
    }
    std::cout << statsJson(report, stats) << '\n';
}

}  // namespace

void writePicture(View& view, render::Renderer& renderer, const std::string& path, double time,
                  const lighting::Switches& switches, int width, int height, const Options& options) {
    view.update(time, width, height);
    const image::Frame frame = renderer.render(view.scene(), view.camera(), view.settings(switches),
                                               {width, height, wantsFloats(path)});
    image::write(path, frame, metadata(options, view, switches, renderer));
}

void drawStill(View& view, const Options& options, Renderers& renderers, Phases& phases) {
    const render::FrameRequest request{options.width.value_or(512), options.height.value_or(512),
                                       wantsFloats(options.frame)};
    view.update(options.time, request.width, request.height);
    phases.mark("scene");
    if (!options.dumpScene.empty())
        image::writeText(options.dumpScene, THREE::toJSON(view.scene(), &view.camera()));
    if (options.dumpShader)
        dumpShaders(view.plan(options.switches), render::findShaderDirectory(options.shaders));
    if (options.frame.empty() && options.frames == 0 && !options.stats)
        return;
    render::Renderer& renderer = renderers.get(options);
    phases.mark("context");
    StatsReport report;
    const image::Frame frame = drawFrame(view, options, renderer, request, phases, report);
    renderers.pictureIsDrawn();
    const render::FrameStats stats = renderer.stats();
    if (!options.frame.empty()) {
        image::write(options.frame, frame, metadata(options, view, options.switches, renderer));
        phases.mark("write");
    }
    report.phases = phases;
    if (options.frames > 0)
        timeFrames(view, options, renderer, request, report);
    if (options.stats)
        tellStats(view, options, renderers, request, stats, report);
    else if (!options.frame.empty())
        tellReadings(view.controls(), options.language);
    if (options.lightCut > 0 && !options.stats)
        tellCut(stats, options);
}

}  // namespace lab
