// SPDX-License-Identifier: Apache-2.0
// Directions chosen by how much light comes from them in an environment's picture.
#pragma once
#include <vector>

#include "image/maps/mip_chain.h"
#include "shading/effect_factors.h"
#include "shading/lights/alias_table.h"

namespace rakelight::shading {

/// A direction of the world in the environment picture's own axes, and back: to_environment() of lighting/environment/.
inline vec3 to_picture(const EnvironmentFactors& e, vec3 d) {
    const auto along = [&](const float(&row)[3]) { return row[0] * d.x + row[1] * d.y + row[2] * d.z; };
    return {along(e.turn[0]), along(e.turn[1]), along(e.turn[2])};
}
inline vec3 from_picture(const EnvironmentFactors& e, vec3 d) {
    const auto along = [&](int c) { return e.turn[0][c] * d.x + e.turn[1][c] * d.y + e.turn[2][c] * d.z; };
    return {along(0), along(1), along(2)};
}

/// A density on the sphere that is constant over each texel of a small version of the picture: mean luminance of what
/// bilinear sampling of the picture shows there. Pharr, Jakob & Humphreys 2016, "Physically Based Rendering", section
/// 14.2.4, with an alias table instead of two inversions and directions uniform on the texel's part of the sphere.
/// Where the picture has any light, no direction has density 0. Immutable, thread-safe; the same bits on every machine.
class EnvironmentTable {
public:
    EnvironmentTable() = default;
    /// @param sky  EnvironmentImages::sky. At most 1024 x 512 texels of it are looked at, which takes 6 MB
    /// @throws Error bad_file: over the memory budget
    EnvironmentTable(const MipChain& sky, Context& context);

    /// The picture is black, or has no pixels: no direction is ever chosen.
    bool empty() const noexcept { return texels_.empty(); }

    struct Sample {
        vec3 direction{0, 1, 0};  ///< unit, in the picture's axes: from_picture() takes it to the world
        float pdf = 0;            ///< [1/sr] 0: the table is empty
    };
    /// @param u  0..1, 1 excluded; u.x chooses the texel: the more bits it has the better (AliasTable::sample())
    Sample sample(dvec2 u) const noexcept;

    /// [1/sr] of sample() giving it. The equirectangular() of lighting/environment/sky.glsl is the mapping.
    /// @param direction  in the picture's axes, of any length; 0 or not finite: 0
    float pdf(vec3 direction) const noexcept;

private:
    MemoryCharge charge_;  ///< pays for the tables
    int width_ = 0, height_ = 0;
    AliasTable texels_;             ///< [height * width]
    std::vector<double> row_tops_;  ///< [height + 1] cosine of the angle from +Y
    std::vector<float> per_sr_;     ///< [height] 1 / solid angle of a texel
};

}  // namespace rakelight::shading
