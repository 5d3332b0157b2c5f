// SPDX-License-Identifier: Apache-2.0
// The other ways to find what is seen at a pixel (`Visibility`), by one general path: every surface gets a number at the pixel,
// the least is seen. The default, reversed depth, has a path of its own (visibility.cpp).
#pragma once
#include <cstdint>
#include <optional>

#include "engines/raster/tile.h"
#include "engines/raster/visibility/depth_formats.h"
#include "shading/draw_choices.h"

namespace rakelight::raster {

/// What stands against other surfaces, at the pixels of one triangle.
/// Depth formats: the stored depth; of equal ones the first of the scene stays. Painter's algorithm (sorted by depth): the mean
/// of the corners' distances, of the whole triangle also where it is clipped; of equal ones the last of the scene is on top. None
/// and back-face: the last of the scene is on top.
class SurfaceOrder {
public:
    SurfaceOrder(const FrontEnd& front, const ScreenTriangle& s);

    /// At a pixel of the picture, where for_each_covered() says this depth key (z_reversed compares that one).
    double at(int x, int y, float depth) const;
    /// Of the whole triangle, for methods without depth.
    double whole() const { return mean_; }

private:
    Visibility method_;
    DepthRange range_;
    double mean_ = 0;
    double key_x_ = 0, key_y_ = 0, key_0_ = 0, low_ = 0,
           high_ = 0;  ///< plane of the reversed depth in px, and its limits
};

/// Whether a surface is in front of another at the pixel.
/// @param is_later  it comes after the other in the scene
inline bool is_seen_before(Visibility method, double mine, double standing, bool is_later) {
    return mine < standing || (mine == standing && is_later && !has_depth(method));
}

/// find_visible() for all methods but z_reversed. Fills scratch.order beside depth and visible.
void find_visible_by_method(const TileJob& job, std::size_t tile, TileScratch& scratch);

/// Where a blended triangle stands in the order in which they are laid, least first: far to near; none and back-face: as in the scene.
inline double blending_place(const FrontEnd& front, const ScreenTriangle& s) {
    if (has_depth(front.settings.visibility)) return shading::blending_place(s.farthest_key(), s.nearest_key());
    return -SurfaceOrder(front, s).whole();
}

/// Whether a blended triangle is in front of the opaque surface at a pixel.
class BlendTest {
public:
    /// @param position  of the triangle in the tile's list
    BlendTest(const FrontEnd& front, const ScreenTriangle& s, std::int32_t position)
        : method_(front.settings.visibility), position_(position) {
        if (method_ != Visibility::z_reversed) order_.emplace(front, s);
    }
    /// x, y and the corner of the tile in px, the depth key there.
    bool operator()(int x, int y, int tile_x, int tile_y, float depth, const TileScratch& scratch) const {
        const auto p = std::size_t(y * tile_size + x);
        if (!order_) return depth > scratch.depth[p];
        return is_seen_before(method_, order_->at(x + tile_x, y + tile_y, depth), scratch.order[p],
                              position_ > scratch.visible[p]);
    }

private:
    Visibility method_;
    std::int32_t position_;
    std::optional<SurfaceOrder> order_;
};

/// What a method says about culling: `back-face` leaves back faces out where `cull` says nothing.
RenderSettings settings_for_method(RenderSettings settings);

}  // namespace rakelight::raster
