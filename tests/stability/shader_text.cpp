// Reads the put-together shaders, and changes one.
// SPDX-License-Identifier: MIT
#include "stability/shader_text.hpp"

#include "lighting/terms.hpp"
#include "render/gl_renderer.hpp"
#include "render/shader_source.hpp"
#include "support/program.hpp"

#include <filesystem>
#include <stdexcept>

namespace stability {

void requireHighp(Outcome& outcome) {
    lighting::Variant variant;
    variant.terms = lighting::TermSet::all().bits();
    variant.lit = variant.ambient = variant.window = variant.scaled = variant.countNonfinite = true;
    variant.directional = variant.decay0 = variant.decay1 = variant.decay2 = variant.decayOther = 1;
    for (const std::string file : {"mesh.vert", "mesh.frag", "gouraud.vert", "gouraud.frag", "unlit.frag"})
        for (const auto storage : {lighting::LightStorage::uniforms, lighting::LightStorage::texture}) {
            variant.storage = storage;
            const bool fragment = file.ends_with(".frag");
            const std::string text = render::readShader(render::findShaderDirectory(""), file,
                                                        render::preamble(variant, {}, fragment))
                                         .text;
            for (const char* line : {"precision highp float;", "precision highp int;"})
                require(outcome, text.find(line) != std::string::npos, file + " does not say '" + line + "'");
            for (const char* word : {"mediump", "lowp"})
                require(outcome, text.find(word) == std::string::npos, file + " says '" + word + "'");
        }
}

image::Floats drawExpression(const lighting::FramePlan& plan, const support::DrawOptions& options,
                             const std::string& expression) {
    const support::TemporaryDirectory directory;
    std::filesystem::copy(render::findShaderDirectory(""), directory.path(),
                          std::filesystem::copy_options::recursive);
    const std::string file = directory.file("mesh.frag");
    std::string text = support::readFile(file);
    const std::size_t line = text.find("write_pixel(add(");
    if (line == std::string::npos)
        throw std::logic_error("mesh.frag no longer writes its pixel as this test expects");
    text.replace(line, text.find('\n', line) - line, "write_pixel(" + expression + ");");
    support::writeFile(file, text);
    render::GlRenderer renderer(directory.path());
    return std::get<image::Floats>(
        renderer.render(plan, options.settings, {options.width, options.height, true}).pixels);
}

}  // namespace stability
