// Shares a budget of codes among the lights.
// SPDX-License-Identifier: MIT
#include "lighting/light_cut.hpp"

#include "lighting/float_range.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace lighting {

namespace {

class Cut {
  public:
    Cut(FramePlan& plan, const Settings& settings)
        : plan_(plan), settings_(settings), allowed_(settings.lightCut / 255) {
        for (const Draw& draw : plan.draws) {
            if (!draw.variant.lit)
                continue;
            const bool albedo = settings.terms.has(Term::albedo);
            largestAlbedo_ = glm::max(largestAlbedo_, albedo ? draw.albedo : glm::dvec3(1));
            if (draw.variant.has(Term::specular))
                strongestHighlight_ = std::max(strongestHighlight_, highlight(draw));
        }
    }

    void run() {
        // Lights that could not be cut even if they had all of it take no share.
        int sharing = 0;
        const auto counts = [&](double strength, double k) {
            sharing += k > 0 || strength <= allowed_ ? 1 : 0;
        };
        for (const PointAddend& light : plan_.point)
            counts(strength(light.color, light.intensity), slope(light));
        for (const DirectionalAddend& light : plan_.directional)
            counts(strength(light.color, light.intensity), 0);
        if (sharing == 0)
            return;
        share_ = allowed_ / sharing;
        for (PointAddend& light : plan_.point)
            shorten(light);
        drop(plan_.point, [](const PointAddend& light) { return light.reach == 0; });
        drop(plan_.directional, [this](const DirectionalAddend& light) {
            return strength(light.color, light.intensity) <= share_;
        });
    }

  private:
    // How strong a highlight can be for a light of strength 1: K_S, or three.js's lobe with a Fresnel factor of at most 1.
    static double highlight(const Draw& draw) {
        return draw.variant.blinn
                   ? std::max(largest(draw.specular), 1.0) * std::max(1.0, (draw.shininess + 2) / 8)
                   : largest(draw.specular);
    }

    // What a light can add to a channel at distance 1.
    double strength(const glm::dvec3& color, double intensity) const {
        const glm::dvec3 L = settings_.terms.has(Term::lightColor) ? color : glm::dvec3(intensity);
        return largest(largestAlbedo_ * L) + strongestHighlight_ * largest(L);
    }

    // The exponent by which it falls off; 0 where it does not.
    double slope(const PointAddend& light) const {
        return settings_.terms.has(Term::attenuation) && light.exponent == 0 ? light.decay : 0;
    }

    void shorten(PointAddend& light) {
        if (light.exponent != 0)
            return;  // its strength is not what it seems
        const double s = strength(light.color, light.intensity), k = slope(light);
        const double reach = k > 0         ? std::pow(s / share_, 1 / k)
                             : s <= share_ ? 0
                                           : std::numeric_limits<double>::infinity();
        if (!(reach < light.reach))
            return;
        light.reach = reach;
        light.cut = share_ * 255;
    }

    template <class Lights, class Test>
    void drop(Lights& lights, const Test& test) {
        std::erase_if(lights, [&](const auto& light) {
            if (!test(light))
                return false;
            plan_.skipped.push_back({light.light,
                                     {"--light-cut: ovunque aggiunge meno della sua parte",
                                      "--light-cut: it adds less than its share everywhere"}});
            ++plan_.lightsSkipped;
            --plan_.lightsUsed;
            plan_.cutCodes += share_ * 255;
            return true;
        });
    }

    FramePlan& plan_;
    const Settings& settings_;
    const double allowed_;  // light of a pixel
    double share_ = 0;
    glm::dvec3 largestAlbedo_{0};
    double strongestHighlight_ = 0;
};

}  // namespace

void cutLights(FramePlan& plan, const Settings& settings) {
    if (settings.lightCut > 0 && settings.skip)
        Cut(plan, settings).run();
}

}  // namespace lighting
