// SPDX-License-Identifier: Apache-2.0
#include "gl_context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <stdexcept>

namespace rakelight::test {

struct GlContext::State {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
    GlFlavour flavour = GlFlavour::core_33;
    struct Bound {
        std::string sampler;
        GLuint texture;
    };
    std::vector<Bound> textures;
    struct Vectors {
        std::string uniform;
        std::vector<float> numbers;
    };
    std::vector<Vectors> vectors;
    std::vector<std::pair<std::string, int>> wholes;

    ~State() {
        if (context != EGL_NO_CONTEXT) {
            eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
            eglDestroyContext(display, context);
        }
        // The display stays: with it Mesa would unload its driver, and lose memory that a leak sanitizer then finds.
        eglReleaseThread();
    }
};

namespace {

/// Of the platform without surfaces, else the default one.
EGLDisplay find_display() {
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
        EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (display != EGL_NO_DISPLAY) return display;
    }
    return eglGetDisplay(EGL_DEFAULT_DISPLAY);
}

EGLContext make_context(EGLDisplay display, GlFlavour flavour) {
    const bool is_es = flavour == GlFlavour::es_30;
    eglBindAPI(is_es ? EGL_OPENGL_ES_API : EGL_OPENGL_API);
    const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, is_es ? EGL_OPENGL_ES3_BIT : EGL_OPENGL_BIT,
                             EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    eglChooseConfig(display, wanted, &config, 1, &count);
    const EGLint core[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    const EGLint es[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE};
    return eglCreateContext(display, count > 0 ? config : nullptr, EGL_NO_CONTEXT, is_es ? es : core);
}

GLuint compile(GLenum kind, const std::string& text) {
    const GLuint shader = glCreateShader(kind);
    const char* const lines = text.c_str();
    glShaderSource(shader, 1, &lines, nullptr);
    glCompileShader(shader);
    GLint is_good = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &is_good);
    if (is_good != 0) return shader;
    char log[4000] = "";
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    glDeleteShader(shader);
    throw std::runtime_error(log);
}

GLuint link(const std::string& head, const std::string& text) {
    const GLuint corners =
        compile(GL_VERTEX_SHADER, head +
                                      "void main() {\n"
                                      "    vec2 p = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));\n"
                                      "    gl_Position = vec4(p * 4.0 - 1.0, 0.0, 1.0);\n"
                                      "}\n");
    const GLuint pixels = compile(GL_FRAGMENT_SHADER, head + "out vec4 result;\n" + text);
    const GLuint program = glCreateProgram();
    glAttachShader(program, corners);
    glAttachShader(program, pixels);
    glLinkProgram(program);
    glDeleteShader(corners);
    glDeleteShader(pixels);
    GLint is_good = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &is_good);
    if (is_good == 0) throw std::runtime_error("the program does not link");
    return program;
}

GLuint float_texture(int width, int height, const float* texels) {
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, texels);
    return texture;
}

}  // namespace

GlContext::GlContext(std::unique_ptr<State> state) : state_(std::move(state)) {}
GlContext::~GlContext() = default;

std::unique_ptr<GlContext> GlContext::make(GlFlavour flavour, std::string& why) {
    if (!epoxy_has_egl()) return why = "libEGL is missing", nullptr;  // any other call would end the process
    auto state = std::make_unique<State>();
    state->flavour = flavour;
    state->display = find_display();
    if (state->display == EGL_NO_DISPLAY || eglInitialize(state->display, nullptr, nullptr) == EGL_FALSE)
        return state->display = EGL_NO_DISPLAY, why = "EGL has no display", nullptr;
    state->context = make_context(state->display, flavour);
    if (state->context == EGL_NO_CONTEXT ||
        eglMakeCurrent(state->display, EGL_NO_SURFACE, EGL_NO_SURFACE, state->context) == EGL_FALSE)
        return why = "EGL makes no context of this version", nullptr;
    if (flavour == GlFlavour::es_30 && !epoxy_has_gl_extension("GL_EXT_color_buffer_float"))
        return why = "this ES draws no floats", nullptr;
    return std::unique_ptr<GlContext>(new GlContext(std::move(state)));
}

std::string GlContext::renderer() const { return reinterpret_cast<const char*>(glGetString(GL_RENDERER)); }

void GlContext::set_textures(const std::vector<GlTexture>& textures) {
    for (const GlTexture& t : textures)
        state_->textures.push_back({t.sampler, float_texture(t.width, t.height, t.texels.data())});
}

void GlContext::set_whole_texture(const std::string& sampler, int width, int height,
                                  const std::vector<std::uint32_t>& texels) {
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RG32UI, width, height, 0, GL_RG_INTEGER, GL_UNSIGNED_INT, texels.data());
    state_->textures.push_back({sampler, texture});
}

void GlContext::set_whole(const std::string& uniform, int number) { state_->wholes.emplace_back(uniform, number); }

void GlContext::set_vectors(const std::string& uniform, std::vector<float> numbers) {
    state_->vectors.push_back({uniform, std::move(numbers)});
}

std::vector<float> GlContext::run(const std::string& text, int width, int height) {
    const bool is_es = state_->flavour == GlFlavour::es_30;
    const std::string head = is_es ? "#version 300 es\nprecision highp float;\nprecision highp int;\n"
                                     "precision highp sampler2D;\nprecision highp usampler2D;\n"
                                   : "#version 330 core\n";
    const GLuint program = link(head, text);
    const GLuint target = float_texture(width, height, nullptr);
    GLuint frame = 0, corners = 0;
    glGenFramebuffers(1, &frame);
    glBindFramebuffer(GL_FRAMEBUFFER, frame);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target, 0);
    glGenVertexArrays(1, &corners);
    glBindVertexArray(corners);
    glUseProgram(program);
    for (std::size_t i = 0; i < state_->textures.size(); ++i) {
        glActiveTexture(GLenum(GL_TEXTURE0 + i));
        glBindTexture(GL_TEXTURE_2D, state_->textures[i].texture);
        glUniform1i(glGetUniformLocation(program, state_->textures[i].sampler.c_str()), GLint(i));
    }
    for (const auto& [name, numbers] : state_->vectors)
        glUniform3fv(glGetUniformLocation(program, name.c_str()), GLsizei(numbers.size() / 3), numbers.data());
    for (const auto& [name, number] : state_->wholes) glUniform1i(glGetUniformLocation(program, name.c_str()), number);
    glViewport(0, 0, width, height);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    std::vector<float> pixels(std::size_t(width) * std::size_t(height) * 4);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, pixels.data());
    const GLenum fault = glGetError();
    glDeleteVertexArrays(1, &corners);
    glDeleteFramebuffers(1, &frame);
    glDeleteTextures(1, &target);
    glDeleteProgram(program);
    if (fault != GL_NO_ERROR) throw std::runtime_error("GL error " + std::to_string(fault));
    return pixels;
}

}  // namespace rakelight::test
