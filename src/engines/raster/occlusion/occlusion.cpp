// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/occlusion/occlusion.h"

#include <algorithm>
#include <cmath>

#include "engines/raster/material_jobs.h"
#include "engines/raster/multisample.h"
#include "math/flush_denormals.h"
#include "math/functions.h"

namespace rakelight::raster {
namespace {

constexpr int most_reach = 512;  ///< [px]
constexpr int places = occlusion_pattern * occlusion_pattern;
/// Steps to each side of a slice are what is missed least: the square of pixels brings as many directions again.
constexpr int few_samples = 32, some_samples = 128;
constexpr int steps_of_few = 4, steps_of_some = 8, steps_of_many = 16;
constexpr int side_margin = 1;  ///< [px] fragments look at the pixels beside theirs
/// How far a triangle's depth may be from that of a pixel which shows it: of its change per pixel, since corners are snapped, and of itself.
constexpr float same_surface = 0.05f, rounding = 1e-5f;
constexpr std::size_t vector_padding = 32;  ///< [floats] kernels read and write whole vectors
constexpr int openness_side = tile_size + 2 * side_margin;
constexpr std::size_t openness_stride = std::size_t(openness_side) + vector_padding;
constexpr int raw_side = openness_side + 2 * smoothing_reach;
constexpr std::size_t raw_stride = std::size_t(raw_side) + vector_padding;
/// [px] beside what is looked at along slices: the rest of what a pixel's openness depends on.
constexpr int beyond_reach = side_margin + smoothing_reach + occlusion_margin + 1;

Window widened(const Window& w, int by, const PictureCamera& view) {
    const int left = std::max(w.x - by, 0), top = std::max(w.y - by, 0);
    const int right = std::min(w.x + w.width + by, view.width), bottom = std::min(w.y + w.height + by, view.height);
    return {left, top, right - left, bottom - top};
}

Window common(const Window& a, const Window& b) {
    const int left = std::max(a.x, b.x), top = std::max(a.y, b.y);
    const int right = std::min(a.x + a.width, b.x + b.width), bottom = std::min(a.y + a.height, b.y + b.height);
    return {left, top, std::max(right - left, 0), std::max(bottom - top, 0)};
}

}  // namespace

int occlusion_reach(const RenderSettings& settings) { return std::clamp(settings.height / 3, 8, most_reach); }

double occlusion_radius(const RenderSettings& settings, const Bounds& bounds) {
    if (settings.ambient_occlusion_radius > 0) return settings.ambient_occlusion_radius;
    return bounds.empty() ? 1 : default_occlusion_share * 0.5 * bounds.diagonal();
}

AmbientOcclusion::AmbientOcclusion(const FrontEnd& front, const Binned& binned, const TileGrid& grid,
                                   const Kernels& kernels, Context& context)
    : view_(front.view),
      front_(&front),
      binned_(&binned),
      grid_(grid),
      geometry_(front.kernels),
      kernels_(kernels),
      settings_(front.settings) {
    set_factors(view_);
    const Window wide = widened(grid.window, occlusion_reach(settings_) + beyond_reach, view_);
    if (wide == grid.window && settings_.surfaces) return;
    settings_.window = wide;
    grid_ = TileGrid(settings_.width, settings_.height, wide);
    guard_.emplace(FrontEnd{.list = front.list,
                            .view = view_,
                            .settings = settings_,
                            .kernels = geometry_,
                            .memory = PictureMemory(context.memory())});
    transform_draws(*guard_, context);
    guard_binned_ = set_up_and_bin(*guard_, grid_, {}, context);
    guard_->shading = front.shading;
    make_material_jobs(*guard_, {});
    front_ = &*guard_, binned_ = &guard_binned_;
}

void AmbientOcclusion::set_factors(const PictureCamera& view) {
    const int samples = settings_.ambient_occlusion_samples;
    factors_.is_parallel = view.orthographic;
    factors_.steps = samples < few_samples ? steps_of_few : samples < some_samples ? steps_of_some : steps_of_many;
    factors_.slices = std::max(1, (samples + factors_.steps) / (2 * factors_.steps));
    factors_.ray_x = float(2 / (view.width * view.scale_x));
    factors_.ray_y = float(-2 / (view.height * view.scale_y));
    factors_.first_x = float((1.0 / view.width - 1) / view.scale_x);
    factors_.first_y = float((1 - 1.0 / view.height) / view.scale_y);
    factors_.near = float(view.z_near);
    factors_.depth_range = view.orthographic ? float(view.z_far - view.z_near) : 0.0f;
    factors_.radius = float(occlusion_radius(settings_, front_->list.bounds));
    factors_.most_pixels = float(occlusion_reach(settings_));
    for (int i = 0; i < factors_.slices; ++i)
        for (int place = 0; place < places; ++place) {
            const double angle = pi * (i + double(place) / places) / factors_.slices;
            cosines_.push_back(float(math::cos(angle))), sines_.push_back(float(math::sin(angle)));
        }
    factors_.cosines = cosines_.data(), factors_.sines = sines_.data();
}

void AmbientOcclusion::draw_depths(const Window& strip, Context& context) {
    area_ = widened(strip, occlusion_reach(settings_) + beyond_reach, view_);
    const auto margins = std::size_t(2 * occlusion_margin);
    stride_ = std::size_t(area_.width) + margins + vector_padding;
    const std::size_t count = stride_ * (std::size_t(area_.height) + margins) + vector_padding;
    if (count > keys_.size()) charge_ = MemoryCharge(context.memory(), count * sizeof(float), "ambient occlusion");
    keys_.assign(count, -1.0f);
    const std::vector<lighting::LightParameters> no_lights;
    const LightPoints no_points;
    const TileJob job{*front_, *binned_, grid_, no_lights, kernels_, false, no_points};
    const auto first_row = std::size_t(area_.y / tile_size - grid_.first_y);
    const auto last_row = std::size_t((area_.y + area_.height - 1) / tile_size - grid_.first_y);
    context.parallel_for(last_row - first_row + 1, [&](std::size_t row) {
        const FlushDenormals guard;
        TileScratch scratch;
        for (int column = 0; column < grid_.columns && !context.cancelled(); ++column) {
            const std::size_t tile = grid_.first_of_row(int(first_row + row)) + std::size_t(column);
            if (binned_->offsets[tile] == binned_->offsets[tile + 1]) continue;
            find_visible_at({{0, 0}, scratch.depth.data(), scratch.visible.data()}, job, tile, scratch);
            const Window pixels = common(grid_.pixels(tile), area_);
            for (int y = pixels.y; y < pixels.y + pixels.height; ++y) {
                const float* const from =
                    scratch.depth.data() + (y - grid_.origin_y(tile)) * tile_size + (pixels.x - grid_.origin_x(tile));
                float* const to = keys_.data() + (std::size_t(y - area_.y) + occlusion_margin) * stride_ +
                                  std::size_t(pixels.x - area_.x) + occlusion_margin;
                for (int i = 0; i < pixels.width; ++i) to[i] = from[i] > 0 || view_.orthographic ? from[i] : -1.0f;
            }
        }
    });
    context.throw_if_cancelled();
    factors_.keys = keys_.data() + occlusion_margin * stride_ + occlusion_margin;
    factors_.key_stride = std::int64_t(stride_);
    factors_.left = area_.x, factors_.top = area_.y;
    factors_.right = area_.x + area_.width - 1, factors_.bottom = area_.y + area_.height - 1;
}

void AmbientOcclusion::find(const Window& area, int origin_x, int origin_y, TileScratch& s) const {
    OcclusionScratch& o = s.occlusion;
    o.openness.assign(openness_stride * openness_side + vector_padding, 1.0f);
    o.raw.assign(raw_stride * raw_side + vector_padding, 1.0f);
    o.batch.resize(tile_pixels + batch_padding);
    const auto job_of = [&](int margin, std::vector<float>& to, std::size_t stride, int side) {
        OcclusionJob job = factors_;
        const Window w = widened(area, margin, view_);
        job.x = w.x, job.y = w.y, job.width = w.width, job.height = w.height;
        const int left = origin_x - side, top = origin_y - side;  // where the array begins
        job.openness = to.data() + std::size_t(w.y - top) * stride + std::size_t(w.x - left);
        job.openness_stride = std::int64_t(stride);
        return job;
    };
    OcclusionJob job = job_of(side_margin + smoothing_reach, o.raw, raw_stride, side_margin + smoothing_reach);
    geometry_.occlusion(&job);
    job = job_of(side_margin, o.openness, openness_stride, side_margin);
    job.raw = o.raw.data() + std::size_t(job.y - origin_y + side_margin + smoothing_reach) * raw_stride +
              std::size_t(job.x - origin_x + side_margin + smoothing_reach);
    job.raw_stride = std::int64_t(raw_stride);
    geometry_.smooth_occlusion(&job);
}

namespace {

/// @param x, y  [px] in the tile
float openness_at(const TileScratch& s, int x, int y) {
    return s.occlusion.openness[std::size_t(y + side_margin) * openness_stride + std::size_t(x + side_margin)];
}

}  // namespace

void AmbientOcclusion::find(const TileJob& job, std::size_t tile, TileScratch& s) const {
    const bool is_empty = job.binned.offsets[tile] == job.binned.offsets[tile + 1];
    if (is_empty)
        s.occlusion.openness.assign(openness_stride * openness_side + vector_padding, 1.0f);
    else
        find(job.grid.pixels(tile), job.grid.origin_x(tile), job.grid.origin_y(tile), s);
    if (!(job.front.settings.channels & channel_ambient_occlusion)) return;
    s.ambient_occlusion.resize(tile_pixels);
    for (int y = 0; y < tile_size; ++y)
        for (int x = 0; x < tile_size; ++x) s.ambient_occlusion[std::size_t(y * tile_size + x)] = openness_at(s, x, y);
}

void AmbientOcclusion::give(ShadeJob& job, TileScratch& s) const {
    float* const to = s.occlusion.batch.data();
    for (int i = 0; i < job.count + batch_padding; ++i)
        to[i] = openness_at(s, job.pixel[i] & (tile_size - 1), job.pixel[i] >> tile_bits);
    job.openness = to;
}

float AmbientOcclusion::key_at(int x, int y) const {
    return factors_.keys[std::int64_t(y - factors_.top) * factors_.key_stride + (x - factors_.left)];
}

/// @param x, y    [px] in the tile
/// @param px, py  the same in the picture
float AmbientOcclusion::best_around(int x, int y, int px, int py, const ShadeTriangle& triangle,
                                    const TileScratch& s) const {
    constexpr int order[9][2] = {{0, 0}, {-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}};
    const float(&plane)[3] = triangle.depth;
    const auto near = float(view_.z_near), per_range = float(1 / (view_.z_far - view_.z_near));
    const float key_x = plane[0] * (view_.orthographic ? per_range : near),
                key_y = plane[1] * (view_.orthographic ? per_range : near);
    float least = INFINITY, best = 1;
    for (const auto& [dx, dy] : order) {
        const int qx = px + dx, qy = py + dy;
        if (qx < area_.x || qy < area_.y || qx >= area_.x + area_.width || qy >= area_.y + area_.height) continue;
        const float found = key_at(qx, qy);
        if (found < 0) continue;
        const float depth = plane[0] * float(x + dx) + plane[1] * float(y + dy) + plane[2];
        const float key = view_.orthographic ? 1 - (depth - near) * per_range : depth * near;
        const float off = std::fabs(key - found);
        const bool is_center = dx == 0 && dy == 0;
        if (is_center && off <= same_surface * (std::fabs(key_x) + std::fabs(key_y)) + rounding * std::fabs(key))
            return openness_at(s, x, y);
        if (off < least) least = off, best = openness_at(s, x + dx, y + dy);
    }
    return best;
}

void AmbientOcclusion::give_to_fragments(ShadeJob& job, int origin_x, int origin_y, TileScratch& s) const {
    float* const to = s.occlusion.batch.data();
    for (int i = 0; i < job.count; ++i) {
        const int x = job.pixel[i] & (tile_size - 1), y = job.pixel[i] >> tile_bits;
        to[i] = best_around(x, y, origin_x + x, origin_y + y, job.triangles[job.triangle[i]], s);
    }
    std::fill_n(to + job.count, batch_padding, to[job.count - 1]);
    job.openness = to;
}

}  // namespace rakelight::raster
