// Turns a frame plan into GL calls.
// SPDX-License-Identifier: MIT
#include "render/gl_renderer.hpp"

#include "render/error.hpp"

#include <algorithm>
#include <chrono>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x3.hpp>
#include <stdexcept>
#include <utility>

namespace render {

namespace {

constexpr std::size_t constantsAtOnce =
    64;  // compiling so many lights in takes no longer than a frame or two
constexpr std::size_t mostLights =
    200'000;  // with four lights a turn, the most that drivers' loops are sure to finish

// Milliseconds since it was last asked, or made.
class Stopwatch {
  public:
    double lap() {
        const Clock::time_point before = std::exchange(last_, Clock::now());
        return std::chrono::duration<double, std::milli>(last_ - before).count();
    }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point last_ = Clock::now();
};

}  // namespace

GlRenderer::GlRenderer(std::string shaderDirectory, Compile when)
    : programs_(std::move(shaderDirectory), when) {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDisable(GL_DITHER);  // a code is the equation's value rounded, nothing else
}

std::string GlRenderer::name() const {
    const auto text = [](GLenum what) {
        return std::string(reinterpret_cast<const char*>(glGetString(what)));
    };
    return text(GL_RENDERER) + ", " + text(GL_VERSION);
}

RenderTarget& GlRenderer::target(const FrameRequest& request, bool countNonfinite) {
    const PixelFormat format = request.floats ? PixelFormat::floats : PixelFormat::codes;
    if (target_ == nullptr || target_->width() != request.width || target_->height() != request.height ||
        target_->format() != format || target_->countsNonfinite() != countNonfinite) {
        target_.reset();  // the old one's memory first
        target_ = std::make_unique<RenderTarget>(request.width, request.height, format, countNonfinite);
    }
    return *target_;
}

image::Frame GlRenderer::render(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera,
                                const lighting::Settings& settings, const FrameRequest& request) {
    Stopwatch watch;
    const lighting::FramePlan plan = lighting::planFrame(scene, camera, settings);
    const double planned = watch.lap();
    image::Frame frame = render(plan, settings, request);
    stats_.planMilliseconds = planned;
    return frame;
}

image::Frame GlRenderer::render(const lighting::FramePlan& plan, const lighting::Settings& settings,
                                const FrameRequest& request) {
    const Part whole{&plan, &settings, 0, request.width};
    return render({&whole, 1}, request);
}

image::Frame GlRenderer::render(std::span<const Part> parts, const FrameRequest& request) {
    check(parts);
    const bool countNonfinite = parts[0].settings->countNonfinite;
    RenderTarget& into = target(request, countNonfinite);
    into.bind();
    draw(parts, request.width, request.height);
    Stopwatch watch;
    glFinish();  // reading would wait just so; this tells the two apart
    stats_.finishMilliseconds = watch.lap();
    image::Frame frame = into.read();
    stats_.readMilliseconds = watch.lap();
    if (countNonfinite)
        stats_.nonfinite = into.countNonfinite();
    if (glGetError() == GL_OUT_OF_MEMORY)
        throw NoRenderer(
            "the driver ran out of memory while drawing; choose a smaller --size or a smaller scene.");
    return frame;
}

void GlRenderer::renderOnly(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera,
                            const lighting::Settings& settings, const FrameRequest& request) {
    const lighting::FramePlan plan = lighting::planFrame(scene, camera, settings);
    const Part whole{&plan, &settings, 0, request.width};
    target(request, settings.countNonfinite).bind();
    draw({&whole, 1}, request.width, request.height);
    glFinish();
}

void GlRenderer::check(std::span<const Part> parts) const {
    if (parts.empty() || parts.size() > partLights_.size())
        throw std::invalid_argument("a picture of " + std::to_string(parts.size()) +
                                    " parts; expected one or two");
}

// Throws NoRenderer before anything is drawn.
void GlRenderer::draw(std::span<const Part> parts, int width, int height) {
    for (const Part& part : parts) {
        const std::size_t lights = part.plan->directional.size() + part.plan->point.size();
        if (lights > mostLights)
            throw NoRenderer(
                "the scene has " + std::to_string(lights) + " lights; expected at most " +
                std::to_string(mostLights) +
                ", because drivers end a shader's loop there without a word. Leave some out, or draw with "
                "--renderer reference.");
    }
    const auto uploaded = [this] {
        return geometries_.uploadedBytes() + partLights_[0].uploadedBytes() + partLights_[1].uploadedBytes() +
               clusters_.uploadedBytes();
    };
    const std::uint64_t before = uploaded();
    stats_ = FrameStats{};
    programs_.beginFrame();
    for (std::size_t i = 0; i < parts.size(); ++i) {
        lights_ = &partLights_[std::min(i, partLights_.size() - 1)];
        drawPart(parts[i], width, height);
    }
    glBindVertexArray(0);
    glDisable(GL_SCISSOR_TEST);
    geometries_.endFrame();
    stats_.uploadedBytes = uploaded() - before;
    stats_.compileMilliseconds = programs_.compileMilliseconds();
}

// What a plan adds to the frame's stats before anything of it is drawn.
void GlRenderer::count(const lighting::FramePlan& plan) {
    stats_.meshesSkipped += plan.meshesSkipped;
    stats_.lightsUsed += plan.lightsUsed;
    stats_.lightsSkipped += plan.lightsSkipped;
    stats_.pairsSkipped += plan.pairsSkipped;
    stats_.sidesSkipped += plan.sidesSkipped;
    stats_.cutCodes = std::max(stats_.cutCodes, plan.cutCodes);
    stats_.skipped.insert(stats_.skipped.end(), plan.skipped.begin(), plan.skipped.end());
    stats_.shiny |= plan.shiny;
}

void GlRenderer::drawPart(const Part& part, int width, int height) {
    const lighting::FramePlan& plan = *part.plan;
    const lighting::Settings& settings = *part.settings;
    count(plan);
    glViewport(0, 0, width, height);
    glEnable(GL_DEPTH_TEST);  // a panel drawn over the last frame may have changed it
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    if (part.firstColumn == 0 && part.endColumn == width) {
        glDisable(GL_SCISSOR_TEST);
    } else {
        glEnable(GL_SCISSOR_TEST);
        glScissor(part.firstColumn, 0, part.endColumn - part.firstColumn, height);
    }
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    const glm::vec3 background(plan.background);
    const float color[] = {background.r, background.g, background.b, 1};
    const float far[] = {1};
    const float unmarked[] = {0, 0, 0, 0};
    glClearBufferfv(GL_COLOR, 0, color);
    glClearBufferfv(GL_DEPTH, 0, far);
    if (settings.countNonfinite)
        glClearBufferfv(GL_COLOR, 1, unmarked);

    inUse_ = {};
    lights_->set(plan);
    if (std::any_of(plan.draws.begin(), plan.draws.end(),
                    [](const lighting::Draw& mesh) { return mesh.variant.clustered != 0; })) {
        clusters_.set(lighting::clusterLights(plan, settings.skip), width, height, settings.skip);
        stats_.clusters += clusters_.clusters().count();
        stats_.clusterEntries += clusters_.clusters().lights.size();
    }
    for (const lighting::Draw& mesh : plan.draws)
        drawMesh(mesh, plan.eye, settings);
}

// Whether the lights have stood still for long enough to be compiled in: where that happens aside, while something else is drawn.
bool GlRenderer::worthCompiling(std::size_t lights) const {
    return lights > constantsAtOnce || programs_.aside() ? lights_->lasting() : lights_->settled();
}

// Makes the program of a draw the one in use, with its lights; where `reuse`, only if the draw before had another.
const Program& GlRenderer::useProgram(const lighting::Draw& draw, bool reuse) {
    if (reuse && inUse_.program != nullptr && inUse_.variant == draw.variant && inUse_.lights == draw.lights)
        return *inUse_.program;
    const LightNumbers& lights = lights_->of(draw.lights);
    lighting::Variant variant = draw.variant;
    if (variant.storage == lighting::LightStorage::constants && !worthCompiling(lights.count()))
        variant.storage = lighting::LightStorage::uniforms;
    Program& program = programs_.get(variant, lights);
    glUseProgram(program.id);
    if (variant.lit)
        lights_->use(program, draw.lights, reuse);
    if (variant.clustered != 0)
        clusters_.use(program);
    stats_.variants.insert(variant);
    inUse_ = {draw.variant, draw.lights, &program};
    return program;
}

void GlRenderer::drawMesh(const lighting::Draw& draw, const glm::dvec3& eyePosition,
                          const lighting::Settings& settings) {
    const Program& program = useProgram(draw, settings.skip);
    const GpuGeometry& geometry = geometries_.get(draw, settings.skip);

    const glm::mat4 clip(draw.clip);
    const glm::mat4x3 model{glm::dmat4x3(draw.model)};
    const glm::mat3 normal(draw.normalMatrix);
    const glm::vec3 albedo(draw.albedo);
    const glm::vec3 emitted(draw.emitted);
    const glm::vec3 specular(draw.specular);
    const glm::vec3 eye(eyePosition);
    glUniformMatrix4fv(program.modelViewProjectionMatrix, 1, GL_FALSE, glm::value_ptr(clip));
    glUniformMatrix4x3fv(program.modelMatrix, 1, GL_FALSE, glm::value_ptr(model));
    glUniformMatrix3fv(program.normalMatrix, 1, GL_FALSE, glm::value_ptr(normal));
    glUniform3fv(program.baseColor, 1, glm::value_ptr(albedo));
    glUniform3fv(program.emissive, 1, glm::value_ptr(emitted));
    glUniform3fv(program.specularColor, 1, glm::value_ptr(specular));
    glUniform1f(program.shininess, static_cast<float>(draw.shininess));
    glUniform3fv(program.eyePosition, 1, glm::value_ptr(eye));

    if (draw.side == THREE::DoubleSide)
        glDisable(GL_CULL_FACE);
    else
        glEnable(GL_CULL_FACE);
    glCullFace(draw.side == THREE::BackSide ? GL_FRONT : GL_BACK);
    glFrontFace(draw.mirrored ? GL_CW : GL_CCW);

    glBindVertexArray(geometry.vertexArray);
    if (geometry.indexed)
        glDrawElements(GL_TRIANGLES, geometry.count, GL_UNSIGNED_INT, nullptr);
    else
        glDrawArrays(GL_TRIANGLES, 0, geometry.count);
    ++stats_.drawCalls;
    ++stats_.meshesDrawn;
    stats_.triangles += geometry.count / 3;
}

}  // namespace render
