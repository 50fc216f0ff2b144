// What the colours of the views mean. Shaders and reference compute them on their own; tests compare.
// SPDX-License-Identifier: MIT
#include "lighting/views.hpp"

#include <glm/common.hpp>

namespace lighting {

namespace {

constexpr Text noText{};

glm::dvec3 codes(unsigned rgb) { return glm::dvec3(rgb >> 16, rgb >> 8 & 0xFF, rgb & 0xFF) / 255.0; }

std::vector<LegendEntry> greys() {
    std::vector<LegendEntry> entries;
    for (const double value : {0.0, 0.25, 0.5, 0.75, 1.0})
        entries.push_back({glm::dvec3(value), value, noText});
    return entries;
}

std::vector<LegendEntry> cosines() {
    std::vector<LegendEntry> entries{
        {codes(0x56B4E9), -1, {"la luce è dietro", "the light is behind"}},
        {codes(0x56B4E9) / 2.0, -0.5, noText},
    };
    for (const LegendEntry& grey : greys())
        entries.push_back(grey);
    entries.back().text = {"la luce è di fronte", "the light is straight ahead"};
    return entries;
}

// Nine colours from dark to bright whose lightness L* goes from 12 to 92 by tens: an octave apart, to be told without hue too.
std::vector<LegendEntry> octaves() {
    constexpr unsigned colors[] = {0x2E0856, 0x352678, 0x304887, 0x28698C, 0x218A87,
                                   0x38A973, 0x74C452, 0xC0D739, 0xFEEA5A};
    std::vector<LegendEntry> entries;
    double f = 1.0 / 64;
    for (const unsigned color : colors) {
        entries.push_back({codes(color), f, noText});
        f *= 2;
    }
    entries.front().text = {"o meno", "or less"};
    entries.back().text = {"o più", "or more"};
    return entries;
}

std::vector<LegendEntry> bands() {
    std::vector<LegendEntry> entries;
    for (int band = -10; band < 0; ++band)
        entries.push_back({glm::mix(codes(0x264066), codes(0x59B2FF), -band / 10.0),
                           band / 10.0,
                           {"a strisce: la luce è dietro", "hatched: the light is behind"}});
    for (int band = 0; band < 10; ++band)
        entries.push_back({glm::dvec3((band + 1) / 10.0), band / 10.0, noText});
    return entries;
}

std::vector<LegendEntry> axes() {
    return {{{1, 0.5, 0.5}, std::nullopt, {"+x", "+x"}}, {{0, 0.5, 0.5}, std::nullopt, {"-x", "-x"}},
            {{0.5, 1, 0.5}, std::nullopt, {"+y", "+y"}}, {{0.5, 0, 0.5}, std::nullopt, {"-y", "-y"}},
            {{0.5, 0.5, 1}, std::nullopt, {"+z", "+z"}}, {{0.5, 0.5, 0}, std::nullopt, {"-z", "-z"}}};
}

std::vector<LegendEntry> overexposures() {
    return {{codes(0x56B4E9), 1, {"strisce sottili: un canale oltre 1", "thin stripes: one channel above 1"}},
            {codes(0xF0E442), 2, {"strisce: due canali oltre 1", "stripes: two channels above 1"}},
            {codes(0xFFFFFF), 3, {"strisce larghe: tutti e tre", "wide stripes: all three"}}};
}

}  // namespace

std::vector<LegendEntry> legend(ViewMode view) {
    switch (view) {
    case ViewMode::cosine:
        return cosines();
    case ViewMode::clamp:
    case ViewMode::red:
    case ViewMode::green:
    case ViewMode::blue:
        return greys();
    case ViewMode::attenuation:
        return octaves();
    case ViewMode::bands:
        return bands();
    case ViewMode::normals:
    case ViewMode::w:
        return axes();
    case ViewMode::overexposed:
        return overexposures();
    case ViewMode::difference:
        return {{codes(0x000000), 0, {"uguali", "equal"}},
                {codes(0x304887), 1, {"1 codice", "1 code"}},
                {codes(0x218A87), 2, {"2 o 3 codici", "2 or 3 codes"}},
                {codes(0x74C452), 4, {"da 4 a 7", "4 to 7"}},
                {codes(0xFEEA5A), 8, {"da 8 a 31", "8 to 31"}},
                {codes(0xFFFFFF), 32, {"32 o più", "32 or more"}}};
    default:
        return {};
    }
}

}  // namespace lighting
