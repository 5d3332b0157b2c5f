// SPDX-License-Identifier: Apache-2.0
// Data channels: passes of their own, one sample at the middle of each pixel, into floats and whole numbers.
#pragma once
#include <array>
#include <functional>

#include <rakelight/engines/engine.h>

#include "engines/opengl/context/driver.h"
#include "engines/opengl/context/gl_objects.h"
#include "engines/opengl/programs/features.h"

namespace rakelight::opengl {

/// What the channels of one program are drawn into.
class ChannelTarget {
public:
    /// Room for a part of a picture. @throws Error failed: no memory on the GPU
    void reserve(int width, int height);
    /// Binds what a group needs, cleared.
    void begin(Output group, float far_depth);
    /// The channels of the group, as the engine's sinks take them.
    /// @param eye  that positions are about
    void read(Output group, std::uint32_t channels, dvec3 eye, ChannelArrays& to) const;
    /// The first pixel of what Output::user_terms has drawn.
    std::array<vec4, 4> user_terms() const;

private:
    int width_ = 0, height_ = 0;
    std::array<GlTexture, 4> floats_;
    GlTexture numbers_, count_;
    GlRenderbuffer depth_;
    GlFramebuffer float_frame_, number_frame_, count_frame_;
};

/// Calls draw(group, wants_triangles) for each group that some of the channels are of.
void for_each_group(std::uint32_t channels, const std::function<void(Output group, bool wants_triangles)>& draw);

}  // namespace rakelight::opengl
