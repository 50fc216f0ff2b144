// What frames prove, in numbers and pictures.
// SPDX-License-Identifier: MIT
#include "grader/judge/evidence.hpp"

#include "lighting/views.hpp"
#include "render/difference_view.hpp"

#include <algorithm>

namespace grader {

namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);

std::array<double, 3> shown(const std::vector<float>& pixels, std::size_t pixel) {
    std::array<double, 3> result{};
    for (std::size_t c = 0; c < 3; ++c)
        result[c] = std::clamp(static_cast<double>(pixels[pixel * 3 + c]), 0.0, 1.0);
    return result;
}

Picture picture(const std::string& prefix, const char* role, const std::string& label, int size) {
    Picture result;
    result.image = {prefix + "-" + role, role, label, prefix + "-" + role + ".png", size, size};
    return result;
}

}  // namespace

Evidence::Evidence(const std::vector<ExpectedFrame>& expected, const std::vector<std::vector<float>>& found)
    : expected_(&expected), found_(&found), worst_(none) {
    for (std::size_t i = 0; i < expected.size(); ++i) {
        verdicts_.push_back(found[i].empty() ? FrameVerdict() : compare(expected[i], found[i]));
        right_ = right_ && right(i);
        if (there(i) && (worst_ == none || verdicts_[i].share() < verdicts_[worst_].share()))
            worst_ = i;
    }
}

std::vector<RegionShare> Evidence::regions() const {
    std::vector<RegionShare> result;
    for (int r = 0; r < regionCount; ++r) {
        FrameVerdict::Share all;
        for (std::size_t i = 0; i < verdicts_.size(); ++i) {
            all.pixels += verdicts_[i].regions[static_cast<std::size_t>(r)].pixels;
            all.right += verdicts_[i].regions[static_cast<std::size_t>(r)].right;
        }
        if (all.pixels > 0)
            result.push_back({nameOf(static_cast<Region>(r)), all.pixels, all.share()});
    }
    return result;
}

std::optional<WorstPixel> Evidence::worstPixel() const {
    if (worst_ == none || verdicts_[worst_].worstBy <= tolerance)
        return std::nullopt;
    const ExpectedFrame& expected = (*expected_)[worst_];
    const std::size_t pixel = verdicts_[worst_].worst;
    WorstPixel result;
    result.frame = expected.name();
    result.x = static_cast<int>(pixel) % expected.size();
    result.y = static_cast<int>(pixel) / expected.size();
    result.region = nameOf(expected.regions()[pixel]);
    result.found = shown((*found_)[worst_], pixel);
    result.expected = shown(expected.pixels(), pixel);
    result.numbers = expected.numbersAt(result.x, result.y);
    return result;
}

std::vector<Picture> Evidence::pictures(const std::string& prefix, Language language, Show show) const {
    std::vector<Picture> all;
    const bool found = worst_ != none;
    if (show == Show::wrong && (right_ || !found))
        return all;
    const ExpectedFrame& expected = (*expected_)[found ? worst_ : 0];
    const int size = expected.size();
    const bool it = language == Language::it;
    const std::string which = " (" + expected.name() + ")";
    if (found) {
        all.push_back(picture(prefix, "yours", (it ? "la tua" : "yours") + which, size));
        all.back().pixels = (*found_)[worst_];
    }
    all.push_back(picture(prefix, "expected", (it ? "attesa" : "expected") + which, size));
    all.back().pixels = expected.pixels();
    if (!found)
        return all;
    all.push_back(picture(prefix, "difference", differenceLegend(language), size));
    const render::DifferenceView view = render::differenceView({size, size, image::Floats(all[0].pixels)},
                                                               {size, size, image::Floats(all[1].pixels)});
    all.back().codes = std::get<image::Bytes>(view.frame.pixels);
    return all;
}

std::string differenceLegend(Language language) {
    const bool it = language == Language::it;
    constexpr std::array<lighting::Text, 6> colors{{{"nero", "black"},
                                                    {"blu", "blue"},
                                                    {"verde acqua", "teal"},
                                                    {"verde", "green"},
                                                    {"giallo", "yellow"},
                                                    {"bianco", "white"}}};
    std::string text = it ? "differenza (codici da 0 a 255): " : "difference (codes from 0 to 255): ";
    const std::vector<lighting::LegendEntry> legend = lighting::legend(lighting::ViewMode::difference);
    for (std::size_t i = 0; i < std::min(legend.size(), colors.size()); ++i)
        text += std::string(i == 0 ? "" : ", ") + (it ? colors[i].it : colors[i].en) + " " +
                (it ? legend[i].text.it : legend[i].text.en);
    return text;
}

double creditFor(double share) {
    constexpr double nothing = 0.6, everything = 0.995;
    return std::clamp((share - nothing) / (everything - nothing), 0.0, 1.0);
}

}  // namespace grader
