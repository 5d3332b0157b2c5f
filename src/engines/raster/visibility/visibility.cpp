// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdlib>
#include <span>

#include "engines/raster/material_jobs.h"
#include "engines/raster/multisample.h"
#include "engines/raster/tile.h"
#include "engines/raster/visibility/coverage.h"
#include "engines/raster/visibility/visibility_methods.h"

namespace rakelight::raster {
namespace {

/// A masked triangle: pixels that would be visible read the texture first.
void cover_masked(const TileJob& job, const ScreenTriangle& s, std::int32_t position, const Window& area, int ox,
                  int oy, const SamplePlane& plane, TileScratch& scratch) {
    std::size_t count = 0;
    cover(seen_from(plane.at, s), area, ox, oy, [&](int x, int y, float depth) {
        if (!(depth > plane.depth[y * tile_size + x])) return;
        scratch.pixel[count] = y * tile_size + x;
        scratch.batch_triangle[count] = 0;
        scratch.batch_depth[count++] = depth;
    });
    if (count == 0) return;
    const ScreenTriangle* const only = &s;
    make_records(job, s.draw, {&only, 1}, ox, oy, scratch);
    ShadeJob batch = make_job(job, s.draw, ox, oy, count, scratch);
    if (plane.at.x != 0 || plane.at.y != 0) move_to(plane.at, count, batch, scratch);
    job.kernels.alpha(&batch);
    const float cutoff = mask_cutoff(job.front, s.draw);
    for (std::size_t i = 0; i < count; ++i) {
        if (!(scratch.alpha[i] >= cutoff)) continue;
        const auto p = std::size_t(scratch.pixel[i]);
        plane.depth[p] = scratch.batch_depth[i];
        plane.visible[p] = position;
        ++scratch.depth_passes;
    }
}

/// Edge functions stay in 32 bits over the tile and the lanes beyond its box. Those of edges longer than 65,000 pixels do not.
bool fits_kernel(const Coverage& c) {
    constexpr std::int64_t limit = std::int64_t(1) << 30;
    std::int64_t largest = 0;
    for (int k = 0; k < 3; ++k)
        largest =
            std::max(largest, std::abs(c.edge[k]) + 2 * tile_size * (std::abs(c.step_x[k]) + std::abs(c.step_y[k])));
    return largest < limit;
}

CoverJob cover_job(const Coverage& c, std::int32_t position, const SamplePlane& plane) {
    CoverJob job;
    job.left = c.left, job.top = c.top, job.right = c.right, job.bottom = c.bottom;
    for (int k = 0; k < 3; ++k) {
        job.edge[k] = std::int32_t(c.edge[k]);
        job.step_x[k] = std::int32_t(c.step_x[k]);
        job.step_y[k] = std::int32_t(c.step_y[k]);
    }
    job.plane_x = c.plane_x, job.plane_y = c.plane_y;
    job.depth_0 = c.depth_0, job.depth_x = c.depth_x, job.depth_y = c.depth_y;
    job.depth_low = c.depth_low, job.depth_high = c.depth_high;
    job.position = position;
    job.depth = plane.depth;
    job.visible = plane.visible;
    return job;
}

/// The farthest depth in a tile: triangles that are not nearer are skipped. It is updated after half a tile's worth of
/// pixels was written.
class FarthestDepth {
public:
    FarthestDepth(const GeometryKernels& kernels, const Window& area, int ox, int oy, const float* depth)
        : kernels_(kernels),
          left_(area.x - ox),
          top_(area.y - oy),
          right_(left_ + area.width - 1),
          bottom_(top_ + area.height - 1),
          depth_(depth) {}
    float key() const { return farthest_; }
    bool hides(const ScreenTriangle& s) const { return s.nearest_key() <= farthest_; }
    void written(std::int32_t pixels) {
        if ((since_ += pixels) < tile_pixels / 2) return;
        since_ = 0;
        farthest_ = kernels_.farthest(depth_, left_, top_, right_, bottom_);
    }

private:
    const GeometryKernels& kernels_;
    int left_, top_, right_, bottom_;
    const float* depth_;
    std::int32_t since_ = 0;
    float farthest_ = -1;
};

std::int32_t cover_opaque(const TileJob& job, const Coverage& c, std::int32_t position, const SamplePlane& plane) {
    if (fits_kernel(c)) {
        const CoverJob kernel_job = cover_job(c, position, plane);
        return job.front.kernels.cover(&kernel_job);
    }
    std::int32_t written = 0;
    for_each_covered(c, [&](int x, int y, float depth) {
        const int p = y * tile_size + x;
        if (!(depth > plane.depth[p])) return;  // the first of equals stays
        plane.depth[p] = depth;
        plane.visible[p] = position;
        ++written;
    });
    return written;
}

constexpr std::size_t triangles_per_job = 64;  ///< between looks at the farthest depth of the tile

/// The visibility of one tile, at its pixels' centers or at one of their samples.
class TileVisibility {
public:
    TileVisibility(const TileJob& job, std::size_t tile, const SamplePlane& plane, TileScratch& scratch)
        : job_(job),
          plane_(plane),
          s_(scratch),
          area_(job.grid.pixels(tile)),
          ox_(job.grid.origin_x(tile)),
          oy_(job.grid.origin_y(tile)),
          farthest_(job.front.kernels, area_, ox_, oy_, plane.depth) {}

