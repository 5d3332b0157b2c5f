// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/programs/programs.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <rakelight/base/error.h>

#include "engines/opengl/programs/program_cache.h"
#include "engines/opengl/programs/shader_check.h"

namespace rakelight::opengl {
namespace {

/// Programs without a text of the user's compile: so it is at fault.
/// @param words  what the driver says, in one line
[[noreturn]] void fail(const std::string& words, const std::string& user, bool is_vertex) {
    if (user.empty())
        throw Error(ErrorCode::failed, "the OpenGL driver refuses a shader: " + words, {}, "render with engine soft");
    throw Error(ErrorCode::bad_file,
                (is_vertex ? "the vertex shader of " : "the lighting of ") + user + " does not compile: " + words, {},
                "see docs/user-shaders.md")
        .about(is_vertex ? "vertex-shader" : "lighting");
}

[[noreturn]] void fail(const CompileFault& fault, const ProgramText& text) {
    if (fault.part == CompileFault::Part::pixels)
        fail(named_fault(fault.log, text.pixels.files), text.pixels.user(), false);
    const bool is_vertex = text.has_vertex_shader;
    if (fault.part == CompileFault::Part::vertices)
        fail(named_fault(fault.log, text.vertices.files), text.vertices.user(), is_vertex);
    fail(fault.log.substr(0, fault.log.find('\n')), is_vertex ? text.vertices.user() : text.pixels.user(), is_vertex);
}

void compile(GLuint program, const ProgramText& text, std::span<const char* const> caught = {}) {
    if (const auto fault = compile_program(program, {text.vertices.text, text.pixels.text}, caught)) fail(*fault, text);
}

/// A text of the user's compiles here once it has done so elsewhere.
void check_apart(const ProgramText& text) try {
    if (text.pixels.user().empty() && text.vertices.user().empty()) return;
    if (const auto fault = checked_apart(text)) fail(*fault, text);
} catch (const Error& error) {
    if (error.code() != ErrorCode::bad_file || !error.setting().empty()) throw;
    const std::string& lighting = text.pixels.user();
    const std::string both = lighting.empty() ? text.vertices.user()
                             : text.vertices.user().empty() || text.vertices.user() == lighting
                                 ? lighting
                                 : lighting + " and " + text.vertices.user();
    throw Error(ErrorCode::bad_file, both + ": " + error.reason(), {}, "see docs/user-shaders.md")
        .about(lighting.empty() ? "vertex-shader" : "lighting");
}

/// Names of uniforms -> places; samplers -> units.
void find_places(Program& program, const Driver& driver, const Features& features) {
    const GLuint name = program.name.name();
    const auto place = [name](const char* word) { return glGetUniformLocation(name, word); };
    program.object = place("rl_object");
    program.material = place("rl_material");
    program.lights = place("rl_light_numbers");
    program.light_count = place("rl_light_count");
    program.view_direction = place("rl_view_direction");
    program.ray = place("rl_ray");
    program.fog = place("rl_fog");
    program.environment = place("rl_environment_numbers");
    program.environment_levels = place("rl_environment_levels");
    program.first_corner = place("rl_first_corner");
    program.cut = place("rl_cut");
    program.against = place("rl_against");
    program.map_texels = place("rl_map_texels");
    program.shadow_size = place("rl_shadow_size");
    program.numbers = place("rl_numbers");
    program.samples = place("rl_samples");
    program.mark = place("rl_mark");
    program.mark_color = place("rl_mark_color");
    program.mark_view = place("rl_mark_view");
    program.mark_cull = place("rl_mark_cull");
    program.behind_view = place("rl_behind_view");
    glUseProgram(name);
    const auto bind = [&place](const std::string& sampler, GLint unit) {
        const GLint at = place(sampler.c_str());
        if (at >= 0) glUniform1i(at, unit);
        return at >= 0;
    };
    bind("rl_lights", unit_lights);
    bind("rl_shadow_atlas", unit_shadows);
    bind("rl_environment", unit_environment);
    bind("rl_sky", unit_environment);
    bind("rl_albedos", unit_tables);
    bind("rl_depth", unit_shadows);
    bind("rl_indices", driver.texture_units);
    bind("rl_vertices", driver.texture_units + 1);
    program.map_unit.assign(texture_role_count, -1);
    GLint next = engine_units;
    if (bind("rl_behind", next)) program.behind_unit = next++;
    for (int role = 0; role < texture_role_count; ++role) {
        if (!features.has(TextureRoleNumber(role))) continue;
        const std::string sampler = role == role_height ? "rl_heights" : "rl_map_" + std::to_string(role);
        if (bind(sampler, next)) program.map_unit[std::size_t(role)] = next++;
    }
}

}  // namespace

GlProgram link_program(const ProgramText& text, std::span<const char* const> caught) {
    GlProgram program;
    compile(program.get(), text, caught);
    return program;
}

std::unique_ptr<Program> Programs::make_of(const ProgramText& text, const Features& features) const {
    auto program = std::make_unique<Program>();
    const GLuint name = program->name.get();
    const ProgramCache cache(driver_, text);
    if (!cache.load(name) || !is_linked(name)) {
        check_apart(text);
        cache.prepare(name);
        compile(name, text);
        cache.store(name);
    }
    find_places(*program, driver_, features);
    if (features.is_user == 0 && features.has_vertex_shader == 0) return program;
    program->time = glGetUniformLocation(name, "rl_time");
    program->term_light = glGetUniformLocation(name, "rl_term_light");
    for (const ShaderVariable& u : user_.uniforms)
        program->uniforms.push_back(glGetUniformLocation(name, u.name.c_str()));
    return program;
}

std::unique_ptr<Program> Programs::make(const Features& features) const {
    return make_of(program_text(features, driver_, user_), features);
}

std::unique_ptr<Program> Programs::make_marks(const Features& features) const {
    return make_of(mark_text(features, driver_, user_), features);
}

void Programs::begin_picture() {
    std::vector<std::pair<Table*, Table::iterator>> unused;  // by the last picture
    for (Table* const table : {&programs_, &marks_})
        for (auto at = table->begin(); at != table->end(); ++at)
            if (at->second.used != picture_) unused.emplace_back(table, at);
    ++picture_;
    const std::size_t all = programs_.size() + marks_.size();
    if (all <= most_) return;
    const std::size_t dropped = std::min(all - most_, unused.size());
    std::ranges::nth_element(unused, unused.begin() + std::ptrdiff_t(dropped), {},
                             [](const auto& program) { return program.second->second.used; });
    for (const auto& [table, at] : std::span(unused).first(dropped)) table->erase(at);
}

bool Programs::set_user(const RenderSettings& s) {
    const RenderSettings& old = settings_;
    const bool is_lighting_new = s.lighting_text != old.lighting_text || s.lighting_name != old.lighting_name;
    const bool is_vertex_new = s.vertex_text != old.vertex_text || s.vertex_name != old.vertex_name;
    const bool has_new_values = s.uniforms != old.uniforms || s.shader_time_s != old.shader_time_s;
    if (!is_lighting_new && !is_vertex_new && !has_new_values) return false;
    user_ = user_shaders_of(s);
    if (is_lighting_new || is_vertex_new)
        for (Table* const table : {&programs_, &marks_})
            std::erase_if(*table, [](const auto& of) { return of.first.is_user + of.first.has_vertex_shader != 0; });
    settings_ = s;
    return is_vertex_new || (has_new_values && user_.has_vertex());
}

void Programs::set_uniforms(const Program& program) const {
    if (program.time >= 0) glUniform1f(program.time, float(settings_.shader_time_s));
    for (std::size_t i = 0; i < program.uniforms.size(); ++i) {
        const GLint place = program.uniforms[i];
        const ShaderVariable& u = user_.uniforms[i];
        const float* const v = u.value.data();
        if (place < 0) continue;
        if (u.type == "int")
            glUniform1i(place, GLint(v[0]));
        else if (u.components() == 1)
            glUniform1fv(place, 1, v);
        else if (u.components() == 2)
            glUniform2fv(place, 1, v);
        else if (u.components() == 3)
            glUniform3fv(place, 1, v);
        else
            glUniform4fv(place, 1, v);
    }
}

}  // namespace rakelight::opengl
