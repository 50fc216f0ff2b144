// The thread, and a triangle that nobody sees.
// SPDX-License-Identifier: MIT
#include "render/compile_aside.hpp"

#include "render/gpu_geometry.hpp"
#include "render/render_target.hpp"

#include <exception>
#include <utility>

namespace render {

namespace {

// What a first frame would draw into, where the context has no surface of the window's own format.
class Canvas {
  public:
    Canvas() {
        glGenVertexArrays(1, &vertexArray_);
        glBindVertexArray(vertexArray_);
        glGenBuffers(1, &vertices_);
        glBindBuffer(GL_ARRAY_BUFFER, vertices_);
        const float nothing[18] = {};
        glBufferData(GL_ARRAY_BUFFER, sizeof nothing, nothing, GL_STATIC_DRAW);
        describeVertices();
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            target_.emplace(16, 16, PixelFormat::codes,
                            false);  // as frames without a window have it, and bound
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LEQUAL);
        glEnable(GL_CULL_FACE);
        glDisable(GL_DITHER);
    }
    ~Canvas() {
        glDeleteBuffers(1, &vertices_);
        glDeleteVertexArrays(1, &vertexArray_);
    }
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    void draw(const Program& program) const {
        glUseProgram(program.id);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glUseProgram(0);
        glFinish();
    }

  private:
    GLuint vertexArray_ = 0, vertices_ = 0;
    std::optional<RenderTarget> target_;
};

}  // namespace

CompileAside::CompileAside() {
    if (usable())
        thread_ = std::thread([this] { run(); });
}

CompileAside::~CompileAside() {
    {
        const std::lock_guard lock(mutex_);
        leave_ = true;
    }
    changed_.notify_all();
    if (thread_.joinable())
        thread_.join();
    for (const Done& done : done_)
        glDeleteProgram(done.program.id);
}

void CompileAside::ask(ProgramKey key, std::function<Program()> build) {
    {
        const std::lock_guard lock(mutex_);
        tasks_.push_back({std::move(key), std::move(build)});
    }
    changed_.notify_all();
}

std::vector<CompileAside::Done> CompileAside::take(bool wait) {
    std::unique_lock lock(mutex_);
    if (wait)
        changed_.wait(lock, [this] { return tasks_.empty() && !busy_; });
    return std::exchange(done_, {});
}

void CompileAside::run() {
    const bool current = context_.makeCurrent();
    {
        std::optional<Canvas> canvas;
        try {
            if (current)
                canvas.emplace();
        } catch (const std::exception&) {  // no memory for a few pixels: everything that is asked for fails
        }
        std::unique_lock lock(mutex_);
        for (;;) {
            changed_.wait(lock, [this] { return leave_ || !tasks_.empty(); });
            if (leave_)
                break;
            Task task = std::move(tasks_.front());
            tasks_.pop_front();
            busy_ = true;
            lock.unlock();
            Done done{std::move(task.key), {}, !canvas};
            try {
                if (canvas) {
                    done.program = task.build();
                    canvas->draw(done.program);
                }
            } catch (const std::exception&) {
                done.failed = true;  // compiled where it is needed, it will say why
            }
            lock.lock();
            done_.push_back(std::move(done));
            busy_ = false;
            changed_.notify_all();
        }
    }
    if (current)
        context_.release();
}

}  // namespace render
