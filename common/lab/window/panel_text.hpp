// Text with subscripts and exponents, in tones, broken into lines; inside the window module only.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/window/panel_look.hpp"

#include <string>
#include <string_view>

namespace lab {

/// What the parts of the panel share while they are drawn.
struct Brush {
    const Look& look;
    std::vector<std::string> said;  ///< commands of what the user did, in order
    std::string typed;  ///< the command of the field that is being typed into, if it has changed
    struct Place {
        std::string what;  ///< "widget term ambient"
        ImVec2 at;  ///< its centre, in the window's units
    };
    std::vector<Place> places;
};

/// Width of `text` in letters of this size. L_A is drawn with a real subscript, x^2 with an exponent: what
/// follows a single letter's _, or a ^, up to the next character that is neither letter nor digit. So
/// lesson_04_ambient stays as it is.
float richWidth(const Look& look, float size, std::string_view text);

/// Draws it, `at` is the upper left corner.
void drawRich(ImDrawList& list, const Look& look, ImVec2 at, float size, ImU32 color, std::string_view text);

/// Draws a span on one line in its tone, struck through where it is off.
void drawSpan(ImDrawList& list, const Look& look, ImVec2 at, float size, const Span& span);

/// Lines one below the other from ImGui's cursor on, broken at blanks where they are wider than `width`.
void flow(const Look& look, const std::vector<Line>& lines, float width);

/// The last item's explanation, while the mouse is over it.
void tooltip(const Look& look, const std::string& help, bool shown);

}  // namespace lab
