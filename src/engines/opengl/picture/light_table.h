// SPDX-License-Identifier: Apache-2.0
// The lights of a picture as programs read them (glsl/frame_uniforms.glsl): texels of a table, and of many lights that end
// lists of those that may reach each square of pixels.
#pragma once
#include <optional>
#include <vector>

#include <rakelight/math/vector.h>

#include "engines/opengl/context/gl_objects.h"
#include "lighting/light_parameters.h"
#include "shading/lights/shadow_factors.h"
#include "shading/picture_camera.h"

namespace rakelight::opengl {

/// A light's shadow map as a program reads it.
struct LightShadow {
    shading::ShadowFactors factors{};
    std::int32_t x = -1, y = 0;  ///< [texels] where it stands in the atlas
};

class LightTable {
public:
    /// @param lights   about the eye; `shadow` numbers `shadows`
    /// @param pixels   what is drawn of the picture: lists are of its squares
    void set(const std::vector<lighting::LightParameters>& lights, const std::vector<LightShadow>& shadows,
             const shading::PictureCamera& view, Window pixels);
    /// Few lights are uniforms, the others a texture; both hold the same texels.
    bool are_near() const { return count_ <= most_near; }
    bool has_lists() const { return has_lists_; }
    int count() const { return count_; }
    /// Of few lights, four bits each: kind, then whether it is photometric, and whether it has a range. 0: they are many.
    std::uint32_t kinds() const { return kinds_; }
    /// Likewise a bit each: it has no ambient term.
    std::uint32_t without_ambient() const { return without_ambient_; }
    const float* numbers() const { return &texels_[0].x; }
    const std::int32_t* counts() const { return counts_; }
    void bind() const;

    static constexpr int most_near = 8, square = 64;  ///< [px] side of a square with a list

private:
    void add_lists(const std::vector<lighting::LightParameters>& lights, const shading::PictureCamera& view,
                   Window pixels);

    int count_ = 0;
    bool has_lists_ = false;
    std::uint32_t kinds_ = 0, without_ambient_ = 0;
    std::int32_t counts_[4]{};
    std::vector<vec4> texels_;
    GlTexture texture_;
};

}  // namespace rakelight::opengl
