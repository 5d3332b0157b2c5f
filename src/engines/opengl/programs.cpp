// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/programs.h"

#include <string>

#include <rakelight/error.h>

#include "engines/opengl/program_cache.h"

namespace rakelight::opengl {
namespace {

/// @param log  what the driver says, with files' names. Programs without a text of the user's compile: so it is at fault.
[[noreturn]] void fail(const std::string& log, const UserLighting& user) {
    const std::string words = log.substr(0, log.find('\n'));
    if (!user.text.empty())
        throw Error(ErrorCode::bad_file, "the lighting of " + user.name + " does not compile: " + words, {},
                    "see docs/opengl.md")
            .about("lighting");
    throw Error(ErrorCode::failed, "the OpenGL driver refuses a shader: " + words, {}, "render with engine soft");
}

class Shader {
public:
    Shader(GLenum stage, const std::string& lines) : name_(glCreateShader(stage)) {
        const char* const source = lines.c_str();
        glShaderSource(name_, 1, &source, nullptr);
        glCompileShader(name_);
    }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;
    ~Shader() { glDeleteShader(name_); }
    GLuint name() const { return name_; }
    bool is_good() const {
        GLint good = 0;
        glGetShaderiv(name_, GL_COMPILE_STATUS, &good);
        return good != 0;
    }
    std::string log() const {
        std::string words(4096, '\0');
        GLsizei length = 0;
        glGetShaderInfoLog(name_, GLsizei(words.size()), &length, words.data());
        return words.substr(0, std::size_t(length));
    }

private:
    GLuint name_;
};

bool is_linked(GLuint program) {
    GLint good = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &good);
    return good != 0;
}

void compile(GLuint program, const ProgramText& text, const UserLighting& user,
             std::span<const char* const> caught = {}) {
    const Shader vertices(GL_VERTEX_SHADER, text.vertices), pixels(GL_FRAGMENT_SHADER, text.pixels);
    for (const Shader* const shader : {&vertices, &pixels})
        if (!shader->is_good()) fail(with_file_names(shader->log(), text.files), user);
    glAttachShader(program, vertices.name());
    glAttachShader(program, pixels.name());
    if (!caught.empty())
        glTransformFeedbackVaryings(program, GLsizei(caught.size()), caught.data(), GL_SEPARATE_ATTRIBS);
    glLinkProgram(program);
    glDetachShader(program, vertices.name());
    glDetachShader(program, pixels.name());
    if (is_linked(program)) return;
    std::string words(4096, '\0');
    GLsizei length = 0;
    glGetProgramInfoLog(program, GLsizei(words.size()), &length, words.data());
    fail(words.substr(0, std::size_t(length)), user);
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

GlProgram link_program(const ProgramText& text, const UserLighting& user, std::span<const char* const> caught) {
    GlProgram program;
    compile(program.get(), text, user, caught);
    return program;
}

std::unique_ptr<Program> Programs::make_of(const ProgramText& text, const Features& features,
                                           const UserLighting& user) const {
    auto program = std::make_unique<Program>();
    const GLuint name = program->name.get();
    const ProgramCache cache(driver_, text);
    if (!cache.load(name) || !is_linked(name)) {
        cache.prepare(name);
        compile(name, text, user);
        cache.store(name);
    }
    find_places(*program, driver_, features);
    return program;
}

std::unique_ptr<Program> Programs::make(const Features& features) const {
    const UserLighting user = features.is_user ? user_ : UserLighting{};
    return make_of(program_text(features, driver_, user), features, user);
}

std::unique_ptr<Program> Programs::make_marks(const Features& features) const {
    return make_of(mark_text(features, driver_), features, {});
}

void Programs::set_user(UserLighting user) {
    if (user.text == user_.text && user.name == user_.name) return;
    user_ = std::move(user);
    std::erase_if(programs_, [](const auto& entry) { return entry.first.is_user != 0; });
}

}  // namespace rakelight::opengl
