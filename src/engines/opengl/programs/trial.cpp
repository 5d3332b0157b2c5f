// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/programs/trial.h"

#include <algorithm>
#include <vector>

#include <rakelight/base/error.h>

#include "engines/opengl/context/headless.h"
#include "engines/opengl/programs/compile.h"

namespace rakelight::opengl {
namespace {

constexpr int side = 16;               ///< [px] of the picture
constexpr int block_bytes = 16 << 10;  ///< that every driver takes

/// The vertices of a triangle over all pixels, whatever the text makes of them: without, all would be at one place, and no
/// pixel would be lit.
std::string with_visible_triangle(std::string vertices) {
    const std::string_view main = "void main()", own = "void rl_own_main()";
    for (std::size_t at = 0; (at = vertices.find(main, at)) != std::string::npos; at += own.size())
        vertices.replace(at, main.size(), own);  // of several, #if leaves one
    return vertices +
           "\nvoid main()\n{\n    rl_own_main();\n    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, "
           "gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);\n}\n";
}

/// Numbers of all uniform blocks are 0.
void bind_blocks(GLuint program, GlBuffer& zeros) {
    const std::vector<char> bytes(block_bytes, 0);
    glBindBuffer(GL_UNIFORM_BUFFER, zeros.get());
    glBufferData(GL_UNIFORM_BUFFER, block_bytes, bytes.data(), GL_STATIC_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, zeros.name());
    GLint count = 0;
    glGetProgramiv(program, GL_ACTIVE_UNIFORM_BLOCKS, &count);
    for (GLint i = 0; i < count; ++i) glUniformBlockBinding(program, GLuint(i), 0);
}

/// Numbers of the text's own uniforms are 1: loops step and divide by them.
void set_own_uniforms(GLuint program) {
    GLint count = 0;
    glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    for (GLint i = 0; i < count; ++i) {
        char name[256];
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(program, GLuint(i), sizeof name, nullptr, &size, &type, name);
        const GLint place = glGetUniformLocation(program, name);
        if (place < 0 || std::string_view(name).starts_with("rl_")) continue;
        if (type == GL_FLOAT) glUniform1f(place, 1);
        if (type == GL_FLOAT_VEC2) glUniform2f(place, 1, 1);
        if (type == GL_FLOAT_VEC3) glUniform3f(place, 1, 1, 1);
        if (type == GL_FLOAT_VEC4) glUniform4f(place, 1, 1, 1, 1);
        if (type == GL_INT) glUniform1i(place, 1);
    }
}

void draw(GLuint program) {
    GlTexture picture;
    GlFramebuffer target;
    GlVertexArray corners;
    GlBuffer zeros;
    set_texels(picture, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, side, side);
    glBindTexture(GL_TEXTURE_2D, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, target.get());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture.name(), 0);
    glViewport(0, 0, side, side);
    glBindVertexArray(corners.get());
    glUseProgram(program);
    bind_blocks(program, zeros);
    set_own_uniforms(program);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    std::vector<unsigned char> pixels(std::size_t(side) * side * 4);
    glReadPixels(0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());  // waits for it
}

const char* word_of(CompileFault::Part part) {
    switch (part) {
        case CompileFault::Part::pixels:
            return trial_pixels;
        case CompileFault::Part::vertices:
            return trial_vertices;
        case CompileFault::Part::both:
            break;
    }
    return trial_link;
}

}  // namespace

std::string tried_program(const std::string& vertices, const std::string& pixels,
                          const std::function<void()>& is_ready) try {
    const HeadlessContext context;
    is_ready();
    GlProgram program;
    const std::string visible = with_visible_triangle(vertices);
    if (const auto fault = compile_program(program.get(), {visible, pixels}))
        return std::string(word_of(fault->part)) + "\n" + fault->log;
    draw(program.name());
    return std::string(trial_good) + "\n";
} catch (const Error& error) {
    return std::string(trial_no_context) + "\n" + error.reason();
}

}  // namespace rakelight::opengl
