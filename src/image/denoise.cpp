// SPDX-License-Identifier: Apache-2.0
#include "image/denoise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "base/format_text.h"
#include "image/compare/picture_windows.h"
#include "image/denoise_tile.h"
#include "math/flush_denormals.h"

namespace rakelight {
namespace {

using namespace denoise;

static_assert(denoise_radius == margin);

int place(int x, int y) { return (y + margin) * stride + x + margin; }

/// Whether all are in 0..most.
bool is_within(const vec3& v, float most) {
    const auto is_good = [most](float x) { return x >= 0 && x <= most; };  // not for NaN
    return is_good(v.x) && is_good(v.y) && is_good(v.z);
}

/// A feature, or 0 if it is not finite or its square could overflow.
vec3 usable(const vec3& v) {
    const auto is_good = [](float x) { return std::fabs(x) < 1e15f; };
    return is_good(v.x) && is_good(v.y) && is_good(v.z) ? v : vec3{};
}

/// The divisor of colors; 1 if unknown. Albedos below 0.02 are clamped, because dividing by less amplifies noise of
/// specular reflection.
vec3 divisor_of(const vec3& albedo) {
    const vec3 a = usable(albedo);
    if (!(a.x > 0 || a.y > 0 || a.z > 0)) return {1, 1, 1};
    return {std::max(a.x, 0.02f), std::max(a.y, 0.02f), std::max(a.z, 0.02f)};
}

void set(float (&planes)[3][plane_floats], int i, const vec3& v, const vec3& scale) {
    planes[0][i] = v.x * scale.x, planes[1][i] = v.y * scale.y, planes[2][i] = v.z * scale.z;
}

void set(float (&planes)[3][plane_floats], int i, const vec3& v, float scale) {
    set(planes, i, v, {scale, scale, scale});
}

/// Pixel `from` of the picture as pixel i of the planes.
void fill_pixel(const NoisyPicture& in, std::size_t from, Tile& t, int i) {
    set(t.normal, i, usable(in.normal[from]), 1 / normal_bandwidth);
    set(t.albedo, i, usable(in.albedo[from]), 1 / albedo_bandwidth);
    if (!in.position.empty()) set(t.position, i, usable(in.position[from]), 1);
    if (!is_within(in.color[from], 1e16f) || !is_within(in.variance[from], 1e32f)) return;
    const vec3 d = divisor_of(in.albedo[from]), scale = {1 / d.x, 1 / d.y, 1 / d.z};
    set(t.light, i, in.color[from], scale);
    set(t.variance, i, in.variance[from], {scale.x * scale.x, scale.y * scale.y, scale.z * scale.z});
    t.valid[i] = 1;
}

/// The planes of a window with its margin, clipped to the picture.
void fill(const NoisyPicture& in, const PictureWindow& w, Tile& t) {
    t.width = w.width, t.height = w.height;
    const int left = std::max(-margin, -w.x), right = std::min(w.width + margin, in.width - w.x);
    const int top = std::max(-margin, -w.y), bottom = std::min(w.height + margin, in.height - w.y);
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x)
            fill_pixel(in, std::size_t(w.y + y) * std::size_t(in.width) + std::size_t(w.x + x), t, place(x, y));
}

float brightness(const Tile& t, int i) { return t.light[0][i] + t.light[1][i] + t.light[2][i]; }

/// Much brighter than its neighbors, with high variance: a firefly, not a small bright object.
bool is_firefly(const Tile& t, int i) {
    constexpr int side = 2 * firefly_radius + 1,
                  brighter = 3;  // neighbors that may be as bright, because fireflies cluster
    std::array<float, side * side> around;
    int count = 0, bright = 0;
    const float own = brightness(t, i);
    for (int dy = -firefly_radius; dy <= firefly_radius; ++dy)
        for (int dx = -firefly_radius; dx <= firefly_radius; ++dx) {
            const int q = i + dy * stride + dx;
            if (q == i || t.valid[q] == 0) continue;
            around[std::size_t(count++)] = brightness(t, q);
            bright += 2 * brightness(t, q) >= own;
        }
    if (bright > brighter || count <= 2 * brighter) return false;
    std::sort(around.begin(), around.begin() + count);
    const int rest = count - brighter;
    float sum = 0, squares = 0;
    for (int k = 0; k < rest; ++k) sum += around[std::size_t(k)];
    const float mean = sum / float(rest);
    for (int k = 0; k < rest; ++k) squares += (around[std::size_t(k)] - mean) * (around[std::size_t(k)] - mean);
    const float spread = std::sqrt(squares / float(rest));
    float error = 0;
    for (const auto& plane : t.variance) error += std::sqrt(plane[i]);
    return own > 2 * around[std::size_t(rest - 1)] + 4 * spread && 2 * error > own - mean;
}

/// Excludes fireflies from all averages.
void drop_fireflies(Tile& t) {
    constexpr int reach = margin - firefly_radius;
    std::vector<int> found;
    for (int y = -reach; y < t.height + reach; ++y)
        for (int x = -reach; x < t.width + reach; ++x)
            if (t.valid[place(x, y)] != 0 && is_firefly(t, place(x, y))) found.push_back(place(x, y));
    for (const int i : found) t.valid[i] = 0;
}

/// Multiplies the means by the albedo. Pixels without similar ones are unchanged.
void write(const Tile& t, const NoisyPicture& in, const PictureWindow& w, std::span<vec3> out) {
    constexpr float least = 1e-20f;  // below this, products of weights and colors may be denormal
    for (int y = 0; y < w.height; ++y)
        for (int x = 0; x < w.width; ++x) {
            const std::size_t to = std::size_t(w.y + y) * std::size_t(in.width) + std::size_t(w.x + x);
            const auto i = std::size_t(y * tile_width + x);
            const float weight = t.sum[3][i];
            const vec3 d = divisor_of(in.albedo[to]);
            if (weight >= least)
                out[to] = {t.sum[0][i] / weight * d.x, t.sum[1][i] / weight * d.y, t.sum[2][i] / weight * d.z};
            else
                out[to] = is_within(in.color[to], 1e16f) ? in.color[to] : vec3{};
        }
}

void check(const NoisyPicture& in, std::span<const vec3> out) {
    if (in.width < 0 || in.height < 0) throw Error(ErrorCode::usage, "a picture of negative size cannot be denoised");
    const std::size_t pixels = std::size_t(in.width) * std::size_t(in.height);
    const auto require = [pixels](std::size_t size, const char* what) {
        if (size == pixels) return;
        throw Error(ErrorCode::usage,
                    format_text("denoising: the {} has {} pixels, the picture {}", what, size, pixels));
    };
    require(in.color.size(), "color");
    require(in.variance.size(), "variance");
    require(in.albedo.size(), "albedo");
    require(in.normal.size(), "normal");
    if (!in.position.empty()) require(in.position.size(), "position");
    require(out.size(), "output");
}

}  // namespace

void denoise_into(const NoisyPicture& picture, std::span<vec3> out, Context& context, Isa isa) {
    check(picture, out);
    void (*const sum_neighbors)(Tile&) = RL_BY_ISA(isa, sum_neighbors);
    const MemoryCharge charge(context.memory(), std::uint64_t(context.threads()) * sizeof(Tile), "denoising");
    const std::size_t across = std::size_t((picture.width + tile_width - 1) / tile_width);
    const std::size_t down = std::size_t((picture.height + tile_height - 1) / tile_height);
    context.parallel_for(across * down, [&](std::size_t i) {
        const FlushDenormals guard;
        const int x = int(i % across) * tile_width, y = int(i / across) * tile_height;
        const PictureWindow window{x, y, std::min(tile_width, picture.width - x),
                                   std::min(tile_height, picture.height - y)};
        const auto tile = std::make_unique<Tile>();
        fill(picture, window, *tile);
        drop_fireflies(*tile);
        sum_neighbors(*tile);
        write(*tile, picture, window, out);
    });
}

}  // namespace rakelight
