// The panel's fonts, sizes and colours; inside the window module only.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/panel.hpp"

#include <algorithm>
#include <imgui.h>
#include <string>
#include <vector>

namespace lab {

/// What everything of the panel looks like, for one style on one screen.
class Look {
  public:
    /// Bakes what this panel needs and is not there yet: its font size on this screen, and its characters.
    /// `contentScale` is the screen's, `density` framebuffer pixels per unit of the window. Not within a
    /// frame of ImGui.
    void prepare(const Panel& panel, float contentScale, float density);

    /// Height of a line of text, in the window's units.
    float em() const { return em_; }
    float small() const { return em_ * smallShare; }  ///< of keys and slides beside the equation
    float equation() const { return em_ * equationShare; }  ///< of the equation where it has room
    float gap() const { return std::min(em_ * 0.5F, 12.0F); }  ///< between boxes, and to the window's border
    /// The font whose letters are closest to this size without being stretched.
    ImFont* font(float size) const;

    ImU32 color(Tone tone) const;
    ImU32 color(Ink ink) const;
    ImU32 box() const;  ///< behind text; not quite opaque behind single words
    ImU32 outline() const;  ///< around what is drawn over the picture
    ImU32 chip(bool hovered) const;  ///< behind an active symbol

  private:
    static constexpr float smallShare = 0.75F;
    static constexpr float equationShare = 1.75F;

    bool learn(const Panel& panel);
    void bake(float pixels, float density);
    void applyStyle() const;

    float em_ = 16;
    float pixels_ = 0;  // of a line of text in the framebuffer; 0: nothing baked yet
    float density_ = 1;
    bool light_ = false;
    std::string file_;  // the font's
    std::vector<bool> text_ = std::vector<bool>(0x10000);  // characters that are needed, by code point
    std::vector<bool> symbols_ = std::vector<bool>(0x10000);  // those of the equation
    std::vector<ImWchar> textRanges_,
        symbolRanges_;  // the same as ImGui wants them, which keeps the addresses
};

}  // namespace lab
