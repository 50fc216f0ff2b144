// The table of views, their legends, and what each asks of a frame.
// SPDX-License-Identifier: MIT
#include "lighting/views.hpp"

#include "lighting/frame_plan.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <stdexcept>
#include <string>

namespace lighting {

const std::array<ViewInfo, viewCount>& views() {
    using enum LegendKind;
    using V = ViewMode;
    static const std::array<ViewInfo, viewCount> table{{
        {V::final, "final", "42", {"l'immagine finale P", "the final picture P"}, false, none},
        {V::albedo, "albedo", "14, 27", {"D: il colore base", "D: the base colour"}, false, none},
        {V::cosine, "cosine", "16-24", {"n·ω, con il suo segno", "n·ω, with its sign"}, true, ramp},
        {V::clamp, "clamp", "23-24", {"max(0, n·ω)", "max(0, n·ω)"}, true, ramp},
        {V::lightColor,
         "light_color",
         "26-27, 31",
         {"L: il colore della luce", "L: the colour of the light"},
         true,
         none},
        {V::attenuation,
         "attenuation",
         "31",
         {"f(d), in scala logaritmica", "f(d), on a logarithmic scale"},
         true,
         ramp},
        {V::directional,
         "directional",
         "29-30",
         {"solo gli addendi delle luci direzionali", "the addends of directional lights alone"},
         false,
         none},
        {V::point,
         "point",
         "29-31",
         {"solo gli addendi delle luci posizionali", "the addends of point lights alone"},
         false,
         none},
        {V::ambient,
         "ambient",
         "42",
         {"solo la componente ambiente", "the ambient component alone"},
         false,
         none},
        {V::specular, "specular", "45", {"solo i riflessi lucidi", "the highlights alone"}, false, none},
        {V::red, "red", "26", {"il canale rosso di P", "the red channel of P"}, false, ramp},
        {V::green, "green", "26", {"il canale verde di P", "the green channel of P"}, false, ramp},
        {V::blue, "blue", "26", {"il canale blu di P", "the blue channel of P"}, false, ramp},
        {V::normals, "normals", "16-20, 33", {"n, come colore", "n, as a colour"}, false, axes},
        {V::w, "w", "16-20, 29-30", {"ω, come colore", "ω, as a colour"}, true, axes},
        {V::bands, "bands", "16-25", {"n·ω a gradini di 0,1", "n·ω in steps of 0.1"}, true, steps},
        {V::overexposed,
         "overexposed",
         "39",
         {"dove un canale supera 1", "where a channel is above 1"},
         false,
         marks},
        {V::exaggerated,
         "exaggerated",
         "41",
         {"luce ambiente moltiplicata per 8", "ambient light times 8"},
         false,
         none},
        {V::difference,
         "difference",
         "",
         {"quanto due immagini differiscono", "how much two pictures differ"},
         false,
         marks},
    }};
    return table;
}

const ViewInfo& info(ViewMode view) { return views()[static_cast<std::size_t>(view)]; }

ViewMode parseView(std::string_view name) {
    std::string known;
    for (const ViewInfo& row : views()) {
        if (name == row.name)
            return row.view;
        known += " " + std::string(row.name);
    }
    throw std::invalid_argument("unknown view '" + std::string(name) + "', expected one of:" + known);
}

bool isData(ViewMode view) {
    switch (view) {
    case ViewMode::albedo:
    case ViewMode::cosine:
    case ViewMode::clamp:
    case ViewMode::lightColor:
    case ViewMode::attenuation:
    case ViewMode::normals:
    case ViewMode::w:
    case ViewMode::bands:
        return true;
    default:
        return false;
    }
}

bool isAddend(ViewMode view) {
    return view == ViewMode::directional || view == ViewMode::point || view == ViewMode::ambient ||
           view == ViewMode::specular;
}

namespace {

// The terms that a data view is made of.
TermSet factorsOf(ViewMode view) {
    const TermSet none = TermSet::none();
    switch (view) {
    case ViewMode::albedo:
        return none.with(Term::albedo);
    case ViewMode::cosine:
    case ViewMode::bands:
        return none.with(Term::cosine);
    case ViewMode::clamp:
        return none.with(Term::cosine).with(Term::clamp);
    case ViewMode::lightColor:
        return none.with(Term::lightColor);
    case ViewMode::attenuation:
        return none.with(Term::attenuation);
    default:
        return none;
    }
}

}  // namespace

bool hides(ViewMode view, Term term) {
    if (isData(view))
        return !factorsOf(view).has(term);
    switch (view) {
    case ViewMode::directional:
        return term == Term::point || term == Term::attenuation || term == Term::ambient;
    case ViewMode::point:
        return term == Term::directional || term == Term::ambient;
    case ViewMode::ambient:
        return term != Term::albedo && term != Term::ambient;
    case ViewMode::specular:
        return term == Term::albedo || term == Term::cosine || term == Term::clamp || term == Term::ambient;
    default:
        return false;
    }
}

const THREE::Light* viewLight(const THREE::Scene& scene, const Settings& settings) {
    const THREE::Light* found = nullptr;
    scene.traverseVisible([&](const THREE::Object3D& object) {
        const auto* light = dynamic_cast<const THREE::Light*>(&object);
        if (light == nullptr || found != nullptr ||
            dynamic_cast<const THREE::AmbientLight*>(light) != nullptr)
            return;
        if (settings.only == nullptr || settings.only == light)
            found = light;
    });
    return found;
}

Settings settingsFor(const THREE::Scene& scene, const Settings& settings) {
    Settings wanted = settings;
    TermSet& terms = wanted.terms;
    switch (settings.view) {
    case ViewMode::directional:
        terms = terms.without(Term::point).without(Term::ambient);
        break;
    case ViewMode::point:
        terms = terms.without(Term::directional).without(Term::ambient);
        break;
    case ViewMode::ambient:
        terms = terms.without(Term::directional).without(Term::point);
        break;
    case ViewMode::specular:  // D is black then, so it must count
        terms = terms.without(Term::ambient).with(Term::albedo);
        break;
    default:
        break;
    }
    if (!isData(settings.view))
        return wanted;
    // Factors have their value whether the addend that they are part of is on or not.
    for (const TermInfo& row : lighting::terms())
        if (!factorsOf(settings.view).has(row.term))
            terms = terms.without(row.term);
    terms = terms.with(Term::directional).with(Term::point);
    wanted.only = viewLight(scene, settings);
    wanted.space = Space::world;
    if (wanted.shading == Shading::vertex)
        wanted.shading = Shading::pixel;
    wanted.lightCut = 0;
    wanted.constantLights = 0;  // one program for all places of the light
    return wanted;
}

glm::dvec3 backgroundFor(ViewMode view, const glm::dvec3& color) {
    if (isData(view))
        return noSurface;
    switch (view) {
    case ViewMode::red:
        return glm::dvec3(color.r);
    case ViewMode::green:
        return glm::dvec3(color.g);
    case ViewMode::blue:
        return glm::dvec3(color.b);
    case ViewMode::overexposed:
        return dimmed * glm::clamp(color, 0.0, 1.0);
    default:
        return color;
    }
}

}  // namespace lighting
