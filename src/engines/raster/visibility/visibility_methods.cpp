// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/visibility/visibility_methods.h"

#include <algorithm>
#include <limits>

#include "engines/raster/material_jobs.h"
#include "engines/raster/tile.h"
#include "engines/raster/visibility/coverage.h"

namespace rakelight::raster {
namespace {

/// One tile by a method.
class MethodTile {
public:
    MethodTile(const TileJob& job, std::size_t tile, TileScratch& scratch)
        : job_(job),
          s_(scratch),
          method_(job.front.settings.visibility),
          area_(job.grid.pixels(tile)),
          ox_(job.grid.origin_x(tile)),
          oy_(job.grid.origin_y(tile)) {
        s_.order.assign(tile_pixels, std::numeric_limits<double>::infinity());
    }

    void add(const ScreenTriangle& t, std::int32_t position) {
        const std::uint32_t material = job_.front.list.draws[t.draw].material;
        const MaterialView& view = job_.front.list.views.materials[material];
        if (view.blend) return;
        const float cutoff = mask_cutoff(job_.front, t.draw);
        if (cutoff >= 0) return add_masked(t, position, cutoff);
        for_each_seen(t, [&](int x, int y, float depth, double order) {
            keep(std::size_t(y * tile_size + x), position, depth, order);
        });
    }

private:
    /// Calls visit(x, y, depth, order) for each pixel, relative to the tile's corner, where the triangle is in front.
    template <class Visit>
    void for_each_seen(const ScreenTriangle& t, const Visit& visit) {
        const SurfaceOrder order(job_.front, t);
        cover(t, area_, ox_, oy_, [&](int x, int y, float depth) {
            const double mine = order.at(x + ox_, y + oy_, depth);
            if (is_seen_before(method_, mine, s_.order[std::size_t(y * tile_size + x)], true)) visit(x, y, depth, mine);
        });
    }

    void keep(std::size_t p, std::int32_t position, float depth, double order) {
        s_.depth[p] = depth;
        s_.order[p] = order;
        s_.visible[p] = position;
        ++s_.depth_passes;
    }

    /// The pixels that would be visible ask the texture first.
    void add_masked(const ScreenTriangle& t, std::int32_t position, float cutoff) {
        std::size_t count = 0;
        std::vector<double> orders;
        for_each_seen(t, [&](int x, int y, float depth, double order) {
            s_.pixel[count] = y * tile_size + x;
            s_.batch_triangle[count] = 0;
            s_.batch_depth[count++] = depth;
            orders.push_back(order);
        });
        if (count == 0) return;
        const ScreenTriangle* const only = &t;
        make_records(job_, t.draw, {&only, 1}, ox_, oy_, s_);
        const ShadeJob batch = make_job(job_, t.draw, ox_, oy_, count, s_);
        job_.kernels.alpha(&batch);
        for (std::size_t i = 0; i < count; ++i)
            if (s_.alpha[i] >= cutoff) keep(std::size_t(s_.pixel[i]), position, s_.batch_depth[i], orders[i]);
    }

    const TileJob& job_;
    TileScratch& s_;
    Visibility method_;
    Window area_;
    int ox_, oy_;
};

}  // namespace

SurfaceOrder::SurfaceOrder(const FrontEnd& front, const ScreenTriangle& s)
    : method_(front.settings.visibility), range_{front.view.z_near, front.view.z_far, front.view.orthographic} {
    if (method_ == Visibility::none || method_ == Visibility::back_face) return;
    const std::uint32_t* const index =
        front.list.scene.meshes[front.list.draws[s.draw].mesh].indices.data() + 3 * std::size_t(s.triangle);
    const ClipVertices& clip = front.clip[s.draw];
    const ClipVertex v[3] = {clip[index[0]], clip[index[1]], clip[index[2]]};
    mean_ = (double(v[0].distance) + double(v[1].distance) + double(v[2].distance)) / 3;
    if (!has_depth(method_)) return;
    EdgePlanes e{};
    edge_planes(v, front.view, 0, 0, e);  // seen exactly from the edge: planes of 0, so the farthest corner counts
    double key[3];
    for (std::size_t i = 0; i < 3; ++i) {
        key[i] = reversed_depth(std::max(double(v[i].distance), range_.z_near), range_);
        const double weight = range_.orthographic ? reversed_depth(v[i].distance, range_) : range_.z_near;
        key_x_ += e.ex[i] * weight;
        key_y_ += e.ey[i] * weight;
        key_0_ += e.e0[i] * weight;
    }
    low_ = std::min({key[0], key[1], key[2]});
    high_ = std::max({key[0], key[1], key[2]});
}

double SurfaceOrder::at(int x, int y, float depth) const {
    if (method_ == Visibility::z_reversed) return -double(depth);
    if (!has_depth(method_)) return mean_;
    const double plane = key_0_ + key_x_ * (x + 0.5) + key_y_ * (y + 0.5);
    const double from_below = plane > low_ ? plane : low_;  // NaN: the farthest corner
    return stored_depth(method_, from_below < high_ ? from_below : high_, range_);
}

void find_visible_by_method(const TileJob& job, std::size_t tile, TileScratch& scratch) {
    std::fill(scratch.depth.begin(), scratch.depth.end(), -1.0f);
    std::fill(scratch.visible.begin(), scratch.visible.end(), -1);
    MethodTile method(job, tile, scratch);
    const std::uint32_t first = job.binned.offsets[tile], end = job.binned.offsets[tile + 1];
    for (std::uint32_t i = first; i < end && !job.is_cancelled(); ++i)
        method.add(*job.binned.items[i], std::int32_t(i - first));
}

RenderSettings settings_for_method(RenderSettings settings) {
    if (settings.visibility == Visibility::back_face && settings.cull == Cull::automatic) settings.cull = Cull::back;
    return settings;
}

}  // namespace rakelight::raster
