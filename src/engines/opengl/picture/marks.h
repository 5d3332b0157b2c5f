// SPDX-License-Identifier: Apache-2.0
// Lines and points of a picture, laid over its surfaces: edges and vertices where settings ask for them, and those that the
// scene holds.
#pragma once
#include <span>

#include "engines/opengl/context/pass_meter.h"
#include "engines/opengl/picture/picture.h"
#include "engines/opengl/picture/target.h"

namespace rakelight::opengl {

class Marks {
public:
    /// Those of one draw.
    struct Planned {
        const shading::Draw* draw;
        PictureDrawer::Mark mark;
    };
    static constexpr const char* pass_name = "lines and points";

    /// Whether a picture has any.
    static bool are_in(const shading::DrawList& list, const RenderSettings& settings);
    /// Over the colors of a target that is resolved, hidden by its depth.
    void draw(const PictureDrawer& drawer, const PictureState& state, const Target& to, PassMeter& meter);
    /// The same into the channels of a group whose frame is bound. @param from  the colors' target, which has the depth
    void draw_channels(const PictureDrawer& drawer, const PictureState& state, Output group, const Target& from,
                       float far_depth) const;

private:
    void reserve(const Target& to);
    void draw_depth(const PictureDrawer& drawer, std::span<const Planned> marks, const Target& to);
    void draw_run(const PictureDrawer& drawer, std::span<const Planned> run, const Target& to, PassMeter& meter);
    void lay(const Target& to, const Driver& driver, PassMeter& meter);

    GlTexture layer_;       ///< marks of one color: the greatest coverage counts, so that corners are not darker
    GlRenderbuffer depth_;  ///< of opaque marks, where they are of several colors
    GlFramebuffer layer_frame_, over_frame_;  ///< the layer, the picture; both with that depth
    int width_ = 0, height_ = 0;
    GlProgram lay_;
    GlVertexArray no_arrays_;
};

}  // namespace rakelight::opengl
