// SPDX-License-Identifier: Apache-2.0
// An OpenGL 3.3 context without a window, by EGL, and a picture to draw into.
#pragma once
#include <string>

#include <rakelight/image/image.h>

namespace rakelight::bench {

/// Mesa's software rasterizer unless LIBGL_ALWAYS_SOFTWARE says otherwise. One a thread.
class GlContext {
public:
    GlContext();  ///< and makes it current. @throws Error failed: no EGL, no OpenGL 3.3
    void make_current() const;
    ~GlContext();
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;
    std::string renderer() const, version() const;
    static void finish();  ///< returns when all that was requested is drawn

private:
    void* display_ = nullptr;
    void* context_ = nullptr;
};

/// sRGB color and 24 bits of depth, `samples` a pixel; those are averaged by resolve(). OpenGL counts rows, and the
/// sample positions in a framebuffer object, from the bottom. To match the soft engine, pictures are drawn upside
/// down: row 0 is the picture's top.
class GlTarget {
public:
    GlTarget(int width, int height, int samples);
    void begin() const;    ///< binds, clears
    void resolve() const;  ///< nothing for one sample
    Pixels read() const;   ///< RGB codes

private:
    unsigned make(int samples, bool with_depth) const;
    int width_, height_, samples_;
    unsigned drawn_, resolved_;  ///< frame buffer objects; the same for one sample
};

}  // namespace rakelight::bench
