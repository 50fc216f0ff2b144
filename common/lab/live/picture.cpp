// Pictures of a session, into files.
// SPDX-License-Identifier: MIT
#include "lab/live/picture.hpp"

#include "image/write.hpp"
#include "lab/equation.hpp"
#include "lab/live/programs.hpp"
#include "lab/switches.hpp"
#include "render/difference_view.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace lab {

bool wantsFloats(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension == ".exr" || extension == ".pfm" || extension == ".tif" || extension == ".tiff" ||
           extension == ".hdr";
}

image::Frame drawSides(std::span<const Side> sides, render::Renderer& renderer,
                       const render::FrameRequest& request) {
    const auto frameOf = [&](const Side& side) {
        return renderer.render(side.view->scene(), side.view->camera(), side.settings, request);
    };
    image::Frame whole = frameOf(sides[0]);
    return sides.size() == 1 ? whole : render::sideBySide(whole, frameOf(sides[1]), sides[1].firstColumn);
}

image::Metadata metadata(const Session& session, const render::Renderer& renderer,
                         const std::string& program) {
    image::Metadata all{{"lesson", program},
                        {"terms", session.switches.terms.text()},
                        {"equation", equationText(session.switches.terms, renderer.stats().shiny)},
                        {"renderer", renderer.name()},
                        {"version", LAMBERT_VERSION}};
    if (const std::string text = switchesText(session.switches); !text.empty())
        all.emplace_back("switches", text);
    if (!session.view().controls().sliders().empty())
        all.emplace_back("sliders", session.view().controls().text());
    if (session.mode != lighting::ViewMode::final)
        all.emplace_back("view", lighting::info(session.mode).name);
    return all;
}

image::Frame drawPicture(const Session& session, std::span<const Side> sides, render::Renderer& renderer,
                         render::Renderer& reference, const render::FrameRequest& request) {
    image::Frame frame = drawSides(sides, renderer, request);
    if (session.mode != lighting::ViewMode::difference)
        return frame;
    frame = render::differenceView(frame, drawSides(sides, reference, request)).frame;
    if (request.floats)
        frame.pixels = image::toFloats(frame);
    return frame;
}

void writePicture(Session& session, View* before, render::Renderer& renderer, render::Renderer& reference,
                  const std::string& file, const render::FrameRequest& request, const std::string& program) {
    session.update(request.width, request.height);
    follow(session, before, request.width, request.height);
    const image::Frame frame =
        drawPicture(session, session.sides(request.width, before), renderer, reference, request);
    image::write(file, frame, metadata(session, renderer, program));
}

void withLessonBefore(const Session& session, const std::string& program,
                      const std::function<void(View*)>& use) {
    if (session.split != Split::lesson)
        return use(nullptr);
    Handover guest{nullptr, {}, {}, {}, [&use](View& view) { use(&view); }};
    runProgram(neighbour(program, -1), {}, guest);
}

void follow(Session& session, View* before, int width, int height) {
    if (before == nullptr)
        return;
    before->setCamera(session.view().cameraText());
    before->update(session.time, width, height);
}

}  // namespace lab
