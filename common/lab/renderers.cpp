// Makes contexts and renderers on first need.
// SPDX-License-Identifier: MIT
#include "lab/renderers.hpp"

#include "render/gl_renderer.hpp"
#include "render/reference_renderer.hpp"
#include "render/shader_source.hpp"

namespace lab {

using Clock = std::chrono::steady_clock;

render::Renderer& Renderers::get(const Options& options) {
    if (options.renderer == RendererKind::reference) {
        const auto tell = [this](double share) {
            if (showProgress && !progress_)
                progress_.emplace();
            if (progress_)
                progress_->step(share, std::to_string(static_cast<int>(share * 100)) + " %");
        };
        if (reference_ == nullptr)
            reference_ = std::make_unique<render::ReferenceRenderer>(tell);
        return *reference_;
    }
    if (const auto known = gl_.find(options.shaders); known != gl_.end())
        return *known->second;
    if (!context_)
        context_.emplace();
    return *gl_.emplace(options.shaders,
                        std::make_unique<render::GlRenderer>(render::findShaderDirectory(options.shaders)))
                .first->second;
}

void Renderers::pictureIsDrawn() {
    progress_.reset();
    if (!firstPicture_)
        firstPicture_ = Clock::now();
}

double Renderers::millisecondsSinceFirstPicture() const {
    return firstPicture_ ? std::chrono::duration<double, std::milli>(Clock::now() - *firstPicture_).count()
                         : 0;
}

}  // namespace lab
