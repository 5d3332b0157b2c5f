// SPDX-License-Identifier: Apache-2.0
// One tile of the picture: visibility first, then shading, so each pixel is shaded once despite overdraw.
#pragma once
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include <rakelight/engines/engine.h>

#include "engines/raster/geometry/front_end.h"
#include "engines/raster/lights/light_points.h"
#include "engines/raster/lights/tile_lights.h"
#include "engines/raster/marks/marks.h"

namespace rakelight::raster {

inline constexpr int tile_pixels = tile_size * tile_size;

class ShadowTexels;      // shadow_texels.h
class AmbientOcclusion;  // occlusion.h

/// Everything that stays the same for all tiles of a picture.
struct TileJob {
    const FrontEnd& front;
    const Binned& binned;
    const TileGrid& grid;
    const std::vector<lighting::LightParameters>& lights;
    const Kernels& kernels;
    bool has_blended;  ///< some material blends
    const LightPoints& points;
    bool to_srgb8 = false;              ///< the sink takes display values
    bool whole_records = false;         ///< records have what no texture of their material needs, too: for inspection
    const Marks* marks = nullptr;       ///< lines and points; null: none
    const Context* context = nullptr;   ///< null: not cancellable
    const LightReach* reach = nullptr;  ///< null: every pixel is lit by all lights; else `tile_lights` holds the tile's
    ShadowTexels* shadow_texels = nullptr;        ///< null: no shadows
    const AmbientOcclusion* occlusion = nullptr;  ///< null: none

    /// Asked every few triangles; a tile that was cut short is not to be shown.
    bool is_cancelled() const { return context && context->cancelled(); }
};

/// AmbientOcclusion's: of the tile and a margin around, rows of its own strides.
struct OcclusionScratch {
    std::vector<float> raw, openness;
    std::vector<float> batch;  ///< [tile_pixels + batch_padding] of the pixels of a job
};

struct SampleScratch;  // multisample.h
struct LayerScratch;   // shade/blended_layers.h

/// Working memory of one tile; used again by the next one.
struct TileScratch : ChannelArrays {
private:
    using ChannelArrays::triangle;  // the channel is named through ChannelArrays, lest it be taken for batch_triangle

public:
    // Visibility: depth key (in `depth`) and position in the tile's list of the nearest triangle, -1 for none.
    // [tile_pixels], row by row.
    std::vector<std::int32_t> visible = std::vector<std::int32_t>(tile_pixels);
    std::vector<double> order;  ///< [tile_pixels] of what is seen, in pictures by another method (visibility_methods.h)
    // A batch for the kernel. [tile_pixels + batch_padding]
    std::vector<std::int32_t> pixel = batch<std::int32_t>();
    std::vector<std::int32_t> batch_triangle = batch<std::int32_t>();  ///< into `triangles`
    std::vector<float> red = batch<float>(), green = batch<float>(), blue = batch<float>(), alpha = batch<float>();
    std::vector<float> offset_x = batch<float>(), offset_y = batch<float>();
    std::vector<float> normal_x = batch<float>(), normal_y = batch<float>(), normal_z = batch<float>();
    std::vector<float> batch_depth = batch<float>();
    /// For tools: called after a blended surface was laid over a pixel of a picture of one sample; `color` is what came
    /// of it.
    /// @param number  of its triangle in the tile's list
    /// @param alpha   its own
    std::function<void(std::size_t pixel, std::uint32_t number, float alpha)> on_layer;
    std::vector<float> channel_values;  ///< [channel_planes][tile_pixels + batch_padding] where channels need them
    std::vector<ShadeTriangle> triangles;
    std::vector<LitTriangle> lit;          ///< beside `triangles` in flat and Gouraud pictures
    std::vector<CornerFrame> frames;       ///< beside `triangles` where lighting is in the vertices' tangent space
    std::vector<const TriangleRow*> rows;  ///< of the records that are made, padded
    std::vector<std::int32_t> record;      ///< [list] position in the list -> in `triangles`, -1: not wanted
    std::vector<std::int32_t> list_position = batch<std::int32_t>();  ///< position in the list that each pixel shows
    std::vector<std::int32_t> numbers = batch<std::int32_t>();        ///< number of a record -> position in the list
    std::vector<const ScreenTriangle*> wanted;                        ///< whose records are to be made
    std::vector<std::int32_t> sorted;  ///< covered pixels of tiles with very many draws, those of one draw together
    // The result, [tile_pixels], row by row of the whole tile; channels in ChannelArrays: the first four always have
    // room, the others when they are requested.
    std::vector<vec4> color = std::vector<vec4>(tile_pixels);
    std::vector<std::uint32_t> srgb8 =
        std::vector<std::uint32_t>(tile_pixels);  ///< instead of `color` where the sink takes display values
    DisplayRows display;                          ///< where those go: `srgb8`, or the sink's memory of a whole tile
    std::vector<PendingMark> pending;  ///< [tile_pixels] in pictures with lines or points; between tiles nothing waits
    std::vector<std::uint32_t> tile_lights;         ///< of many lights, those that may reach the tile
    std::vector<lighting::LightParameters> lights;  ///< those that may reach the run of pixels that is shaded
    std::uint64_t covered = 0, shaded = 0, not_finite = 0, marked = 0;
    std::uint64_t mark_tests = 0;            ///< of pixels against lines and points, of all tiles so far
    std::uint64_t samples_covered = 0;       ///< by something opaque
    std::shared_ptr<SampleScratch> samples;  ///< of multisampled pictures
    std::shared_ptr<LayerScratch> layers;    ///< of pictures with blended surfaces
    std::uint64_t layers_unsorted = 0;       ///< blended surfaces at pixels that were laid over nearer ones
    OcclusionScratch occlusion;
    StageTimes times;                ///< of all tiles so far
    std::uint64_t lit_pixels = 0;    ///< lighting was evaluated at
    std::uint64_t depth_passes = 0;  ///< opaque and masked pixels that were nearer than what stood there

