// SPDX-License-Identifier: Apache-2.0
// The picture of what is behind transmissive surfaces (shading/behind.h) on the GPU: drawn into a target, then made a mip chain.
#pragma once
#include "engines/opengl/picture/target.h"
#include "shading/picture_camera.h"

namespace rakelight::opengl {

class BehindPicture {
public:
    /// To be drawn into and resolved. @throws Error failed: no memory on the GPU
    Target& begin(const shading::PictureCamera& view, int samples);
    /// The chain of what was drawn: each smaller level by the filter 1 3 3 1, as cpu_shading/behind_picture.h makes it.
    void finish(const Driver& driver);
    void forget();
    GLuint texture() const { return chain_.name(); }  ///< 0: there is none

private:
    void reserve(int width, int height);
    void make_level(GLint level, int width, int height);

    Target target_;
    GlTexture chain_;
    GlFramebuffer frame_;
    GlProgram program_;
    GlVertexArray no_arrays_;
    int width_ = 0, height_ = 0;
};

}  // namespace rakelight::opengl
