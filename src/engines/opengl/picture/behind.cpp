// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/picture/behind.h"

#include <algorithm>

#include "engines/opengl/programs/programs.h"

namespace rakelight::opengl {
namespace {

/// The level above is the only one of the texture that may be read.
constexpr const char* halve_text =
    "uniform highp sampler2D rl_from;\n"
    "out vec4 o_color;\n"
    "vec4 filtered(vec4 a, vec4 b, vec4 c, vec4 d) { return ((a + d) + (b + c) * 3.0) * 0.125; }\n"
    "vec4 texel(int x, int y)\n{\n"
    "    ivec2 size = textureSize(rl_from, 0);\n"
    "    return texelFetch(rl_from, clamp(ivec2(x, y), ivec2(0), size - 1), 0);\n}\n"
    "vec4 row(int x, int y)\n{\n"
    "    if (textureSize(rl_from, 0).x == 1) {\n        return texel(0, y);\n    }\n"
    "    return filtered(texel(x - 1, y), texel(x, y), texel(x + 1, y), texel(x + 2, y));\n}\n"
    "void main()\n{\n"
    "    ivec2 at = ivec2(gl_FragCoord.xy) * 2;\n"
    "    if (textureSize(rl_from, 0).y == 1) {\n        o_color = row(at.x, 0);\n        return;\n    }\n"
    "    o_color = filtered(row(at.x, at.y - 1), row(at.x, at.y), row(at.x, at.y + 1), row(at.x, at.y + 2));\n}\n";

void set_levels(GLint first, GLint last) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, first);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, last);
}

}  // namespace

Target& BehindPicture::begin(const shading::PictureCamera& view, int samples) {
    reserve(view.width, view.height);
    target_.reserve(view.width, view.height, samples);
    return target_;
}

void BehindPicture::forget() {
    chain_.reset();
    width_ = height_ = 0;
    target_ = {};
}

void BehindPicture::reserve(int width, int height) {
    if (chain_ && width == width_ && height == height_) return;
    forget();
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, chain_.get());
    for (GLint level = 0;; ++level) {
        const int w = std::max(width >> level, 1), h = std::max(height >> level, 1);
        glTexImage2D(GL_TEXTURE_2D, level, GL_RGBA16F, w, h, 0, GL_RGBA, GL_HALF_FLOAT, nullptr);
        if (w == 1 && h == 1) break;
    }
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    check_gl("what is behind transmissive surfaces");
    width_ = width, height_ = height;
}

void BehindPicture::make_level(GLint level, int width, int height) {
    set_levels(level - 1, level - 1);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, chain_.name(), level);
    glViewport(0, 0, width, height);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void BehindPicture::finish(const Driver& driver) {
    if (!program_) program_ = link_program(screen_text(driver, halve_text));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, target_.color_frame());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, frame_.get());
    glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, chain_.name(), 0);
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, frame_.name());
    glUseProgram(program_.name());
    glUniform1i(glGetUniformLocation(program_.name(), "rl_from"), 0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, chain_.name());
    glBindSampler(0, 0);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glBindVertexArray(no_arrays_.get());
    GLint level = 0;
    for (int w = width_, h = height_; w > 1 || h > 1;) {
        w = std::max(w / 2, 1), h = std::max(h / 2, 1);
        make_level(++level, w, h);
    }
    set_levels(0, level);
    check_gl("what is behind transmissive surfaces");
}

}  // namespace rakelight::opengl
