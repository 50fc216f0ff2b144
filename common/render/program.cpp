// Compiles and links the shaders of a variant.
// SPDX-License-Identifier: MIT
#include "render/program.hpp"

#include "render/compile_aside.hpp"
#include "render/error.hpp"
#include "render/shader_source.hpp"

#include <algorithm>
#include <chrono>

namespace render {

namespace {

constexpr int mostUniformLights = 256;
constexpr std::size_t mostPrograms = 256;

// The numbers that are compiled into a program: of each light a 1 if it moves, or a 0 and what it is.
std::vector<float> constantsOf(const lighting::Variant& variant, const LightNumbers& lights) {
    std::vector<float> out;
    if (variant.storage != lighting::LightStorage::constants)
        return out;
    for (std::size_t i = 0; i < lights.count(); ++i) {
        out.push_back(lights.moves[i] ? 1.0F : 0.0F);
        if (!lights.moves[i])
            for (const glm::vec4& v : {lights.geometry[i], lights.radiance[i], lights.falloff[i]})
                out.insert(out.end(), &v.x, &v.x + 4);
    }
    if (variant.ambient && !lights.ambientMoves)
        out.insert(out.end(), &lights.ambient.x, &lights.ambient.x + 3);
    return out;
}

// The program that draws a variant whatever the numbers of its lights are.
ProgramKey standIn(lighting::Variant variant) {
    if (variant.storage == lighting::LightStorage::constants)
        variant.storage = lighting::LightStorage::uniforms;
    return {variant, {}};
}

void forget(std::map<ProgramKey, Program>& programs) {
    for (const auto& [key, program] : programs)
        glDeleteProgram(program.id);
    programs.clear();
}

}  // namespace

Programs::Programs(std::string shaderDirectory, Compile when) : directory_(std::move(shaderDirectory)) {
    GLint fragment = 0, vertex = 0;
    glGetIntegerv(GL_MAX_FRAGMENT_UNIFORM_VECTORS, &fragment);  // at least 224
    glGetIntegerv(GL_MAX_VERTEX_UNIFORM_VECTORS, &vertex);  // at least 256
    uniformLights_ = std::min((std::min(fragment, vertex) - 24) / 3, mostUniformLights);
    if (when == Compile::aside)
        aside_ = std::make_unique<CompileAside>();
    if (aside_ && !aside_->usable())
        aside_.reset();
}

Programs::~Programs() {
    aside_.reset();  // before the programs that it may still compile have nobody to go to
    forget(programs_);
}

Program& Programs::get(const lighting::Variant& variant, const LightNumbers& lights) {
    const ProgramKey key{variant, constantsOf(variant, lights)};
    collect();
    Program* program = find(key);
    if (program == nullptr && aside_ && variant.storage == lighting::LightStorage::constants) {
        program = &make(standIn(variant), {});
        if (!failed_.contains(key))
            aside_->ask(Urgency::better, key, [this, variant, lights] { return build(variant, lights); });
    }
    if (program == nullptr)
        program = &make(key, lights);
    program->lastUsed = program->lastDrawn = ++calls_;
    return *program;
}

bool Programs::ready(const lighting::Variant& variant) {
    if (!aside_)
        return true;
    collect();
    const ProgramKey key = standIn(variant);
    if (find(key) != nullptr)
        return true;
    if (const auto failure = failed_.find(key); failure != failed_.end())
        throw ShaderError(failure->second);
    aside_->ask(Urgency::wanted, key, [this, general = key.first] { return build(general, {}); });
    return false;
}

void Programs::prepare(const lighting::Variant& variant) {
    const ProgramKey key = standIn(variant);
    if (aside_ && find(key) == nullptr && !failed_.contains(key))
        aside_->ask(Urgency::ahead, key, [this, general = key.first] { return build(general, {}); });
}

// All programs come from files as they are now, or all from files as they were.
bool Programs::reload(std::string& error) {
    std::map<ProgramKey, Program> again;
    try {
        for (const auto& [key, program] : programs_)
            if (const ProgramKey general = standIn(key.first);
                program.lastDrawn > frameBegan_ && !again.contains(general))
                again.emplace(general, build(general.first, {}));
    } catch (const ShaderError& failure) {
        error = failure.what();
        forget(again);
        return false;
    }
    if (aside_) {
        aside_->dropAll();
        forget(again);  // what draws with them is still to be compiled, by whom nobody waits for
    }
    forget(programs_);
    programs_ = std::move(again);
    failed_.clear();
    return true;
}

bool Programs::compiling() const { return aside_ && aside_->isWanted(); }

void Programs::onCompiled(std::function<void()> call) {
    if (aside_)
        aside_->onWanted(std::move(call));
}

Program* Programs::find(const ProgramKey& key) {
    const auto known = programs_.find(key);
    return known == programs_.end() ? nullptr : &known->second;
}

// The program, whoever has to wait for it.
Program& Programs::make(const ProgramKey& key, const LightNumbers& lights) {
    if (Program* const known = find(key))
        return *known;
    const auto start = std::chrono::steady_clock::now();
    if (aside_) {
        aside_->wait(&key);
        collect();
    }
    if (find(key) == nullptr)
        keep(key, build(key.first, lights));
    milliseconds_ +=
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return *find(key);
}

void Programs::collect() {
    if (!aside_)
        return;
    for (CompileAside::Done& done : aside_->take())
        if (done.failed)
            failed_.insert_or_assign(done.key, done.error);
        else
            keep(std::move(done.key), done.program);
}

// As if it had just been used: what was prepared is not forgotten before what nobody wants any more.
void Programs::keep(ProgramKey key, const Program& program) {
    const auto [place, isNew] = programs_.emplace(std::move(key), program);
    if (!isNew)
        glDeleteProgram(program.id);  // there is one by now
    place->second.lastUsed = ++calls_;
    if (programs_.size() > mostPrograms)
        forgetOldest();
}

void Programs::finish() {
    if (aside_)
        aside_->wait();
    collect();
}

// Lights that were moved by hand leave a program behind wherever they stood.
void Programs::forgetOldest() {
    const auto oldest =
        std::min_element(programs_.begin(), programs_.end(),
                         [](const auto& a, const auto& b) { return a.second.lastUsed < b.second.lastUsed; });
    glDeleteProgram(oldest->second.id);
    programs_.erase(oldest);
}

GLuint Programs::compile(GLenum stage, const std::string& file, const std::string& preamble) const {
    const ShaderSource source = readShader(directory_, file, preamble);
    const GLuint shader = glCreateShader(stage);
    const char* text = source.text.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint ok = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (ok == GL_TRUE)
        return shader;
    GLint length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    glGetShaderInfoLog(shader, length, nullptr, log.data());
    log.resize(log.find('\0') < log.size() ? log.find('\0') : log.size());
    glDeleteShader(shader);
    throw ShaderError("a shader of " + directory_ + " does not compile:\n" +
                      explain(log, directory_, source) +
                      "Correct the file and try again; --dump-shader writes the whole variant.");
}

Program Programs::build(const lighting::Variant& wanted, const LightNumbers& lights) const {
    lighting::Variant variant = wanted;
    if (variant.storage == lighting::LightStorage::uniforms &&
        variant.directional + variant.point() > uniformLights_)
        variant.storage = lighting::LightStorage::texture;  // this driver has few uniforms
    const ShaderFiles files = shaderFiles(variant);
    const GLuint vertex = compile(GL_VERTEX_SHADER, files.vertex, preamble(variant, lights, false));
    GLuint fragment = 0;
    try {
        fragment = compile(GL_FRAGMENT_SHADER, files.fragment, preamble(variant, lights, true));
    } catch (...) {
        glDeleteShader(vertex);
        throw;
    }
    Program program;
    program.id = glCreateProgram();
    glAttachShader(program.id, vertex);
    glAttachShader(program.id, fragment);
    glLinkProgram(program.id);
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    GLint ok = GL_FALSE;
    glGetProgramiv(program.id, GL_LINK_STATUS, &ok);
    if (ok != GL_TRUE) {
        char log[2048] = "";
        glGetProgramInfoLog(program.id, sizeof log, nullptr, log);
        glDeleteProgram(program.id);
        throw ShaderError("the shaders of " + directory_ + " compile but do not fit together (" +
                          files.vertex + ", " + files.fragment + "):\n" + log);
    }
    const auto locate = [&program](GLint& place, const char* name) {
        place = glGetUniformLocation(program.id, name);
    };
    locate(program.modelViewProjectionMatrix, "modelViewProjectionMatrix");
    locate(program.modelMatrix, "modelMatrix");
    locate(program.normalMatrix, "normalMatrix");
    locate(program.baseColor, "baseColor");
    locate(program.emissive, "emissive");
    locate(program.specularColor, "specularColor");
    locate(program.shininess, "shininess");
    locate(program.eyePosition, "eyePosition");
    locate(program.ambientLight, "ambientLight");
    locate(program.lightGeometry, "lightGeometry");
    locate(program.lightRadiance, "lightRadiance");
    locate(program.lightFalloff, "lightFalloff");
    locate(program.lightData, "lightData");
    locate(program.clusterBegins, "clusterBegins");
    locate(program.clusterLights, "clusterLights");
    locate(program.clusterGrid, "clusterGrid");
    locate(program.clusterScale, "clusterScale");
    program.constants = variant.storage == lighting::LightStorage::constants;
    return program;
}

ShaderFiles shaderFiles(const lighting::Variant& variant) {
    if (!variant.lit)
        return {"mesh.vert", "unlit.frag"};
    if (lighting::isData(variant.view))
        return {"mesh.vert", "view.frag"};
    return variant.perVertex ? ShaderFiles{"gouraud.vert", "gouraud.frag"}
                             : ShaderFiles{"mesh.vert", "mesh.frag"};
}

std::string dumpShaders(const std::string& directory, const lighting::FramePlan& plan,
                        const lighting::Draw& draw) {
    const lighting::Variant& variant = draw.variant;
    const LightNumbers lights = pick(numbersOf(plan), plan, plan.lightSets[draw.lights]);
    const auto part = [&](const std::string& file, bool fragment) {
        const ShaderSource source = readShader(directory, file, preamble(variant, lights, fragment));
        return "// ==== " + file + "\n" + source.text + "\n";
    };
    const ShaderFiles files = shaderFiles(variant);
    return part(files.vertex, false) + part(files.fragment, true);
}

}  // namespace render
