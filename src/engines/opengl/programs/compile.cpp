// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/programs/compile.h"

namespace rakelight::opengl {
namespace {

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

}  // namespace

bool is_linked(GLuint program) {
    GLint good = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &good);
    return good != 0;
}

std::optional<CompileFault> compile_program(GLuint program, const StageTexts& texts,
                                            std::span<const char* const> caught) {
    // Pixels first: the vertices may have the lighting's text, too.
    const Shader pixels(GL_FRAGMENT_SHADER, texts.pixels), vertices(GL_VERTEX_SHADER, texts.vertices);
    if (!pixels.is_good()) return CompileFault{CompileFault::Part::pixels, pixels.log()};
    if (!vertices.is_good()) return CompileFault{CompileFault::Part::vertices, vertices.log()};
    glAttachShader(program, vertices.name());
    glAttachShader(program, pixels.name());
    if (!caught.empty())
        glTransformFeedbackVaryings(program, GLsizei(caught.size()), caught.data(), GL_SEPARATE_ATTRIBS);
    glLinkProgram(program);
    glDetachShader(program, vertices.name());
    glDetachShader(program, pixels.name());
    if (is_linked(program)) return {};
    std::string words(4096, '\0');
    GLsizei length = 0;
    glGetProgramInfoLog(program, GLsizei(words.size()), &length, words.data());
    return CompileFault{CompileFault::Part::both, words.substr(0, std::size_t(length))};
}

}  // namespace rakelight::opengl
