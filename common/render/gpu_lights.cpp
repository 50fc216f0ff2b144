// Packs lights into vec4s and sends them only when they changed.
// SPDX-License-Identifier: MIT
#include "render/gpu_lights.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <limits>

namespace render {

namespace {

constexpr std::size_t lightsPerRow = 512;  // shaders/lights.glsl counts on it

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

// Which lights move. Another number of lights is another scene, in which nothing has moved yet.
void GpuLights::watch() {
    const std::vector<bool> movedBefore = before_.moves;
    if (all_.count() != before_.count()) {
        framesStill_.assign(all_.count(), framesToStandStill);
        ambientStill_ = framesToStandStill;
        framesSettled_ = framesToSettle;
        return;
    }
    const bool ambientMoved = before_.ambientMoves;
    ambientStill_ = all_.ambient != before_.ambient ? 0 : std::min(ambientStill_ + 1, framesToStandStill);
    all_.ambientMoves = ambientStill_ < framesToStandStill;
    for (std::size_t i = 0; i < all_.count(); ++i) {
        const bool changed = all_.geometry[i] != before_.geometry[i] ||
                             all_.radiance[i] != before_.radiance[i] || all_.falloff[i] != before_.falloff[i];
        framesStill_[i] = changed ? 0 : std::min(framesStill_[i] + 1, framesToStandStill);
        all_.moves[i] = framesStill_[i] < framesToStandStill;
    }
    framesSettled_ = all_.moves == movedBefore && all_.ambientMoves == ambientMoved
                         ? std::min(framesSettled_ + 1, 2 * framesToSettle)
                         : 0;
}

void GpuLights::use(Program& program, std::size_t lightSet, bool reuse) {
    if (program.ambientLight >= 0 && (!reuse || program.lights.ambient != all_.ambient)) {
        glUniform3fv(program.ambientLight, 1, &all_.ambient.x);
        uploaded_ += sizeof all_.ambient;
        program.lights.ambient = all_.ambient;
    }
    if (program.lightData >= 0) {
        uploadTexture(reuse);
        return;
    }
    if (program.lightGeometry < 0 && program.lightRadiance < 0 && program.lightFalloff < 0)
        return;  // all are constants
    const LightNumbers& set = sets_[lightSet];
    const LightNumbers now{inUniforms(set.geometry, set.moves, program.constants),
                           inUniforms(set.radiance, set.moves, program.constants),
                           inUniforms(set.falloff, set.moves, program.constants),
                           {},
                           program.lights.ambient};
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

void GpuLights::uploadTexture(bool reuse) {
    glActiveTexture(GL_TEXTURE0);
    if (texture_ == 0) {
        glGenTextures(1, &texture_);
        glBindTexture(GL_TEXTURE_2D, texture_);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    }
    glBindTexture(GL_TEXTURE_2D, texture_);
    if (reuse && same(inTexture_, all_))
        return;
    const std::size_t rows = (all_.count() + lightsPerRow - 1) / lightsPerRow;
    std::vector<glm::vec4> texels(rows * lightsPerRow * 3, glm::vec4(0));
    for (std::size_t light = 0; light < all_.count(); ++light) {
        texels[light * 3] = all_.geometry[light];
        texels[light * 3 + 1] = all_.radiance[light];
        texels[light * 3 + 2] = all_.falloff[light];
    }
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, lightsPerRow * 3, static_cast<GLsizei>(rows), 0, GL_RGBA,
                 GL_FLOAT, texels.data());
    inTexture_ = all_;
    uploaded_ += texels.size() * sizeof texels[0];
}

}  // namespace render
