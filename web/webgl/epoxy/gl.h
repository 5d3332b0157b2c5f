// SPDX-License-Identifier: Apache-2.0
// WebGL 2, by emscripten's OpenGL ES 3.0, under libepoxy's name: the engine gl includes this header in both builds. Constants of
// desktop OpenGL are there for code that asks Driver::is_es first.
#pragma once
#include <GLES3/gl3.h>

#include <string_view>

#define GL_COLOR_LOGIC_OP 0x0BF2
#define GL_CONTEXT_LOST 0x0507
#define GL_FILL 0x1B02
#define GL_FRAMEBUFFER_SRGB 0x8DB9
#define GL_LOWER_LEFT 0x8CA1
#define GL_NEGATIVE_ONE_TO_ONE 0x935E
#define GL_SAMPLES_PASSED 0x8914
#define GL_SAMPLE_POSITION 0x8E50
#define GL_TIME_ELAPSED 0x88BF
#define GL_ZERO_TO_ONE 0x935F

extern "C" void glClipControlEXT(GLenum origin, GLenum depth);
inline void glClipControl(GLenum origin, GLenum depth) { glClipControlEXT(origin, depth); }
inline void glPolygonMode(GLenum, GLenum) {}
inline void glGetQueryObjectui64v(GLuint, GLenum, GLuint64* value) { *value = 0; }
/// Browsers do not tell where samples lie: at the center of the pixel, as far as is known.
inline void glGetMultisamplefv(GLenum, GLuint, GLfloat* place) { place[0] = place[1] = 0.5f; }

inline bool epoxy_is_desktop_gl() { return false; }
inline int epoxy_gl_version() { return 30; }
inline bool epoxy_has_gl_extension(const char* name) {
    GLint count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i) {
        const GLubyte* const words = glGetStringi(GL_EXTENSIONS, GLuint(i));
        if (words && std::string_view(reinterpret_cast<const char*>(words)) == name) return true;
    }
    return false;
}

/// Browsers give the name of the GPU under another constant, once WEBGL_debug_renderer_info was asked for, if at all.
inline const GLubyte* rl_webgl_string(GLenum name) {
    constexpr GLenum unmasked_renderer = 0x9246;
    const bool is_told = name == GL_RENDERER && epoxy_has_gl_extension("GL_WEBGL_debug_renderer_info");
    return glGetString(is_told ? unmasked_renderer : name);
}
#define glGetString rl_webgl_string
