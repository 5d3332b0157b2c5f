// SPDX-License-Identifier: Apache-2.0
#include "gl_pictures.h"

#include <epoxy/gl.h>

#include <mutex>
#include <vector>

#include <rakelight/error.h>

namespace rakelight::viewer {
namespace {

constexpr std::size_t most_free = 3;  // textures kept for pictures to come: coarse ones, whole ones, one more
constexpr GLuint64 second_ns = 1'000'000'000;

/// Waits for a fence in the thread that draws.
void wait_for(GLsync fence, const char* what) {
    for (;;) {
        const GLenum state = glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, second_ns / 10);
        if (state == GL_ALREADY_SIGNALED || state == GL_CONDITION_SATISFIED) return;
        if (state == GL_WAIT_FAILED) throw Error(ErrorCode::failed, std::string("OpenGL does not finish ") + what);
    }
}

void give_storage(GlPicture& picture, int width, int height) {
    while (glGetError() != GL_NO_ERROR) {
    }
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, picture.texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    picture.width = width, picture.height = height;
    if (glGetError() != GL_NO_ERROR)
        throw Error(ErrorCode::failed, "OpenGL has no memory for a picture of " + std::to_string(width) + " x " +
                                           std::to_string(height) + " pixels");
}

void set_scissor(const GlBox& box, int window_height) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(box.x, window_height - box.y - box.height, box.width, box.height);
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
    for (const GlPicture& picture : store_->free) glDeleteSync(static_cast<GLsync>(picture.shown));
}

void GlPicturePool::begin(int width, int height) {
    drawn_.reset();
    GlPicture taken;
    {
        const std::scoped_lock lock(store_->mutex);
        auto& free = store_->free;
        std::size_t at = 0;
        while (at < free.size() && (free[at].width != width || free[at].height != height)) ++at;
        if (at == free.size()) at = 0;  // of another size: the one let go first
        const bool is_fitting = !free.empty() && free[at].width == width && free[at].height == height;
        if (is_fitting || free.size() >= most_free) {
            taken = free[at];
            free.erase(free.begin() + std::ptrdiff_t(at));
        }
    }
    if (taken.texture == 0) {
        glGenTextures(1, &taken.texture);
        store_->textures.push_back(taken.texture);
    }
    const auto give_back = [store = store_](GlPicture* picture) {
        const std::unique_ptr<GlPicture> owned(picture);
        const std::scoped_lock lock(store->mutex);
        store->free.push_back(*owned);
    };
    drawn_ = std::shared_ptr<GlPicture>(new GlPicture(taken), give_back);
    if (taken.shown) {  // the window's thread may still be reading it
        wait_for(static_cast<GLsync>(taken.shown), "showing a picture");
        glDeleteSync(static_cast<GLsync>(taken.shown));
        drawn_->shown = nullptr;
    }
    if (taken.width != width || taken.height != height) give_storage(*drawn_, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, frame_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, drawn_->texture, 0);
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

void GlScreen::show(GlPicture& picture, const GlBox& to, const GlBox& clip, int window_height) {
    if (frame_ == 0) glGenFramebuffers(1, &frame_);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frame_);
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture.texture, 0);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glDisable(GL_FRAMEBUFFER_SRGB);
    set_scissor(clip, window_height);
    const int bottom = window_height - to.y - to.height;
    const bool is_same_size = picture.width == to.width && picture.height == to.height;
    glBlitFramebuffer(0, 0, picture.width, picture.height, to.x, bottom, to.x + to.width, bottom + to.height,
                      GL_COLOR_BUFFER_BIT, is_same_size ? GL_NEAREST : GL_LINEAR);
    glDisable(GL_SCISSOR_TEST);
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 0, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteSync(static_cast<GLsync>(picture.shown));  // null is ignored
    picture.shown = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

void GlScreen::fill(const GlBox& box, unsigned color, int window_height) {
    set_scissor(box, window_height);
    const auto part = [color](int byte) { return float(color >> 8 * byte & 255) / 255; };
    glClearColor(part(0), part(1), part(2), 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
}

}  // namespace rakelight::viewer
