// Which symbols cannot matter to a scene, and why.
// SPDX-License-Identifier: MIT
#include "lighting/frame_plan.hpp"

#include <algorithm>

namespace lighting {

Text idleReason(Term term, const FramePlan& plan) {
    if (hides(plan.view, term))
        return {"questa vista non lo mostra", "this view does not show it"};
    const std::size_t addends = plan.directional.size() + plan.point.size();
    const bool dark = addends == 0 && plan.ambient == glm::dvec3(0);
    if (!plan.litMeshes)
        return {"nessun materiale illuminato", "no lit material"};
    switch (term) {
    case Term::albedo:
        if (dark)
            return {"nessuna luce: tutto nero", "no light: all black"};
        if (!plan.albedoNotWhite)
            return {"materiale bianco: D = 1", "white material: D = 1"};
        break;
    case Term::cosine:
        if (addends == 0)
            return {"nessuna luce con una direzione", "no light with a direction"};
        break;
    case Term::clamp:
        if (addends == 0)
            return {"nessuna luce con una direzione", "no light with a direction"};
        if (!isData(plan.view) && addends == 1 && plan.ambient == glm::dvec3(0) && !plan.emissive)
            return {"una sola luce: il negativo è già nero", "one light: negative is black anyway"};
        break;
    case Term::lightColor:
        if (!plan.lightColorMatters)
            return addends == 0 ? Text{"nessuna luce con una direzione", "no light with a direction"}
                                : Text{"luce bianca: L è già bianca", "white light: L is white already"};
        break;
    case Term::attenuation:
        if (plan.point.empty())
            return {"nessuna luce posizionale", "no point light"};
        if (std::all_of(plan.point.begin(), plan.point.end(),
                        [](const auto& l) { return l.decay == 0 && l.distance == 0; }))
            return {"k = 0: f = 1", "k = 0: f = 1"};
        break;
    case Term::directional:
        if (plan.directional.empty())
            return {"nessuna luce direzionale", "no directional light"};
        break;
    case Term::point:
        if (plan.point.empty())
            return {"nessuna luce posizionale", "no point light"};
        break;
    case Term::ambient:
        if (plan.ambient == glm::dvec3(0))
            return {"nessuna luce ambiente", "no ambient light"};
        break;
    case Term::specular:
        if (!plan.shiny)
            return {"nessun materiale lucido", "no shiny material"};
        if (addends == 0)
            return {"nessuna luce con una direzione", "no light with a direction"};
        break;
    }
    return {nullptr, nullptr};
}

}  // namespace lighting
