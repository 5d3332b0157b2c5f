// SPDX-License-Identifier: Apache-2.0
// Counts the pixels of a picture that something opaque covers. By a program, since OpenGL ES cannot read back depth.
#pragma once
#include <cstdint>

#include "engines/opengl/picture/target.h"

namespace rakelight::opengl {

class CoveredCounter {
public:
    explicit CoveredCounter(const Driver& driver) : driver_(driver) {}
    /// Of a target that is resolved.
    std::uint64_t count(const Target& of, float far_depth);

private:
    const Driver& driver_;
    GlProgram program_;
    GlTexture texels_;
    GlFramebuffer frame_;
    GlVertexArray no_arrays_;
    int width_ = 0, height_ = 0;
};

}  // namespace rakelight::opengl
