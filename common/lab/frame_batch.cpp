// From lines of options to frames; what one line does is undone before the next.
// SPDX-License-Identifier: MIT
#include "lab/frame_batch.hpp"

#include "lab/frame_lines.hpp"
#include "lab/live/state_file.hpp"
#include "lab/progress.hpp"
#include "lab/stats.hpp"
#include "lab/stills.hpp"

#include <iostream>
#include <unistd.h>

namespace lab {

namespace {

// A line's options, if it asks for a frame.
std::optional<Options> optionsOf(const std::string& line, bool tooLong, const Options& commandLine) {
    if (tooLong)
        throw UsageError("the line is too long; expected at most " + std::to_string(LineReader::longest) +
                         " bytes; is this the right file?");
    const std::vector<std::string> words = splitWords(line);
    return words.empty() ? std::nullopt : std::optional(parseFrameLine(words, commandLine));
}

void drawOne(const Options& options, Controls& controls, const WithView& withView, Renderers& renderers,
             Phases& phases) {
    controls.forgetSet();
    if (const std::string wrong = controls.set(options.set); !wrong.empty())
        throw UsageError(wrong);
    withView(options, [&](View& view) { drawStill(view, options, renderers, phases); });
    if (!options.stats)
        std::cout << options.frame << '\n';
}

void tellFailure(const Failure& failure, const LineReader& lines, const Options& options) {
    std::cerr << lines.place() << ": " << messageOf(failure, options.sceneFile) << std::endl;
    if (options.stats)
        std::cout << failureJson(options.frame, lines.number(), failure) << '\n';
}

}  // namespace

Status drawFrames(const Options& commandLine, Controls& controls, const WithView& withView,
                  Renderers& renderers, Phases& phases) {
    LineReader lines(commandLine.framesFrom);
    const bool quiet = isatty(STDOUT_FILENO) != 0;  // names that scroll by show progress enough
    Progress progress;
    Status status = done;
    int frames = 0;
    renderers.showProgress = false;
    for (std::string line; lines.next(line);) {
        if (lines.number() > 1)
            phases.restart();
        std::optional<Options> options;
        const std::optional<Failure> failure = attempt([&] {
            options = optionsOf(line, lines.isTooLong(), commandLine);
            phases.mark("options");
            if (!options)
                return;
            takeStateSize(*options);
            drawOne(*options, controls, withView, renderers, phases);
        });
        if (failure) {
            progress.clear();
            tellFailure(*failure, lines, options.value_or(commandLine));
            status = status == done ? failure->status : status;
        }
        std::cout.flush();
        frames += options && !failure;
        if (!quiet)
            progress.step(lines.share(), std::to_string(frames));
    }
    return status;
}

}  // namespace lab
