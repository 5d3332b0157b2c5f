// SPDX-License-Identifier: Apache-2.0
// Shadow maps of all lights in one texture, two numbers per texel: nearness, and the codes of the slopes
// (lighting/shadow/shadow_map.glsl; lighting/maps.glsl says where the faces of a cube stand).
#pragma once
#include <cstdint>
#include <vector>

#include "engines/opengl/context/driver.h"
#include "engines/opengl/context/gl_objects.h"

namespace rakelight::opengl {

class ShadowAtlas {
public:
    /// [texels] where a light's maps stand.
    struct Place {
        int x = 0, y = 0;
    };

    explicit ShadowAtlas(const Driver& driver) : driver_(driver) {}

    /// Room for the maps of lights. @param faces  [lights] 1 or 6
    /// @throws Error failed: more than this driver's textures have, no memory on the GPU
    std::vector<Place> reserve(const std::vector<int>& faces, int size);
    void forget();
    /// Binds the frame, with the viewport at a face of a light's map, which is cleared.
    /// @param nothing    bits of the nearness where nothing is
    /// @param far_depth  of the depth buffer
    void begin(Place light, int face, std::uint32_t nothing, float far_depth);
    int size() const { return size_; }
    GLuint texture() const { return texels_.name(); }

private:
    void allocate(int columns, int rows, int size);

    const Driver& driver_;
    int columns_ = 0, rows_ = 0, size_ = 0;  ///< [maps], [texels]
    GlTexture texels_;
    GlRenderbuffer depth_;
    GlFramebuffer frame_;
};

}  // namespace rakelight::opengl
