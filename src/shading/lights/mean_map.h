// SPDX-License-Identifier: Apache-2.0
// The mean color of parts of a picture, roughly and fast: how much light a triangle with an emission texture gives.
#pragma once
#include <vector>

#include <rakelight/scene/scene.h>

#include "image/maps/mip_chain.h"

namespace rakelight::shading {

/// A box of texture coordinates, in which wraps are not yet undone.
struct UvBox {
    vec2 low, high;
};

/// Sums of at most 32 x 32 cells of a color picture (Crow 1984, "Summed-Area Tables for Texture Mapping").
class MeanMap {
public:
    /// @param chain  of a color picture with at least one level
    explicit MeanMap(const MipChain& chain);
    /// At most, of a picture of that size. [bytes]
    static std::uint64_t bytes_for(int width, int height);

    /// Linear RGB over all cells that the box touches; over a whole axis where the box goes through a seam of it. 0 exactly
    /// where they are black, at least 1/4096 of the picture's mean where they are not.
    dvec3 mean(const UvBox& box, Wrap wrap_u, Wrap wrap_v) const;

private:
    struct Sum {
        dvec3 color;
        double cells = 0;  ///< not black
    };
    Sum sum(int x, int y) const { return sums_[std::size_t(y) * std::size_t(width_ + 1) + std::size_t(x)]; }

    int width_ = 1, height_ = 1;
    vec2 border_;            ///< [uv] that bilinear sampling brings light across
    std::vector<Sum> sums_;  ///< [height + 1][width + 1] of the cells above and to the left
};

}  // namespace rakelight::shading
