// Packs lights into vec4s and sends them only when they changed.
// SPDX-License-Identifier: MIT
#include "render/gpu_lights.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <limits>
#include <unordered_map>

namespace render {

namespace {

constexpr std::size_t lightsPerRow = 512;  // shaders/lights.glsl counts on it
constexpr std::size_t mostWatched = 4096;  // far more than constants and uniforms hold

bool same(const LightNumbers& a, const LightNumbers& b) {
    return a.geometry == b.geometry && a.radiance == b.radiance && a.falloff == b.falloff;
}

// The vec4s of a sum as the uniforms have them: of all its lights, or of those that move.
std::vector<glm::vec4> inUniforms(const std::vector<glm::vec4>& all, const std::vector<bool>& moves,
                                  bool onlyMoving) {
    std::vector<glm::vec4> out;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (!onlyMoving || moves[i])
            out.push_back(all[i]);
    return out;
}

}  // namespace

GpuLights::~GpuLights() { glDeleteTextures(1, &texture_); }

void GpuLights::set(const lighting::FramePlan& plan) {
    std::swap(before_, all_);
    all_ = numbersOf(plan);
    watch();
    sets_.clear();
    for (const lighting::LightSet& set : plan.lightSets)
        sets_.push_back(pick(all_, plan, set));
}

// Which lights move. One that was not there in the frame before has not been seen to move, and where none was, it is another
// scene. (A lamp that flickers comes and goes while others move, so their number says nothing.)
void GpuLights::watch() {
    std::unordered_map<const THREE::Light*, std::size_t> before;
    for (std::size_t i = 0; i < before_.count() && all_.count() <= mostWatched; ++i)
        before.emplace(before_.lights[i], i);
    std::vector<int> still(all_.count(), framesToStandStill);
    std::vector<const THREE::Light*> moving;
    bool known = false;
    for (std::size_t i = 0; i < all_.count() && !before.empty(); ++i) {
        const auto found = before.find(all_.lights[i]);
        if (found == before.end())
            continue;
        known = true;
        const std::size_t was = found->second;
        const bool changed = all_.geometry[i] != before_.geometry[was] ||
                             all_.radiance[i] != before_.radiance[was] ||
                             all_.falloff[i] != before_.falloff[was];
        still[i] = changed ? 0 : std::min(framesStill_[was] + 1, framesToStandStill);
        all_.moves[i] = still[i] < framesToStandStill;
        if (all_.moves[i])
            moving.push_back(all_.lights[i]);
    }
    std::sort(moving.begin(), moving.end());
    ambientStill_ =
        !known || before_.ambient == all_.ambient ? std::min(ambientStill_ + 1, framesToStandStill) : 0;
    all_.ambientMoves = known && ambientStill_ < framesToStandStill;
    const bool same = moving == moving_ && all_.ambientMoves == before_.ambientMoves;
    framesSettled_ = !known ? framesToSettle : same ? std::min(framesSettled_ + 1, 2 * framesToSettle) : 0;
    framesStill_ = std::move(still);
    moving_ = std::move(moving);
}

void GpuLights::use(Program& program, std::size_t lightSet, bool reuse) {
    if (program.ambientLight >= 0 && (!reuse || program.lights.ambient != all_.ambient)) {
        glUniform3fv(program.ambientLight, 1, &all_.ambient.x);
        uploaded_ += sizeof all_.ambient;
        program.lights.ambient = all_.ambient;
    }
    if (program.lightData >= 0) {
        uploadTexture(sets_[lightSet], reuse);
        return;
    }
    if (program.lightGeometry < 0 && program.lightRadiance < 0 && program.lightFalloff < 0)
        return;  // all are constants
    const LightNumbers& set = sets_[lightSet];
    const LightNumbers now{inUniforms(set.geometry, set.moves, program.constants),
                           inUniforms(set.radiance, set.moves, program.constants),
                           inUniforms(set.falloff, set.moves, program.constants),
                           {},
                           {},
                           program.lights.ambient,
                           false};
    if (reuse && same(program.lights, now))
        return;
    const auto send = [this](GLint place, const std::vector<glm::vec4>& values) {
        if (place < 0 || values.empty())
            return;
        glUniform4fv(place, static_cast<GLsizei>(values.size()), &values[0].x);
        uploaded_ += values.size() * sizeof values[0];
    };
    send(program.lightGeometry, now.geometry);
    send(program.lightRadiance, now.radiance);
    send(program.lightFalloff, now.falloff);
    program.lights = now;
}

// The lights are those of a sum: all of them, unless this driver has so few uniforms that what the plan wants in uniforms is in
// a texture.
void GpuLights::uploadTexture(const LightNumbers& lights, bool reuse) {
    glActiveTexture(GL_TEXTURE0);
    if (texture_ == 0) {
        glGenTextures(1, &texture_);
        glBindTexture(GL_TEXTURE_2D, texture_);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    }
    glBindTexture(GL_TEXTURE_2D, texture_);
    if (reuse && same(inTexture_, lights))
        return;
    const std::size_t rows = (lights.count() + lightsPerRow - 1) / lightsPerRow;
    std::vector<glm::vec4> texels(rows * lightsPerRow * 3, glm::vec4(0));
    for (std::size_t light = 0; light < lights.count(); ++light) {
        texels[light * 3] = lights.geometry[light];
        texels[light * 3 + 1] = lights.radiance[light];
        texels[light * 3 + 2] = lights.falloff[light];
    }
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, lightsPerRow * 3, static_cast<GLsizei>(rows), 0, GL_RGBA,
                 GL_FLOAT, texels.data());
    inTexture_ = lights;
    uploaded_ += texels.size() * sizeof texels[0];
}

}  // namespace render
