// SPDX-License-Identifier: Apache-2.0
// A rectangle of pixels: rays through its samples, what they meet, and how it is lit.
#pragma once
#include <span>
#include <vector>

#include "engines/channel_arrays.h"
#include "engines/raytrace/trace_picture.h"

namespace rakelight::raytrace {

inline constexpr int tile_size = 32;
inline constexpr std::size_t tile_pixels = std::size_t(tile_size) * tile_size;
/// From plane to plane: no power of two, lest all planes of a ray fall on one line of the cache.
inline constexpr std::size_t plane_stride = tile_pixels + 48;

/// Counts of a tile's hits.
struct RayCounts {
    std::uint64_t shaded = 0, not_finite = 0;
};

/// Working memory of a tile, used again by the next one.
struct TileScratch : ChannelArrays {
    std::vector<float> planes;                               ///< [ray_planes][plane_stride]
    std::vector<Meeting> meetings;                           ///< [rays]
    std::vector<float> from;                                 ///< [rays] where they begin
    std::vector<std::int32_t> live, going;                   ///< rays that go on; those that are followed now
    std::vector<std::int32_t> order, hit_ray, hit_triangle;  ///< hits by draw; those of one draw
    std::vector<float> red, green, blue, alpha;
    std::vector<vec3> sum;              ///< [pixels] of one sample, times its alpha
    std::vector<float> rest;            ///< [pixels] what is not covered yet
    std::vector<vec4> color;            ///< [pixels] the result
    std::vector<vec4> sample_colors;    ///< [pixels][samples]
    std::vector<float> channel_values;  ///< [channel_planes][tile_pixels + batch_padding] where channels need them
    RayCounts counts;
};

/// @param area  of at most tile_size x tile_size pixels
/// @return the result's arrays are [area.width * area.height]
void trace_tile(const TracePicture& picture, const Window& area, const Context& context, TileScratch& scratch);

}  // namespace rakelight::raytrace
