// Pictures of a session: whoever draws them, whether a window is there or not.
// SPDX-License-Identifier: MIT
#pragma once

#include "image/frame.hpp"
#include "lab/live/session.hpp"
#include "render/renderer.hpp"

#include <functional>
#include <span>
#include <string>

namespace lab {

/// Whether a file of this name holds more than 8 bits: then it gets the float frame.
bool wantsFloats(const std::string& path);

/// Draws each side, and puts them beside each other. Their views must be up to date.
image::Frame drawSides(std::span<const Side> sides, render::Renderer& renderer,
                       const render::FrameRequest& request);

/// What is needed to know a picture again. The renderer has just drawn it.
image::Metadata metadata(const Session& session, const render::Renderer& renderer,
                         const std::string& program);

/// The picture of the session's sides, whatever its view is: a difference needs both renderers.
image::Frame drawPicture(const Session& session, std::span<const Side> sides, render::Renderer& renderer,
                         render::Renderer& reference, const render::FrameRequest& request);

/// Draws the session for this request and writes it to `file`.
void writePicture(Session& session, View* before, render::Renderer& renderer, render::Renderer& reference,
                  const std::string& file, const render::FrameRequest& request, const std::string& program);

/// Calls `use` with the View of the lesson before `program`, or with null where the session does not show it. Throws UsageError where there
/// is none.
void withLessonBefore(const Session& session, const std::string& program,
                      const std::function<void(View*)>& use);
/// Moves the lesson before, if there is one, to where the session's camera and time are.
void follow(Session& session, View* before, int width, int height);

}  // namespace lab
