// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/picture/channels.h"

#include <array>
#include <limits>
#include <vector>

#include "engines/channel_arrays.h"

namespace rakelight::opengl {
namespace {

/// The channels of a group, and those for which the number of the triangle or its corners must be known.
struct Group {
    Output output;
    std::uint32_t channels, of_triangles;
};
constexpr std::array groups{
    Group{Output::numbers, channel_object | channel_material | channel_mesh | channel_triangle, channel_triangle},
    Group{Output::places, channel_depth | channel_position | channel_uv | channel_uv1 | channel_base_color, 0},
    Group{Output::directions, channel_normal | channel_face_normal | channel_tangent | channel_barycentric,
          channel_face_normal | channel_barycentric},
    Group{Output::terms, channels_lighting, 0}, Group{Output::count, channel_overdraw, 0}};

void make_texture(GlTexture& texture, GLint format, GLenum layout, GLenum type, int width, int height,
                  GLenum attachment) {
    glActiveTexture(GL_TEXTURE0);
    set_texels(texture, format, layout, type, width, height);
    glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture.name(), 0);
}

constexpr std::uint32_t nothing = std::numeric_limits<std::uint32_t>::max();

}  // namespace

void for_each_group(std::uint32_t channels, const std::function<void(Output, bool)>& draw) {
    for (const Group& group : groups)
        if (channels & group.channels) draw(group.output, (channels & group.of_triangles) != 0);
}

void ChannelTarget::reserve(int width, int height) {
    if (width == width_ && height == height_) return;
    *this = {};
    glBindRenderbuffer(GL_RENDERBUFFER, depth_.get());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, width, height);
    const auto bind = [this](GlFramebuffer& frame) {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.get());
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
    };
    bind(float_frame_);
    constexpr GLenum all[4] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2, GL_COLOR_ATTACHMENT3};
    for (std::size_t i = 0; i < 4; ++i) make_texture(floats_[i], GL_RGBA32F, GL_RGBA, GL_FLOAT, width, height, all[i]);
    glDrawBuffers(4, all);
    bind(number_frame_);
    make_texture(numbers_, GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT, width, height, GL_COLOR_ATTACHMENT0);
    bind(count_frame_);
    make_texture(count_, GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, width, height, GL_COLOR_ATTACHMENT0);
    check_gl("data channels");
    width_ = width, height_ = height;
}

void ChannelTarget::begin(Output group, float far_depth) {
    constexpr GLuint none[4] = {nothing, nothing, nothing, nothing};
    constexpr GLfloat zero[4] = {0, 0, 0, 0};
    const bool is_number = group == Output::numbers, is_count = group == Output::count;
    glBindFramebuffer(GL_FRAMEBUFFER, is_number  ? number_frame_.name()
                                      : is_count ? count_frame_.name()
                                                 : float_frame_.name());
    glViewport(0, 0, width_, height_);
    glDepthMask(GL_TRUE);
    glClearBufferfv(GL_DEPTH, 0, &far_depth);
    if (is_number) return glClearBufferuiv(GL_COLOR, 0, none);
    for (GLint i = 0; i < (is_count ? 1 : 4); ++i) glClearBufferfv(GL_COLOR, i, zero);
}

void ChannelTarget::read(Output group, std::uint32_t channels, dvec3 eye, ChannelArrays& to) const {
    const std::size_t pixels = std::size_t(width_) * std::size_t(height_);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    if (group == Output::numbers) {
        std::vector<std::array<std::uint32_t, 4>> read(pixels);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, number_frame_.name());
        glReadPixels(0, 0, width_, height_, GL_RGBA_INTEGER, GL_UNSIGNED_INT, read.data());
        const auto take = [&](std::uint32_t bit, std::size_t component, std::vector<std::uint32_t>& array) {
            for (std::size_t i = 0; i < pixels && (channels & bit); ++i) array[i] = read[i][component];
        };
        take(channel_object, 0, to.object), take(channel_material, 1, to.material);
        take(channel_mesh, 2, to.mesh), take(channel_triangle, 3, to.triangle);
        return check_gl("data channels");
    }
    std::vector<vec4> read(pixels);
    if (group == Output::count) {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, count_frame_.name());
        glReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, read.data());
        for (std::size_t i = 0; i < pixels; ++i) to.overdraw[i] = std::uint32_t(read[i].x + 0.5f);
        return check_gl("data channels");
    }
    glBindFramebuffer(GL_READ_FRAMEBUFFER, float_frame_.name());
    const auto fetch = [&](GLenum attachment) {
        glReadBuffer(attachment);
        glReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, read.data());
    };
    const auto take3 = [&](GLenum attachment, std::uint32_t bit, std::vector<vec3>& array) {
        if ((channels & bit) == 0) return;
        fetch(attachment);
        for (std::size_t i = 0; i < pixels; ++i) array[i] = read[i].xyz();
    };
    if (group == Output::places) {
        if (channels & (channel_depth | channel_position)) fetch(GL_COLOR_ATTACHMENT0);
        for (std::size_t i = 0; i < pixels && (channels & channel_depth); ++i)
            to.depth[i] = read[i].w > 0 ? read[i].w : std::numeric_limits<float>::infinity();
        for (std::size_t i = 0; i < pixels && (channels & channel_position); ++i)
            if (read[i].w > 0)
                to.position[i] = {float(eye.x + double(read[i].x)), float(eye.y + double(read[i].y)),
                                  float(eye.z + double(read[i].z))};
        if (channels & (channel_uv | channel_uv1)) fetch(GL_COLOR_ATTACHMENT1);
        for (std::size_t i = 0; i < pixels && (channels & channel_uv); ++i) to.uv[i] = {read[i].x, read[i].y};
        for (std::size_t i = 0; i < pixels && (channels & channel_uv1); ++i) to.uv1[i] = {read[i].z, read[i].w};
        take3(GL_COLOR_ATTACHMENT2, channel_base_color, to.base_color);
    } else if (group == Output::directions) {
        take3(GL_COLOR_ATTACHMENT0, channel_normal, to.normal);
        take3(GL_COLOR_ATTACHMENT1, channel_face_normal, to.face_normal);
        if (channels & channel_tangent) fetch(GL_COLOR_ATTACHMENT2), to.tangent = read;
        take3(GL_COLOR_ATTACHMENT3, channel_barycentric, to.barycentric);
    } else {
        take3(GL_COLOR_ATTACHMENT0, channel_ambient, to.ambient);
        take3(GL_COLOR_ATTACHMENT1, channel_diffuse, to.diffuse);
        take3(GL_COLOR_ATTACHMENT2, channel_specular, to.specular);
        take3(GL_COLOR_ATTACHMENT3, channel_emission, to.emission);
    }
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    check_gl("data channels");
}

std::array<vec4, 4> ChannelTarget::user_terms() const {
    std::array<vec4, 4> terms;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, float_frame_.name());
    for (std::size_t i = 0; i < terms.size(); ++i) {
        glReadBuffer(GLenum(GL_COLOR_ATTACHMENT0 + i));
        glReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, &terms[i]);
    }
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    check_gl("terms of a lighting text");
    return terms;
}

}  // namespace rakelight::opengl
