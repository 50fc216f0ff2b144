// Sets the symbols in rows; each has its key above and its slide below.
// SPDX-License-Identifier: MIT
#include "lab/window/panel_equation.hpp"

#include <algorithm>
#include <cmath>

namespace lab {

namespace {

// Letters never become smaller than this, in lines of text, as long as a line can be broken instead.
constexpr float smallestShare = 0.85F;

struct Piece {
    const PanelSymbol* symbol;
    std::string_view text;  // without the blanks around it
    float before, wide, after;  // blanks, the text, blanks
    float margin;  // on each side of the text, where key or slide are wider than it
    float width() const { return before + wide + after + 2 * margin; }
};

Piece measure(const Look& look, const PanelSymbol& symbol, float size) {
    const std::string_view text = symbol.text;
    const std::size_t first = std::min(text.find_first_not_of(' '), text.size());
    const std::size_t last = std::min(text.find_last_not_of(' ') + 1, text.size());
    Piece piece{&symbol, text.substr(first, last > first ? last - first : 0), 0, 0, 0, 0};
    const float blank = richWidth(look, size, " ");
    piece.before = static_cast<float>(first) * blank;
    piece.after = static_cast<float>(text.size() - std::max(first, last)) * blank;
    piece.wide = richWidth(look, size, piece.text);
    const float notes =
        std::max(richWidth(look, look.small(), symbol.key), richWidth(look, look.small(), symbol.slide));
    piece.margin = std::max(0.0F, (notes - piece.wide) / 2);
    if (!symbol.command.empty())
        piece.margin = std::max(piece.margin, size * 0.06F);
    return piece;
}

using Row = std::vector<Piece>;

float widthOf(const Row& row) {
    float width = 0;
    for (const Piece& piece : row)
        width += piece.width();
    return width;
}

Row measureAll(const Look& look, const Panel& panel, float size) {
    Row row;
    for (const PanelSymbol& symbol : panel.equation)
        row.push_back(measure(look, symbol, size));
    return row;
}

std::vector<Row> broken(const Row& all, float width) {
    std::vector<Row> rows(1);
    float used = 0;
    for (const Piece& piece : all) {
        if (used + piece.width() > width && !rows.back().empty()) {
            rows.emplace_back();
            used = 0;
        }
        rows.back().push_back(piece);
        used += piece.width();
    }
    return rows;
}

// The largest letters with which all of it fits on one line, or with which its widest symbol does.
float fittingSize(const Look& look, const Panel& panel, float width) {
    float size = look.equation();
    for (int i = 0; i < 3; ++i) {  // keys and slides do not shrink, so once is not always enough
        const float wide = widthOf(measureAll(look, panel, size));
        if (wide <= width)
            return size;
        size = std::floor(size * width / wide);
        if (size < look.em() * smallestShare)
            break;
    }
    size = std::max(size, look.em() * smallestShare);
    for (const Piece& piece : measureAll(look, panel, size))
        if (piece.width() > width && width > 0)
            size = std::max(1.0F, std::min(size, size * width / piece.width()));
    return size;
}

// Heights of a row: of keys, letters, slides.
struct Heights {
    float key = 0, letters = 0, slide = 0;
    float sum() const { return key + letters + slide; }
};

void drawPiece(Brush& brush, const Piece& piece, ImVec2 corner, float size, const Heights& heights) {
    const Look& look = brush.look;
    const PanelSymbol& symbol = *piece.symbol;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 from{corner.x + piece.before, corner.y};
    const float wide = piece.wide + 2 * piece.margin;
    const ImVec2 place{std::max(1.0F, wide), std::max(1.0F, heights.sum())};
    ImGui::SetCursorScreenPos(from);
    const bool button = !symbol.command.empty();
    if (button && ImGui::InvisibleButton("symbol", place))
        brush.said.push_back(symbol.command);
    else if (!button)
        ImGui::Dummy(place);
    const bool hovered = ImGui::IsItemHovered();
    const float top = from.y + heights.key;
    if (button && (hovered || symbol.tone == Tone::active))
        list.AddRectFilled({from.x, top}, {from.x + wide, top + heights.letters}, look.chip(hovered),
                           size * 0.15F);
    drawSpan(list, look, {from.x + piece.margin, top}, size, {std::string(piece.text), symbol.tone});
    const auto note = [&](const std::string& text, float y, Tone tone) {
        const float x = from.x + (wide - richWidth(look, look.small(), text)) / 2;
        drawRich(list, look, {x, y}, look.small(), look.color(tone), text);
    };
    note(symbol.key, from.y, Tone::title);
    note(symbol.slide, top + heights.letters, Tone::idle);
    if (button) {
        brush.places.push_back({"symbol " + symbol.command, {from.x + wide / 2, top + heights.letters / 2}});
        if (hovered)
            ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    }
    tooltip(look, symbol.help, hovered);
}

}  // namespace

void drawEquation(Brush& brush, const Panel& panel, float width) {
    const Look& look = brush.look;
    const float note = panel.slide.empty() ? 0 : richWidth(look, look.em(), panel.slide);
    const float noteRoom = note > 0 ? note + look.em() : 0;
    float size = fittingSize(look, panel, width - noteRoom);
    bool beside = widthOf(measureAll(look, panel, size)) + noteRoom <= width;
    if (!beside)
        size = fittingSize(look, panel, width);
    const std::vector<Row> rows = broken(measureAll(look, panel, size), width);
    beside = beside || widthOf(rows.back()) + noteRoom <= width;
    Heights heights{0, size * 1.1F, 0};
    for (const PanelSymbol& symbol : panel.equation) {
        heights.key = symbol.key.empty() ? heights.key : look.small();
        heights.slide = symbol.slide.empty() ? heights.slide : look.small();
    }
    ImVec2 at = ImGui::GetCursorScreenPos();
    const float left = at.x;
    int id = 0;
    for (const Row& row : rows) {
        at.x = left;
        for (const Piece& piece : row) {
            ImGui::PushID(id++);
            drawPiece(brush, piece, at, size, heights);
            ImGui::PopID();
            at.x += piece.width();
        }
        at.y += heights.sum() + size * 0.1F;
    }
    if (note > 0) {
        const float last = at.y - size * 0.1F - heights.slide - heights.letters;
        const ImVec2 place =
            beside ? ImVec2{at.x + look.em(), last + (heights.letters - look.em()) / 2} : ImVec2{left, at.y};
        drawRich(*ImGui::GetWindowDrawList(), look, place, look.em(), look.color(Tone::title), panel.slide);
        ImGui::SetCursorScreenPos(place);
        ImGui::Dummy({note, look.em()});
    }
}

}  // namespace lab
