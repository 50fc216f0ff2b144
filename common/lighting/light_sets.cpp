// Lights that end before a mesh, or that its black surface swallows, are not in its sum.
// SPDX-License-Identifier: MIT
#include "lighting/light_sets.hpp"

#include "lighting/float_range.hpp"
#include "lighting/light_cut.hpp"
#include "lighting/mesh_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <map>
#include <numeric>

namespace lighting {

namespace {

// More sums than this in a frame, and each would be a shader of its own: then clusters tell the lights apart, not meshes.
constexpr std::size_t mostSums = 8;
constexpr std::size_t mostUnculled = 64;  // more lights than this, if some of them end, are worth clusters
constexpr std::size_t mostTurns =
    60'000;  // Mesa's software drivers end all loops of a shader after 65,535 turns

// Whether every pixel of the draw is 0 whatever light there is.
bool isBlack(const Draw& draw) {
    return draw.variant.has(Term::albedo) && draw.albedo == glm::dvec3(0) &&
           !draw.variant.has(Term::specular) && !isData(draw.variant.view);
}

class Distribution {
  public:
    Distribution(FramePlan& plan, const Settings& settings, bool hasAmbient)
        : plan_(plan), settings_(settings), hasAmbient_(hasAmbient) {}

    void run() {
        cutLights(plan_, settings_);
        findReaching();
        // Decided by the lights that count, whether the others are kept or not: the order of the sum must not change.
        const std::size_t lights = liveLights();
        const bool cullable = settings_.shading != Shading::vertex &&
                              std::any_of(plan_.point.begin(), plan_.point.end(), endsSomewhere);
        const bool texture =
            lights > most(settings_.uniformLights) || tooManySums_ || (cullable && lights > mostUnculled);
        clustered_ = texture && cullable;
        storage_ = texture                                   ? LightStorage::texture
                   : lights > most(settings_.constantLights) ? LightStorage::uniforms
                                                             : LightStorage::constants;
        sortLights();
        formSets();
        if (settings_.lightCut > 0)
            countCut();
        for (Draw& draw : plan_.draws)
            if (isData(draw.variant.view)) {
                finishData(draw);
            } else if (draw.variant.lit) {
                finish(draw);
                flatten(draw);
            }
    }

  private:
    static bool endsSomewhere(const PointAddend& light) { return std::isfinite(light.reach) && !light.dark; }
    static std::size_t most(int count) { return static_cast<std::size_t>(std::max(count, 0)); }

    std::size_t liveLights() const {
        const auto live = [](const auto& light) { return !light.dark; };
        return static_cast<std::size_t>(
            std::count_if(plan_.directional.begin(), plan_.directional.end(), live) +
            std::count_if(plan_.point.begin(), plan_.point.end(), live));
    }

    // For each lit draw the lights that end before it, unless there are so many that clusters do better.
    void findReaching() {
        std::vector<const PointAddend*> ending;
        for (const PointAddend& light : plan_.point)
            if (endsSomewhere(light))
                ending.push_back(&light);
        missing_.assign(plan_.draws.size(), {});
        if (ending.empty() || liveLights() > most(settings_.uniformLights))
            return;
        std::map<std::vector<const THREE::Light*>, int> different;
        for (std::size_t i = 0; i < plan_.draws.size(); ++i) {
            const Draw& draw = plan_.draws[i];
            if (!draw.variant.lit || draw.outside)
                continue;  // with --no-skip too: how many sums there are decides the order of the lights
            const MeshBounds bounds(draw);
            for (const PointAddend* light : ending)
                if (isBeyond(*light, bounds))
                    missing_[i].push_back(light->light);
            if (different.size() <= mostSums)
                ++different[missing_[i]];
        }
        tooManySums_ = different.size() > mostSums;
    }

    // With a margin for the roundings of positions on their way through floats.
    static bool isBeyond(const PointAddend& light, const MeshBounds& bounds) {
        const double rounding =
            1e-6 * (largest(glm::abs(light.position)) + largest(glm::abs(bounds.center())) + bounds.radius());
        return bounds.leastDistance(light.position) > light.reach * (1 + 1e-5) + rounding;
    }

    void sortLights() {
        const auto place = [this](const PointAddend& light) {
            return decayGroup(light) + (clustered_ && std::isfinite(light.reach) ? 4U : 0U);
        };
        std::stable_sort(plan_.point.begin(), plan_.point.end(),
                         [&place](const auto& a, const auto& b) { return place(a) < place(b); });
    }

    void formSets() {
        LightSet all;
        all.point.resize(plan_.point.size());
        std::iota(all.point.begin(), all.point.end(), 0U);
        plan_.lightSets.push_back(all);
        const bool byMesh = settings_.skip && storage_ != LightStorage::texture;
        std::vector<bool> used(plan_.point.size(), !byMesh);
        for (std::size_t i = 0; i < plan_.draws.size(); ++i) {
            Draw& draw = plan_.draws[i];
            if (!draw.variant.lit)
                continue;
            if (settings_.skip && isBlack(draw))
                takeNone(draw);
            else if (byMesh)
                take(draw, missing_[i], used);
        }
        if (byMesh && plan_.litMeshes && !allUsed_)
            tellUnused(used);
    }

    void takeNone(Draw& draw) {
        LightSet none;
        none.empty = true;
        draw.lights = number(none);
        plan_.pairsSkipped += static_cast<long long>(plan_.directional.size() + plan_.point.size());
        plan_.skipped.push_back(
            {draw.mesh, {"è nera: nessuna luce è calcolata", "it is black: no light is computed for it"}});
    }

