// SPDX-License-Identifier: Apache-2.0
// The target that a picture is drawn into: half floats, premultiplied, with depth; multisampled if requested. Upside
// down: row 0 of the picture is row 0 of OpenGL's memory, so sample positions match the soft engine's.
#pragma once
#include <cstdint>
#include <span>

#include <rakelight/math/vector.h>

#include "engines/opengl/context/driver.h"
#include "engines/opengl/context/gl_objects.h"

namespace rakelight::opengl {

class Target {
public:
    /// Room for a picture; what was there is lost. @throws Error failed: no memory on the GPU
    void reserve(int width, int height, int samples);
    /// Binds it, cleared. @param background  straight alpha
    void begin(vec4 background, float far_depth) const;
    /// Means of the samples into what texture() and read() give, one of their depths into depth_texture().
    void resolve() const;
    /// [width * height] premultiplied, row by row from the top
    void read(std::span<vec4> to) const;
    GLuint texture() const { return color_.name(); }
    GLuint depth_texture() const { return depth_.name(); }
    GLuint color_frame() const { return color_frame_.name(); }  ///< without depth: programs may read it
    GLuint frame() const { return samples_ > 1 ? sampled_frame_.name() : frame_.name(); }
    int width() const { return width_; }
    int height() const { return height_; }

private:
    int width_ = 0, height_ = 0, samples_ = 0;
    GlTexture color_, depth_;
    GlRenderbuffer sampled_depth_, sampled_color_;
    GlFramebuffer frame_, color_frame_, sampled_frame_;
};

/// Of colors as Target::read() gives them: straight alpha; where nothing is, the background's own color. What is beyond half
/// floats comes as the greatest of them, NaN as 0. @return pixels with a NaN
std::uint64_t to_straight_alpha(std::span<vec4> colors, vec4 background);

}  // namespace rakelight::opengl
