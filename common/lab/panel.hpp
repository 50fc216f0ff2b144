// What stands on a window beside the picture: plain data, which the window draws and another front end could draw too.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace lab {

/// How a piece of text looks. Never by its colour alone: what is off is struck through, what is wrong says so.
enum class Tone { plain, active, idle, off, title, wrong };

/// A piece of text.
struct Span {
    std::string text;  ///< UTF-8
    Tone tone = Tone::plain;
};
using Line = std::vector<Span>;

/// A piece of the equation.
struct PanelSymbol {
    std::string text;  ///< UTF-8: the slide's symbol, or the number that stands in its place
    Tone tone = Tone::plain;
    std::string command = {};  ///< what a click on it says, as on stdin; empty: punctuation
    std::string key = {};  ///< shown above it, small
    std::string slide = {};  ///< shown below it, small
    std::string help = {};  ///< shown while the mouse is over it; lines end in \n
};

enum class WidgetKind { toggle, choice, number, color, vector, action };

/// A control as one can move it. What the user does to it is told as a command: its own words, then the new value.
struct Widget {
    WidgetKind kind = WidgetKind::toggle;
    std::string command;  ///< "term ambient", "light 2 color"
    std::string label;
    std::string
        value;  ///< toggle: "on" or "off"; choice: its name; action: unused; others: as the command line would have it
    std::array<double, 3> numbers{};  ///< number: the first; color: R, G, B (1 is full); vector: x, y, z
    double min = 0, max = 1;  ///< number: its range; vector: unused
    double step = 0.01;  ///< number, vector: what a small move changes
    std::vector<std::array<std::string, 2>> choices = {};  ///< choice: name and words of each
    std::string key = {};  ///< shown beside it; may be empty
    std::string help = {};  ///< shown while the mouse is over it
    Tone tone = Tone::plain;
};

/// Widgets that belong together, under a title that folds them away.
struct WidgetGroup {
    std::string title;
    std::vector<Widget> widgets;
    bool open = true;  ///< at first
    std::string id = {};  ///< the same in every language
};

/// A place on the picture: 0,0 is its top left, 1,1 its bottom right.
struct PanelPoint {
    double x = 0, y = 0;
};

/// Colours of what is drawn over the picture, told apart by colour-blind people too; each theme has its own.
enum class Ink { text, faint, normal, light, reflected, view, chosen };

/// A straight line over the picture.
struct PanelStroke {
    PanelPoint from, to;
    Ink ink = Ink::text;
    bool arrow = false;
    double width = 2;  ///< pixels at font size 16
};

/// A word over the picture.
struct PanelTag {
    PanelPoint at;
    std::string text;
    Ink ink = Ink::text;
};

/// Something that the mouse can grab: Event::Kind::handle tells of it by its name.
struct PanelHandle {
    std::string name;  ///< "light 2"
    PanelPoint at;
    std::string help = {};
    bool chosen = false;
};

/// A small diagram with the present point on it.
struct PanelCurve {
    std::string title;  ///< "f(d) = 1 / d^2"
    std::string across;  ///< what x is, with its range: "d: 0 ... 8"
    std::vector<PanelPoint> line;  ///< from 0,0 (lower left) to 1,1 (upper right)
    PanelPoint dot;  ///< in the same numbers
    std::string dotText;  ///< "f(5.2) = 0.037"
};

/// What the colours of the picture mean.
struct PanelLegend {
    std::string title;
    struct Entry {
        std::array<double, 3> color;  ///< R, G, B, 1 is full
        std::string text;
    };
    std::vector<Entry> entries;
};

/// The line between before and after.
struct PanelDivider {
    double share = 0.5;  ///< of the picture's width that is left of it
    std::string left, right;  ///< what stands on each side
};

/// How the panel is to look.
struct PanelStyle {
    int fontSize = 16;  ///< 16 to 48: height of a line of text, pixels where the screen's scale is 1
    bool light = false;  ///< dark text on light, for weak projectors
    bool operator==(const PanelStyle&) const = default;
};

/// All of it.
struct Panel {
    PanelStyle style;
    std::vector<PanelSymbol> equation;  ///< at the top, left to right
    std::string slide;  ///< beside the equation: "slide 42"
    std::vector<Line> message;  ///< below the equation; may be empty
    std::vector<Line> probe;  ///< below the message; spans of a line are aligned in columns; may be empty
    std::vector<PanelCurve> curves;  ///< beside the probe
    bool probeAtRight =
        false;  ///< the probe stands at the right edge, so that the point is seen; where there are no groups
    std::vector<WidgetGroup> groups;  ///< at the right; empty: hidden
    std::vector<Line> rows;  ///< in the lower left corner: readings, keys, what was left out; may be empty
    std::optional<PanelLegend> legend;
    std::optional<PanelDivider> divider;
    std::vector<PanelStroke> strokes;
    std::vector<PanelTag> tags;
    std::vector<PanelHandle> handles;
};

}  // namespace lab
