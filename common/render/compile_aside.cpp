// The thread, and a triangle that nobody sees.
// SPDX-License-Identifier: MIT
#include "render/compile_aside.hpp"

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
        for (GLuint i = 0; i < 2; ++i) {  // as gpu_geometry.cpp lays vertices out
            glEnableVertexAttribArray(i);
            glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, 24,
                                  reinterpret_cast<const void*>(std::size_t{12} * i));
        }
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            makeTarget();
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LEQUAL);
        glEnable(GL_CULL_FACE);
        glDisable(GL_DITHER);
    }
    ~Canvas() {
        glDeleteFramebuffers(1, &framebuffer_);
        glDeleteRenderbuffers(2, buffers_);
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
    void makeTarget() {
        glGenFramebuffers(1, &framebuffer_);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        glGenRenderbuffers(2, buffers_);
        const GLenum formats[] = {GL_RGBA8, GL_DEPTH_COMPONENT24};
        const GLenum places[] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
        for (int i = 0; i < 2; ++i) {
            glBindRenderbuffer(GL_RENDERBUFFER, buffers_[i]);
            glRenderbufferStorage(GL_RENDERBUFFER, formats[i], 16, 16);
            glFramebufferRenderbuffer(GL_FRAMEBUFFER, places[i], GL_RENDERBUFFER, buffers_[i]);
        }
    }

    GLuint vertexArray_ = 0, vertices_ = 0, framebuffer_ = 0;
    GLuint buffers_[2] = {0, 0};
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
        if (current)
            canvas.emplace();
        std::unique_lock lock(mutex_);
        for (;;) {
            changed_.wait(lock, [this] { return leave_ || !tasks_.empty(); });
            if (leave_)
                break;
            Task task = std::move(tasks_.front());
            tasks_.pop_front();
            busy_ = true;
            lock.unlock();
            Done done{std::move(task.key), {}, !current};
            try {
                if (current) {
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
