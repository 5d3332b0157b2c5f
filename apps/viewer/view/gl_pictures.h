// SPDX-License-Identifier: Apache-2.0
// Pictures in textures: one thread draws them, the window's thread shows them (GlfwWindow::show()). All calls of OpenGL that the
// viewer makes for this are in gl_pictures.cpp.
#pragma once
#include <memory>

namespace rakelight::viewer {

/// Position and size of a picture in the window. [px] y down.
struct PixelBox {
    int x = 0, y = 0, width = 0, height = 0;
    bool holds(double px, double py) const { return px >= x && py >= y && px < x + width && py < y + height; }
};

/// A finished picture, in a corner of a texture; its lowest row comes first.
struct GlPicture {
    unsigned texture = 0;
    int width = 0, height = 0;                  ///< [px]
    int texture_width = 0, texture_height = 0;  ///< [px] at least those
    void* display_fence = nullptr;              ///< fence behind its last use by the window's thread; null: never shown
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
    GlPicture take_free(int texture_width, int texture_height);
    std::shared_ptr<Store> store_;  ///< held by pictures, too
    std::shared_ptr<GlPicture> drawn_;
    unsigned frame_ = 0;
};

/// In the window's thread, once what shows a picture is drawn: it is not drawn into again before that is done.
void mark_as_displayed(GlPicture& picture);

}  // namespace rakelight::viewer
