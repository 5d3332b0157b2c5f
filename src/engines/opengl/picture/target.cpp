// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/picture/target.h"

#include <algorithm>
#include <cmath>

#include <rakelight/base/error.h>

namespace rakelight::opengl {
namespace {

void storage(GlRenderbuffer& buffer, GLenum format, int width, int height, int samples) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffer.get());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
}

}  // namespace

void Target::reserve(int width, int height, int samples) {
    if (width == width_ && height == height_ && samples == samples_) return;
    *this = {};
    glActiveTexture(GL_TEXTURE0);
    set_texels(color_, GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, width, height);
    set_texels(depth_, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, width, height);
    for (GlFramebuffer* const frame : {&color_frame_, &frame_}) {
        glBindFramebuffer(GL_FRAMEBUFFER, frame->get());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_.name(), 0);
    }
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.name(), 0);
    if (samples > 1) {
        storage(sampled_color_, GL_RGBA16F, width, height, samples);
        storage(sampled_depth_, GL_DEPTH_COMPONENT32F, width, height, samples);
        glBindFramebuffer(GL_FRAMEBUFFER, sampled_frame_.get());
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, sampled_color_.name());
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, sampled_depth_.name());
    }
    check_gl("the picture");
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Error(ErrorCode::failed, "this OpenGL driver cannot draw half floats", {}, "render with engine soft");
    width_ = width, height_ = height, samples_ = samples;
}

void Target::begin(vec4 background, float far_depth) const {
    const GLfloat clear[4] = {background.x * background.w, background.y * background.w, background.z * background.w,
                              background.w};
    glBindFramebuffer(GL_FRAMEBUFFER, frame());
    glViewport(0, 0, width_, height_);
    glClearBufferfv(GL_COLOR, 0, clear);
    glDepthMask(GL_TRUE);
    glClearBufferfv(GL_DEPTH, 0, &far_depth);
}

void Target::resolve() const {
    if (samples_ <= 1) return;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, sampled_frame_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, frame_.name());
    for (const GLbitfield what : {GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT})
        glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, what, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, frame_.name());
}

void Target::read(std::span<vec4> to) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frame_.name());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, to.data());
    check_gl("the picture");
}

std::uint64_t to_straight_alpha(std::span<vec4> colors, vec4 background) {
    std::uint64_t not_numbers = 0;
    for (vec4& c : colors) {
        if (!(std::max({c.x, c.y, c.z}) <= most_half) || !(c.x + c.y + c.z + c.w <= 4 * most_half)) {
            not_numbers += std::isnan(c.x) || std::isnan(c.y) || std::isnan(c.z) || std::isnan(c.w);
            for (std::size_t i = 0; i < 4; ++i) c[i] = std::isnan(c[i]) ? 0 : std::min(c[i], most_half);
        }
        if (c.w == 1) continue;
        c = c.w > 0 ? vec4{c.x / c.w, c.y / c.w, c.z / c.w, c.w} : vec4{background.x, background.y, background.z, 0};
    }
    return not_numbers;
}

}  // namespace rakelight::opengl
