// SPDX-License-Identifier: Apache-2.0
// Pictures in textures: one thread draws them, the window's thread shows them. All calls of OpenGL that the viewer makes for this
// are in gl_pictures.cpp.
#pragma once
#include <memory>

namespace rakelight::viewer {

/// A finished picture; its lowest row comes first.
struct GlPicture {
    unsigned texture = 0;
    int width = 0, height = 0;  ///< [px]
    void* shown = nullptr;      ///< fence behind its last use by the window's thread; null: never shown
};

/// Textures to draw pictures into. In one thread, whose context is current.
class GlPicturePool {
public:
    GlPicturePool();
    ~GlPicturePool();
    GlPicturePool(const GlPicturePool&) = delete;
    GlPicturePool& operator=(const GlPicturePool&) = delete;

    /// Binds a texture that nobody holds as the framebuffer, with its viewport. @throws Error failed: no memory on the GPU
    void begin(int width, int height);
    /// Waits until it is drawn. It may be let go in any thread; then its texture is drawn into again.
    /// @throws Error failed
    std::shared_ptr<GlPicture> finish();

private:
    struct Store;
    std::shared_ptr<Store> store_;  ///< held by pictures, too
    std::shared_ptr<GlPicture> drawn_;
    unsigned frame_ = 0;
};

/// [px] y down.
struct GlBox {
    int x = 0, y = 0, width = 0, height = 0;
};

/// The window, in its thread.
class GlScreen {
public:
    /// @param to  where the whole picture would lie  @param clip  what of that is drawn  @param window_height  [px]
    void show(GlPicture& picture, const GlBox& to, const GlBox& clip, int window_height);
    /// @param color  sRGB, R in the low byte
    void fill(const GlBox& box, unsigned color, int window_height);

private:
    unsigned frame_ = 0;  ///< ends with its context
};

}  // namespace rakelight::viewer