    /// @param position  of the first triangle in the tile's list
    void draw(std::uint32_t draw, bool has_large, std::span<const ScreenTriangle* const> list, std::int32_t position) {
        const MaterialView& material = job_.front.list.view(draw);
        if (material.blend) return;
        if (mask_cutoff(job_.front, draw) >= 0) return draw_masked(list, position);
        if (!has_large) return draw_small(list, position);
        for (std::size_t i = 0; i < list.size() && !job_.is_cancelled();) {
            std::size_t end = i;
            while (end < list.size() && !list[end]->is_large) ++end;
            draw_small(list.subspan(i, end - i), position + std::int32_t(i));
            if (end < list.size()) draw_large(*list[end], position + std::int32_t(end));
            i = end + 1;
        }
    }

private:
    void draw_masked(std::span<const ScreenTriangle* const> list, std::int32_t position) {
        for (std::size_t i = 0; i < list.size() && !job_.is_cancelled(); ++i)
            if (!farthest_.hides(*list[i]))
                cover_masked(job_, *list[i], position + std::int32_t(i), area_, ox_, oy_, plane_, s_);
    }

    void draw_small(std::span<const ScreenTriangle* const> list, std::int32_t position) {
        NearestJob job;
        const ScreenTriangle* const* const end_of_items = job_.binned.items.data() + job_.binned.items.size();
        job.tile_x = ox_, job.tile_y = oy_;
        job.sample_x = plane_.at.x * fixed_per_position, job.sample_y = plane_.at.y * fixed_per_position;
        job.left = area_.x - ox_, job.top = area_.y - oy_;
        job.right = job.left + area_.width - 1, job.bottom = job.top + area_.height - 1;
        job.depth = plane_.depth;
        job.visible = plane_.visible;
        for (std::size_t i = 0; i < list.size() && !job_.is_cancelled(); i += triangles_per_job) {
            job.rows = reinterpret_cast<const TriangleRow* const*>(list.data() + i);
            job.count = std::int32_t(std::min(triangles_per_job, list.size() - i));
            job.total = std::int32_t(std::min<std::ptrdiff_t>(end_of_items - (list.data() + i), 1 << 16));
            job.position = position + std::int32_t(i);
            job.farthest = farthest_.key();
            note(job_.front.kernels.nearest(&job));
        }
    }

    void draw_large(const ScreenTriangle& s, std::int32_t position) {
        Coverage c;
        if (!farthest_.hides(s) && set_coverage(seen_from(plane_.at, s), area_, ox_, oy_, c))
            note(cover_opaque(job_, c, position, plane_));
    }

    void note(std::int32_t written) {
        s_.depth_passes += std::uint64_t(written);
        farthest_.written(written);
    }

    const TileJob& job_;
    const SamplePlane plane_;
    TileScratch& s_;
    Window area_;
    int ox_, oy_;
    FarthestDepth farthest_;
};

}  // namespace

void find_visible(const TileJob& job, std::size_t tile, TileScratch& scratch) {
    if (job.front.settings.visibility != Visibility::z_reversed) return find_visible_by_method(job, tile, scratch);
    find_visible_at({{0, 0}, scratch.depth.data(), scratch.visible.data()}, job, tile, scratch);
}

void find_visible_at(const SamplePlane& plane, const TileJob& job, std::size_t tile, TileScratch& scratch) {
    job.front.kernels.clear_tile(plane.depth, plane.visible);
    TileVisibility visibility(job, tile, plane, scratch);
    std::int32_t position = 0;
    for (std::uint32_t r = job.binned.run_offsets[tile]; r < job.binned.run_offsets[tile + 1] && !job.is_cancelled();
         ++r) {
        const TileRun& run = job.binned.runs[r];
        visibility.draw(run.draw, run.has_large, {job.binned.items.data() + run.first, run.count}, position);
        position += std::int32_t(run.count);
    }
}

}  // namespace rakelight::raster
