// Frames without a window: written, timed, counted, dumped.
// SPDX-License-Identifier: MIT
#include "lab/stills.hpp"

#include "image/write.hpp"
#include "lab/light_cost.hpp"
#include "lab/live/picture.hpp"
#include "lab/progress.hpp"
#include "lab/stats.hpp"
#include "render/gl_renderer.hpp"
#include "render/shader_source.hpp"
#include "three/object_loader.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <set>

namespace lab {

namespace {

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
image::Frame drawFrame(const Session& session, std::span<const Side> sides, const Options& options,
                       Renderers& renderers, const render::FrameRequest& request, Phases& phases,
                       StatsReport& report) {
    render::Renderer& renderer = renderers.get(options);
    phases.mark("context");
    const double compiledBefore = renderer.stats().compileMilliseconds;
    Options byReference = options;
    byReference.renderer = RendererKind::reference;
    const bool differs = session.mode == lighting::ViewMode::difference;
    image::Frame frame =
        drawPicture(session, sides, renderer, differs ? renderers.get(byReference) : renderer, request);
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

// The picture of a session, and everything else that the options ask for.
void drawSession(Session& session, View* before, const Options& options, Renderers& renderers,
                 Phases& phases) {
    View& view = session.view();
    const render::FrameRequest request{options.width.value_or(512), options.height.value_or(512),
                                       wantsFloats(options.frame)};
    session.update(request.width, request.height);
    follow(session, before, request.width, request.height);
    phases.mark("scene");
    if (!options.dumpScene.empty())
        image::writeText(options.dumpScene, THREE::toJSON(view.scene(), &view.camera()));
    const std::vector<Side> sides = session.sides(request.width, before);
    if (options.dumpShader)
        dumpShaders(lighting::planFrame(view.scene(), view.camera(), session.settings()),
                    render::findShaderDirectory(options.shaders));
    if (options.frame.empty() && options.frames == 0 && !options.stats)
        return;
    StatsReport report;
    const image::Frame frame = drawFrame(session, sides, options, renderers, request, phases, report);
    render::Renderer& renderer = renderers.get(options);
    renderers.pictureIsDrawn();
    const render::FrameStats stats = renderer.stats();
    if (!options.frame.empty()) {
        image::write(options.frame, frame, metadata(session, renderer, options.lesson));
        phases.mark("write");
    }
    report.phases = phases;
    if (options.frames > 0)
        timeFrames(view, options, renderer, request, report);
    if (options.stats)
        tellStats(view, options, renderers, request, stats, report);
    else if (!options.frame.empty())
        tellReadings(view.controls(), options.language);
    if (view.lightCut > 0 && !options.stats)
        tellCut(stats, options);
}

}  // namespace

void drawStill(View& view, const Options& wanted, Renderers& renderers, Phases& phases) {
    Session session(view, wanted);
    Options options = wanted;  // and what a saved state says in their place
    options.switches = session.switches;
    options.renderer = session.renderer;
    options.time = session.time;
    withLessonBefore(session, options.lesson,
                     [&](View* before) { drawSession(session, before, options, renderers, phases); });
}

}  // namespace lab
