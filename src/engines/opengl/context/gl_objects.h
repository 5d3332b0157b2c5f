// SPDX-License-Identifier: Apache-2.0
// Names of OpenGL with an owner. All of it on the thread of the context, which must be current, ends included.
#pragma once
#include <epoxy/gl.h>

#include <utility>

namespace rakelight::opengl {

inline constexpr float most_half = 65504;  ///< the largest half float

/// A name that is made by Make and given back by Drop.
template <auto make, auto drop>
class GlName {
public:
    GlName() = default;
    GlName(GlName&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlName& operator=(GlName&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    ~GlName() {
        if (name_ != 0) drop(name_);
    }
    /// Made where it is not there yet.
    GLuint get() {
        if (name_ == 0) name_ = make();
        return name_;
    }
    GLuint name() const { return name_; }
    explicit operator bool() const { return name_ != 0; }
    void reset() { *this = GlName(); }

private:
    GLuint name_ = 0;
};

namespace detail {
inline GLuint make_buffer() {
    GLuint name = 0;
    glGenBuffers(1, &name);
    return name;
}
inline void drop_buffer(GLuint name) { glDeleteBuffers(1, &name); }
inline GLuint make_texture() {
    GLuint name = 0;
    glGenTextures(1, &name);
    return name;
}
inline void drop_texture(GLuint name) { glDeleteTextures(1, &name); }
inline GLuint make_vertex_array() {
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    return name;
}
inline void drop_vertex_array(GLuint name) { glDeleteVertexArrays(1, &name); }
inline GLuint make_framebuffer() {
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    return name;
}
inline void drop_framebuffer(GLuint name) { glDeleteFramebuffers(1, &name); }
inline GLuint make_renderbuffer() {
    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    return name;
}
inline void drop_renderbuffer(GLuint name) { glDeleteRenderbuffers(1, &name); }
inline GLuint make_sampler() {
    GLuint name = 0;
    glGenSamplers(1, &name);
    return name;
}
inline void drop_sampler(GLuint name) { glDeleteSamplers(1, &name); }
inline GLuint make_query() {
    GLuint name = 0;
    glGenQueries(1, &name);
    return name;
}
inline void drop_query(GLuint name) { glDeleteQueries(1, &name); }
inline GLuint make_program() { return glCreateProgram(); }
inline void drop_program(GLuint name) { glDeleteProgram(name); }
}  // namespace detail

using GlBuffer = GlName<detail::make_buffer, detail::drop_buffer>;
using GlTexture = GlName<detail::make_texture, detail::drop_texture>;
using GlVertexArray = GlName<detail::make_vertex_array, detail::drop_vertex_array>;
using GlFramebuffer = GlName<detail::make_framebuffer, detail::drop_framebuffer>;
using GlRenderbuffer = GlName<detail::make_renderbuffer, detail::drop_renderbuffer>;
using GlSampler = GlName<detail::make_sampler, detail::drop_sampler>;
using GlQuery = GlName<detail::make_query, detail::drop_query>;
using GlProgram = GlName<detail::make_program, detail::drop_program>;

/// A picture of one level, not filtered: what programs fetch from or draw into. Stays bound to the unit that is active.
inline void set_texels(GlTexture& texture, GLint format, GLenum layout, GLenum type, int width, int height,
                       const void* texels = nullptr) {
    glBindTexture(GL_TEXTURE_2D, texture.get());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, layout, type, texels);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

}  // namespace rakelight::opengl
