// --frames-from: many frames in one process, a line of options each.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/app.hpp"
#include "lab/failure.hpp"
#include "lab/renderers.hpp"
#include "lab/view.hpp"

namespace lab {

/// Draws the frames of --frames-from in order, each written before the next line is read. Each line is answered on stdout,
/// flushed: with --stats by a line of JSON (`error` and `status` in it if it failed), else by the lesson's readings and then,
/// once it is written, the file's name. What went wrong stands on stderr as "FILE:LINE: what", and the next line follows.
/// Returns the first failure's status, else 0. Throws UsageError if the file cannot be read.
Status drawFrames(const Options& commandLine, Controls& controls, const WithView& withView,
                  Renderers& renderers, Phases& phases);

}  // namespace lab
