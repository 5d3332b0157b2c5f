// SPDX-License-Identifier: Apache-2.0
#include "gl_pictures.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <bit>
#include <mutex>
#include <string>
#include <vector>

#include <rakelight/base/error.h>

namespace rakelight::viewer {
namespace {

constexpr std::size_t most_free = 3;  // textures kept for pictures to come: coarse ones, whole ones, one more
constexpr GLuint64 second_ns = 1'000'000'000, longest_picture_s = 60;  // llvmpipe may need many for a large model

/// Waits for a fence in the thread that draws; not forever, since the window waits for this thread when it is closed.
void wait_for(GLsync fence, const char* what) {
    const GLenum state = glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, longest_picture_s * second_ns);
    if (state == GL_ALREADY_SIGNALED || state == GL_CONDITION_SATISFIED) return;
    throw Error(ErrorCode::failed, std::string("OpenGL does not finish ") + what);
}

/// [px] of a texture for so many. llvmpipe compiles separate code for textures whose sides are powers of two and for
/// others, some 150 ms in the window's thread. The former exists already, since the texture of ImGui's font is one.
int texture_side(int pixels) {
    constexpr int most = 2048;  // larger ones would waste too much
    return pixels <= most ? int(std::bit_ceil(unsigned(pixels))) : (pixels + 255) / 256 * 256;
}

void give_storage(GlPicture& picture) {
    while (glGetError() != GL_NO_ERROR) {
    }
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, picture.texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, picture.texture_width, picture.texture_height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 nullptr);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
    if (glGetError() != GL_NO_ERROR)
        throw Error(ErrorCode::failed, "OpenGL has no memory for a picture of " + std::to_string(picture.width) +
                                           " x " + std::to_string(picture.height) + " pixels");
}

}  // namespace

struct GlPicturePool::Store {
    std::mutex mutex;
    std::vector<GlPicture> free;     ///< the one let go last comes last
    std::vector<unsigned> textures;  ///< all; of the thread that draws
};

GlPicturePool::GlPicturePool() : store_(std::make_shared<Store>()) { glGenFramebuffers(1, &frame_); }

GlPicturePool::~GlPicturePool() {
    drawn_.reset();
    glDeleteFramebuffers(1, &frame_);
    glDeleteTextures(GLsizei(store_->textures.size()), store_->textures.data());
    const std::scoped_lock lock(store_->mutex);
    for (const GlPicture& picture : store_->free) glDeleteSync(static_cast<GLsync>(picture.display_fence));
}

/// An unused one, of this size if possible; else a new one.
GlPicture GlPicturePool::take_free(int texture_width, int texture_height) {
    const std::scoped_lock lock(store_->mutex);
    auto& free = store_->free;
    auto at = std::ranges::find_if(free, [=](const GlPicture& p) {
        return p.texture_width == texture_width && p.texture_height == texture_height;
    });
    if (at == free.end()) {
        if (free.size() < most_free) return {};
        at = free.begin();
    }
    const GlPicture taken = *at;
    free.erase(at);
    return taken;
}

void GlPicturePool::begin(int width, int height) {
    drawn_.reset();
    const int texture_width = texture_side(width), texture_height = texture_side(height);
    const auto give_back = [store = store_](GlPicture* picture) {
        const std::unique_ptr<GlPicture> owned(picture);
        const std::scoped_lock lock(store->mutex);
        store->free.push_back(*owned);
    };
    drawn_ = std::shared_ptr<GlPicture>(new GlPicture(take_free(texture_width, texture_height)), give_back);
    GlPicture& picture = *drawn_;
    if (picture.display_fence) {  // the window's thread may still be reading it
        wait_for(static_cast<GLsync>(picture.display_fence), "showing a picture");
        glDeleteSync(static_cast<GLsync>(picture.display_fence));
        picture.display_fence = nullptr;
    }
    if (picture.texture == 0) {
        glGenTextures(1, &picture.texture);
        store_->textures.push_back(picture.texture);
    }
    picture.width = width, picture.height = height;
    if (picture.texture_width != texture_width || picture.texture_height != texture_height) {
        picture.texture_width = texture_width, picture.texture_height = texture_height;
        give_storage(picture);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, frame_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture.texture, 0);
    glViewport(0, 0, width, height);
}

std::shared_ptr<GlPicture> GlPicturePool::finish() {
    const GLsync fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (!fence) throw Error(ErrorCode::failed, "OpenGL makes no fence behind a picture");
    try {
        wait_for(fence, "drawing a picture");
    } catch (...) {
        glDeleteSync(fence);
        throw;
    }
    glDeleteSync(fence);
    return std::move(drawn_);
}

void mark_as_displayed(GlPicture& picture) {
    glDeleteSync(static_cast<GLsync>(picture.display_fence));  // null is ignored
    picture.display_fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

}  // namespace rakelight::viewer
