// Cuts text into runs on, below and above the line, and words into lines.
// SPDX-License-Identifier: MIT
#include "lab/window/panel_text.hpp"

#include <algorithm>
#include <cfloat>
#include <imgui_internal.h>

namespace lab {

namespace {

constexpr float scriptShare = 0.68F;

enum class Level { line, below, above };

// Length in bytes of the letter or digit at `at`; 0: there is none. Letters are ASCII's, Latin, Greek and
// Cyrillic ones.
std::size_t alphanumeric(std::string_view text, std::size_t at) {
    if (at >= text.size())
        return 0;
    unsigned code = 0;
    const int length = ImTextCharFromUtf8(&code, text.data() + at, text.data() + text.size());
    const bool letter = (code >= 'a' && code <= 'z') || (code >= 'A' && code <= 'Z') ||
                        (code >= '0' && code <= '9') || (code >= 0xC0 && code < 0x530);
    return letter ? static_cast<std::size_t>(length) : 0;
}

// Where the character before `at` begins; at > 0.
std::size_t before(std::string_view text, std::size_t at) {
    do
        --at;
    while (at > 0 && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80);
    return at;
}

// The end of the script that the _ or ^ at `at` begins; `at` itself where it begins none.
std::size_t scriptEnd(std::string_view text, std::size_t at) {
    if (at == 0)
        return at;
    const std::size_t base = before(text, at);
    const bool letter = alphanumeric(text, base) > 0;
    const bool single = letter && (base == 0 || alphanumeric(text, before(text, base)) == 0);
    if (text[at] == '_' ? !single : !letter && text[base] != ')')
        return at;
    std::size_t end = at + 1;
    if (text[at] == '^' && end < text.size() && text[end] == '-')
        ++end;
    const std::size_t first = end;
    while (const std::size_t length = alphanumeric(text, end)) {
        end += length;
        if (text[at] == '^' && end + 1 < text.size() && text[end] == '.' && text[end + 1] >= '0' &&
            text[end + 1] <= '9')
            ++end;  // 2.5
    }
    return end > first ? end : at;
}

template <class Visit>
void eachRun(std::string_view text, const Visit& visit) {
    std::size_t from = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] != '_' && text[at] != '^')
            continue;
        const std::size_t end = scriptEnd(text, at);
        if (end == at)
            continue;
        if (at > from)
            visit(Level::line, text.substr(from, at - from));
        visit(text[at] == '_' ? Level::below : Level::above, text.substr(at + 1, end - at - 1));
        from = end;
        at = end - 1;
    }
    if (from < text.size())
        visit(Level::line, text.substr(from));
}

float runWidth(const Look& look, float size, std::string_view run) {
    return look.font(size)->CalcTextSizeA(size, FLT_MAX, 0, run.data(), run.data() + run.size()).x;
}

}  // namespace

float richWidth(const Look& look, float size, std::string_view text) {
    float width = 0;
    eachRun(text, [&](Level level, std::string_view run) {
        width += runWidth(look, level == Level::line ? size : size * scriptShare, run);
    });
    return width;
}

void drawRich(ImDrawList& list, const Look& look, ImVec2 at, float size, ImU32 color, std::string_view text) {
    eachRun(text, [&](Level level, std::string_view run) {
        const float own = level == Level::line ? size : size * scriptShare;
        const float down = level == Level::below ? 0.46F : level == Level::above ? -0.08F : 0.0F;
        list.AddText(look.font(own), own, {at.x, at.y + down * size}, color, run.data(),
                     run.data() + run.size());
        at.x += runWidth(look, own, run);
    });
}

void drawSpan(ImDrawList& list, const Look& look, ImVec2 at, float size, const Span& span) {
    const ImU32 color = look.color(span.tone);
    drawRich(list, look, at, size, color, span.text);
    if (span.tone != Tone::off || span.text.find_first_not_of(' ') == std::string::npos)
        return;
    const float y = at.y + size * 0.56F;
    list.AddLine({at.x, y}, {at.x + richWidth(look, size, span.text), y}, color, std::max(1.0F, size / 12));
}

namespace {

// How many bytes of a word fit into `width`, whole characters, at least one.
std::size_t fitting(const Look& look, std::string_view word, float width) {
    std::size_t length = 0;
    do
        ++length;
    while (length < word.size() && ((static_cast<unsigned char>(word[length]) & 0xC0) == 0x80 ||
                                    richWidth(look, look.em(), word.substr(0, length + 1)) <= width));
    return length;
}

// Draws one line from `at` on and returns the lower right corner of what it took.
ImVec2 flowLine(ImDrawList& list, const Look& look, ImVec2 at, const Line& line, float width) {
    const float size = look.em();
    const float left = at.x;
    float right = left;
    for (std::size_t i = 0; i < line.size(); ++i)
        for (std::size_t from = 0; from < line[i].text.size();) {
            const Span& span = line[i];
            const std::size_t word = std::min(span.text.find_first_not_of(' ', from), span.text.size());
            std::size_t end = std::min(span.text.find(' ', word), span.text.size());
            Span piece{span.text.substr(from, end - from), span.tone};
            float wide = richWidth(look, size, piece.text);
            const bool last = end == span.text.size() && i + 1 < line.size() && word < end;
            const std::string_view next = last ? std::string_view(line[i + 1].text) : std::string_view();
            const float hanging =
                richWidth(look, size, next.substr(0, std::min(next.find(' '), next.size())));
            if (at.x > left && at.x + wide + hanging > left + width) {
                at = {left, at.y + size * 1.2F};
                piece.text.erase(0, word - from);
                from = word;
                wide = richWidth(look, size, piece.text);
            }
            if (wide > width && piece.text.size() > 1) {  // a path, or a word in large letters
                piece.text.resize(fitting(look, piece.text, width));
                end = from + piece.text.size();
                wide = richWidth(look, size, piece.text);
            }
            drawSpan(list, look, at, size, piece);
            at.x += wide;
            right = std::max(right, at.x);
            from = end;
        }
    return {right, at.y + size * 1.2F};
}

}  // namespace

void flow(const Look& look, const std::vector<Line>& lines, float width) {
    const ImVec2 from = ImGui::GetCursorScreenPos();
    ImVec2 at = from;
    float right = from.x;
    for (const Line& line : lines) {
        const ImVec2 end = flowLine(*ImGui::GetWindowDrawList(), look, at, line, width);
        right = std::max(right, end.x);
        at.y = end.y;
    }
    ImGui::Dummy({right - from.x, at.y - from.y});
}

void tooltip(const Look& look, const std::string& help, bool shown) {
    if (help.empty() || !shown)
        return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(std::min(look.em() * 26, ImGui::GetIO().DisplaySize.x * 0.6F));
    ImGui::TextUnformatted(help.data(), help.data() + help.size());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

}  // namespace lab
