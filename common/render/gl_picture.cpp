// The window's picture, and the programs that it will want next.
// SPDX-License-Identifier: MIT
#include "render/gl_renderer.hpp"

#include <stdexcept>

namespace render {

RenderTarget& GlRenderer::pictureTarget(int width, int height) {
    if (picture_ == nullptr || picture_->width() != width || picture_->height() != height) {
        pictureDrawn_ = false;
        picture_.reset();  // the old one's memory first
        picture_ = std::make_unique<RenderTarget>(width, height, PixelFormat::codes, false);
    }
    return *picture_;
}

// All are asked, so that what is missing is compiled one after the other without another question.
bool GlRenderer::ready(std::span<const Part> parts) {
    bool all = true;
    for (const Part& part : parts)
        for (const lighting::Draw& draw : part.plan->draws)
            all = programs_.ready(draw.variant) && all;
    return all;
}

bool GlRenderer::drawPicture(std::span<const Part> parts, int width, int height) {
    check(parts);
    const bool stays =
        pictureDrawn_ && picture_ != nullptr && picture_->width() == width && picture_->height() == height;
    if (stays && !ready(parts))
        return false;
    drawIntoPicture(parts, width, height);
    return true;
}

void GlRenderer::drawIntoPicture(std::span<const Part> parts, int width, int height) {
    pictureTarget(width, height).bind();
    draw(parts, width, height);
    pictureDrawn_ = true;
}

void GlRenderer::setPicture(const image::Frame& frame) {
    pictureTarget(frame.width, frame.height).write(frame);
    pictureDrawn_ = true;
}

void GlRenderer::showPicture() {
    if (pictureDrawn_)
        picture_->show();
}

image::Frame GlRenderer::picture() const {
    if (!pictureDrawn_)
        throw std::logic_error("there is no picture yet; expected drawPicture() or setPicture() before.");
    return picture_->read();
}

std::array<std::uint8_t, 3> GlRenderer::pixel(int x, int y) const {
    if (!pictureDrawn_)
        throw std::logic_error("there is no picture yet; expected drawPicture() or setPicture() before.");
    return picture_->pixel(x, y);
}

void GlRenderer::prepare(const lighting::FramePlan& plan) {
    for (const lighting::Draw& draw : plan.draws)
        programs_.prepare(draw.variant);
}

}  // namespace render