    TileScratch() {
        depth.resize(tile_pixels);
        normal.resize(tile_pixels);
        object.resize(tile_pixels);
        material.resize(tile_pixels);
    }

    template <class T>
    static std::vector<T> batch() {
        return std::vector<T>(tile_pixels + batch_padding);
    }
};

/// Nearest opaque (or masked, where its texture is opaque) triangle of every pixel.
void find_visible(const TileJob& job, std::size_t tile, TileScratch& scratch);

/// Positions begin..end-1 of a tile's list, all of one draw.
struct DrawRun {
    std::int32_t begin, end;
    std::uint32_t draw;
};
/// The draws in a tile's list, which is in the order of the scene.
void find_runs(const TileJob& job, std::size_t tile, std::vector<DrawRun>& runs);
/// Some of them are blended.
bool has_blended(const TileJob& job, const std::vector<DrawRun>& runs);

/// Display values come from the kernel, to their places.
DisplayPixels display_pixels(const TileScratch& scratch);
/// Those of a linear color.
std::uint32_t display_value(vec4 color);
/// `color` as display values.
void encode_tile(TileScratch& scratch);

/// The kernel's records of triangles of one draw, about the tile's first pixel center, into `triangles` of the scratch;
/// where lighting is not evaluated at the pixels, the light of their corners into `lit`.
void make_records(const TileJob& job, std::uint32_t draw, std::span<const ScreenTriangle* const> triangles, int tile_x,
                  int tile_y, TileScratch& scratch);
/// Where the pixels' rays lead in a perspective or parallel view: ShadeJob::ray.
void set_ray(const PictureCamera& view, int tile_x, int tile_y, float (&ray)[3][3]);
/// A job for `count` pixels of the batch arrays, all of one draw; pads the arrays.
ShadeJob make_job(const TileJob& job, std::uint32_t draw, int tile_x, int tile_y, std::size_t count,
                  TileScratch& scratch);

}  // namespace rakelight::raster