    void take(Draw& draw, const std::vector<const THREE::Light*>& missing, std::vector<bool>& used) {
        if (missing.empty()) {
            allUsed_ = true;
            return;
        }
        LightSet set;
        for (std::uint32_t i = 0; i < plan_.point.size(); ++i)
            if (std::find(missing.begin(), missing.end(), plan_.point[i].light) == missing.end()) {
                set.point.push_back(i);
                used[i] = true;
            }
        draw.lights = number(set);
        plan_.pairsSkipped += static_cast<long long>(missing.size());
        plan_.skipped.push_back(
            {draw.mesh,
             {"luci posizionali finiscono prima", "point lights end before it"},
             std::to_string(missing.size()) + "/" + std::to_string(plan_.point.size()) + " "});
    }

    std::size_t number(const LightSet& set) {
        const auto known = std::find(plan_.lightSets.begin(), plan_.lightSets.end(), set);
        const auto index = static_cast<std::size_t>(known - plan_.lightSets.begin());
        if (known == plan_.lightSets.end())
            plan_.lightSets.push_back(set);
        return index;
    }

    void tellUnused(const std::vector<bool>& used) {
        for (std::size_t i = 0; i < used.size(); ++i)
            if (!used[i] && std::isfinite(plan_.point[i].reach)) {
                plan_.skipped.push_back(
                    {plan_.point[i].light, {"finisce prima di ogni oggetto", "it ends before every mesh"}});
                ++plan_.lightsSkipped;
                --plan_.lightsUsed;
            }
    }

    // The codes of lights that --light-cut left out of some mesh, or of some cluster.
    void countCut() {
        const auto leftOut = [this](const PointAddend& light) {
            if (storage_ == LightStorage::texture)
                return clustered_;
            return std::any_of(missing_.begin(), missing_.end(), [&light](const auto& lights) {
                return std::find(lights.begin(), lights.end(), light.light) != lights.end();
            });
        };
        for (const PointAddend& light : plan_.point)
            plan_.cutCodes += light.cut > 0 && leftOut(light) ? light.cut : 0;
        plan_.cutCodes = std::min(plan_.cutCodes, settings_.lightCut);  // not a rounding more
    }

    void finish(Draw& draw) const {
        Variant& v = draw.variant;
        const LightSet& set = plan_.lightSets[draw.lights];
        if (!set.empty) {
            v.directional = static_cast<int>(plan_.directional.size());
            v.ambient = hasAmbient_;
        }
        int* const groups[] = {&v.decay0, &v.decay1, &v.decay2, &v.decayOther};
        for (const std::uint32_t i : set.point) {
            const PointAddend& light = plan_.point[i];
            if (clustered_ && std::isfinite(light.reach))
                v.clustered |= 1U << decayGroup(light);
            else
                ++*groups[decayGroup(light)];
            v.window |= light.distance > 0;
        }
        v.storage = v.directional + v.point() == 0 && v.clustered == 0 ? LightStorage::uniforms : storage_;
        v.longLoops = plan_.directional.size() + plan_.point.size() > mostTurns;
        if (settings_.skip)
            dropIdle(v);
    }

    // The one light of a data view; its exponent is a number like others, so that one program does for all.
    void finishData(Draw& draw) const {
        Variant& v = draw.variant;
        if (!info(v.view).needsLight)
            return;
        v.directional = static_cast<int>(plan_.directional.size());
        v.decayOther = static_cast<int>(plan_.point.size());
        v.window = v.view == ViewMode::attenuation && v.decayOther > 0 && plan_.point[0].distance > 0;
        v.storage = storage_;
    }

    // A mesh without a light that has a direction is one colour, and needs no equation at its pixels: what it gives off, or
    // what it reflects of ambient light, in the shader's own roundings. With both, the shader adds them.
    void flatten(Draw& draw) const {
        const Variant v = draw.variant;
        if (!settings_.skip || v.scaled || v.directional + v.point() > 0 || v.clustered != 0)
            return;
        const glm::vec3 D = v.has(Term::albedo) ? glm::vec3(draw.albedo) : glm::vec3(1);
        const glm::vec3 reflected = v.has(Term::ambient) ? D * glm::vec3(plan_.ambient) : glm::vec3(0);
        const glm::vec3 color = v.emissive ? glm::vec3(draw.emitted) : reflected;
        if ((v.emissive && reflected != glm::vec3(0)) || !(largest(glm::dvec3(color)) <= 1e30))
            return;
        draw.albedo = glm::dvec3(color);
        draw.variant = Variant{};
        draw.variant.countNonfinite = v.countNonfinite;
        draw.variant.view = v.view;
    }

    static void dropIdle(Variant& v) {
        const auto drop = [&v](bool idle, std::initializer_list<Term> list) {
            for (const Term term : list)
                if (idle)
                    v.drop(term);
        };
        const bool point = v.point() > 0 || v.clustered != 0;
        drop(v.directional == 0, {Term::directional});
        drop(!point, {Term::point, Term::attenuation});
        drop(v.point() == v.decay0 && (v.clustered & ~1U) == 0 && !v.window, {Term::attenuation});
        drop(v.directional == 0 && !point, {Term::cosine, Term::clamp, Term::lightColor, Term::specular});
        drop(!v.ambient, {Term::ambient});
    }

    FramePlan& plan_;
    const Settings& settings_;
    const bool hasAmbient_;
    std::vector<std::vector<const THREE::Light*>> missing_;  // by draw: what ends before it
    bool tooManySums_ = false;
    bool allUsed_ = false;  // some mesh has all lights
    bool clustered_ = false;
    LightStorage storage_ = LightStorage::uniforms;
};

}  // namespace

void distributeLights(FramePlan& plan, const Settings& settings, bool hasAmbient) {
    Distribution(plan, settings, hasAmbient).run();
}

}  // namespace lighting
