// SPDX-License-Identifier: Apache-2.0
// A rectangle of pixels: rays through its samples, their hits, where they continue, and the lighting.
#pragma once
#include <span>
#include <vector>

#include "engines/channel_arrays.h"
#include "engines/raytrace/trace_wave.h"
#include "shading/sample_positions.h"

namespace rakelight::raytrace {

inline constexpr int tile_size = 32;
inline constexpr std::size_t tile_pixels = std::size_t(tile_size) * tile_size;
/// From plane to plane: no power of two, lest all planes of a ray fall on one line of the cache.
inline constexpr std::size_t plane_stride = tile_pixels + 48;

/// Working memory of a tile, used again by the next one.
struct TileScratch : WaveScratch, ChannelArrays {
    struct Waiting {
        int depth;
        std::vector<NextRay> rays;
    };
    std::vector<Waiting> waiting;
    RayWave primary;                    ///< in s.wave while it is followed
    std::uint64_t filled_for = 0;       ///< TracePicture::number that the constant planes of primary rays are of
    std::vector<float> covered;         ///< [pixels] alpha of one sample
    std::vector<vec4> color;            ///< [pixels] the result
    std::vector<vec4> sample_colors;    ///< [pixels][samples]
    std::vector<float> channel_values;  ///< [channel_planes][tile_pixels + batch_padding] where channels need them
    std::vector<float> own_values;      ///< [7][the same]
};

/// A ray through a place of every pixel, into s.wave; s.primary is to be swapped back with it.
void make_primary(const TracePicture& picture, const Window& area, shading::SamplePosition at, TileScratch& s);

/// Data of the nearest opaque surface at the pixels' centers.
void find_data(const TracePicture& picture, const Window& area, const Context& context, TileScratch& s);

/// @param area  of at most tile_size x tile_size pixels
/// @return the result's arrays are [area.width * area.height]
void trace_tile(const TracePicture& picture, const Window& area, const Context& context, TileScratch& scratch);

}  // namespace rakelight::raytrace
