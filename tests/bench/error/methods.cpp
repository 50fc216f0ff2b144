// The table of methods, and how each draws.
// SPDX-License-Identifier: MIT
#include "bench/error/methods.hpp"

#include "render/gl_renderer.hpp"
#include "render/reference_renderer.hpp"
#include "render/shader_source.hpp"

#include <algorithm>

namespace bench::error {

namespace {

using lighting::Shading;

const std::vector<Method> table = {
    {.id = "default", .title = "default (fused and guarded)", .known = "nothing within (18 + N) u S"},
    {.id = "three_js",
     .title = "three.js's order",
     .known = "f never exceeds 100; more roundings, and those of pow",
     .overlay = true},
    {.id = "scaled",
     .title = "fused and scaled",
     .known = "nothing, but most scenes do not need it",
     .scaled = true},
    {.id = "rrr",
     .title = "r r r",
     .known = "the rounding of r counts k + 1 times; not a number at the light itself",
     .overlay = true},
    {.id = "cpu_double",
     .title = "CPU double",
     .known = "nothing: it rounds to float once; it draws without the driver",
     .kind = Kind::processor},
    {.id = "exp2_log2",
     .title = "exp2(log2)",
     .known = "the absolute error of the exponent becomes a relative one; not a number at the light itself",
     .overlay = true},
    {.id = "per_vertex",
     .title = "per vertex",
     .known = "what is between the vertices is interpolated: terminator and peaks are missed",
     .shading = Shading::vertex,
     .approximate = true},
    {.id = "flat",
     .title = "flat",
     .known = "one normal for a whole triangle",
     .shading = Shading::flat,
     .approximate = true},
    {.id = "unnormalised",
     .title = "unnormalised normal",
     .known = "interpolated normals are shorter than 1, so triangles are too dark in the middle",
     .overlay = true,
     .approximate = true},
    {.id = "mediump",
     .title = "mediump",
     .known = "11 bits of mantissa, infinite beyond 65,504",
     .overlay = true,
     .approximate = true},
    {.id = "mediump_mixed",
     .title = "mixed mediump",
     .known = "colours and sums have 11 bits of mantissa",
     .overlay = true,
     .approximate = true},
    {.id = "fast_inverse_sqrt",
     .title = "0x5f3759df + 1 Newton step",
     .known = "1/d is off by up to 0.18 %, k + 1 times",
     .overlay = true,
     .approximate = true},
    {.id = "cut_0.5",
     .title = "range cut at 0.5 code",
     .known = "light is missing, together at most half a code",
     .cut = 0.5,
     .approximate = true},
    {.id = "cut_0.01",
     .title = "range cut at 0.01 code",
     .known = "light is missing, together at most a hundredth of a code",
     .cut = 0.01,
     .approximate = true},
    {.id = "half_sum",
     .title = "half accumulation",
     .known = "the sum has 11 bits of mantissa: small addends are lost",
     .overlay = true,
     .approximate = true},
    {.id = "passes_8_bit",
     .title = "8-bit additive passes",
     .known = "half a code for every light",
     .kind = Kind::passes,
     .approximate = true},
};

// Makes lights invisible as long as it lives.
class Hidden {
  public:
    Hidden() = default;
    ~Hidden() {
        for (THREE::Light* light : lights_)
            light->visible = true;
    }
    Hidden(const Hidden&) = delete;
    Hidden& operator=(const Hidden&) = delete;
    void hide(THREE::Light& light) {
        light.visible = false;
        lights_.push_back(&light);
    }

  private:
    std::vector<THREE::Light*> lights_;
};

std::string shaderDirectory(const Method& method) {
    const std::string overlays = std::string(LAMBERT_SOURCE_DIR) + "/tests/bench/error/methods/";
    return render::findShaderDirectory(method.overlay ? overlays + method.id : std::string());
}

class ShaderDrawer : public Drawer {
  public:
    ShaderDrawer(const Method& method, World& world, int size)
        : method_(method), world_(world), size_(size), renderer_(shaderDirectory(method)) {}

    image::Frame draw(bool floats) override {
        lighting::Settings settings = world_.settings;
        settings.shading = method_.shading;
        settings.lightCut = method_.cut;
        lighting::FramePlan plan = lighting::planFrame(world_.scene, world_.camera, settings);
        for (lighting::Draw& draw : plan.draws)
            draw.variant.scaled |= draw.variant.lit && method_.scaled;
        return renderer_.render(plan, settings, {size_, size_, floats});
    }

  protected:
    const Method& method_;
    World& world_;
    int size_;

  private:
    render::GlRenderer renderer_;
};

// Every light alone into 8 bits, added up as an 8-bit frame buffer adds: rounded each time, saturated.
class PassesDrawer : public ShaderDrawer {
  public:
    using ShaderDrawer::ShaderDrawer;

    image::Frame draw(bool floats) override {
        image::Frame sum{size_, size_, image::Bytes(static_cast<std::size_t>(size_ * size_ * 3))};
        auto& codes = std::get<image::Bytes>(sum.pixels);
        for (THREE::Light* shining : world_.lights()) {
            Hidden hidden;
            for (THREE::Light* light : world_.lights())
                if (light != shining)
                    hidden.hide(*light);
            const image::Frame pass = ShaderDrawer::draw(false);
            const auto& added = std::get<image::Bytes>(pass.pixels);
            for (std::size_t i = 0; i < codes.size(); ++i)
                codes[i] = static_cast<std::uint8_t>(std::min(codes[i] + added[i], 255));
        }
        if (floats)
            sum.pixels = image::toFloats(sum);
        return sum;
    }
};

class ProcessorDrawer : public Drawer {
  public:
    ProcessorDrawer(World& world, int size) : world_(world), size_(size) {}

    image::Frame draw(bool floats) override {
        return renderer_.render(world_.scene, world_.camera, world_.settings, {size_, size_, floats});
    }

  private:
    World& world_;
    int size_;
    render::ReferenceRenderer renderer_;
};

}  // namespace

const std::vector<Method>& methods() { return table; }

bool isDefault(const Method& method, const World& world) {
    if (method.cut == 0)
        return &method == &table[defaultMethod];
    lighting::Settings settings = world.settings;
    settings.lightCut = method.cut;
    return lighting::planFrame(world.scene, world.camera, settings).cutCodes == 0;
}

std::unique_ptr<Drawer> makeDrawer(const Method& method, World& world, int size) {
    if (method.kind == Kind::processor)
        return std::make_unique<ProcessorDrawer>(world, size);
    if (method.kind == Kind::passes)
        return std::make_unique<PassesDrawer>(method, world, size);
    return std::make_unique<ShaderDrawer>(method, world, size);
}

}  // namespace bench::error
