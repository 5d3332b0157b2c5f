// SPDX-License-Identifier: Apache-2.0
#include "cpu_shading/behind_picture.h"

#include <algorithm>

#include "math/flush_denormals.h"
#include "math/linear.h"
#include "shading/behind.h"

namespace rakelight::cpu_shading {
namespace {

vec4 filtered(vec4 a, vec4 b, vec4 c, vec4 d) {
    const auto sum = [](float p, float q, float r, float s) { return ((p + s) + (q + r) * 3.0f) * 0.125f; };
    return {sum(a.x, b.x, c.x, d.x), sum(a.y, b.y, c.y, d.y), sum(a.z, b.z, c.z, d.z), 1.0f};
}

/// Row `y` of a level at half the width; a width of 1 stays.
void halve_row(const MipLevel& from, int y, vec4* to) {
    const vec4* const row = from.rgba32f.data() + std::size_t(y) * std::size_t(from.width);
    if (from.width == 1) {
        to[0] = row[0];
        return;
    }
    for (int x = 0; x < from.width; x += 2)
        to[x / 2] = filtered(row[std::max(x - 1, 0)], row[x], row[x + 1], row[std::min(x + 2, from.width - 1)]);
}

MipLevel smaller(const MipLevel& from, Context& context) {
    MipLevel narrow{std::max(from.width / 2, 1), from.height, {}, {}},
        out{narrow.width, std::max(from.height / 2, 1), {}, {}};
    const auto width = std::size_t(narrow.width);
    narrow.rgba32f.resize(width * std::size_t(narrow.height));
    context.parallel_for(std::size_t(from.height), [&](std::size_t y) {
        const FlushDenormals guard;
        halve_row(from, int(y), narrow.rgba32f.data() + y * width);
    });
    if (from.height == 1) return narrow;
    out.rgba32f.resize(width * std::size_t(out.height));
    context.parallel_for(std::size_t(out.height), [&](std::size_t y) {
        const FlushDenormals guard;
        const auto row = [&](int r) {
            return narrow.rgba32f.data() + std::size_t(std::clamp(r, 0, narrow.height - 1)) * width;
        };
        const int middle = 2 * int(y);
        const vec4 *a = row(middle - 1), *b = row(middle), *c = row(middle + 1), *d = row(middle + 2);
        for (std::size_t x = 0; x < width; ++x) out.rgba32f[y * width + x] = filtered(a[x], b[x], c[x], d[x]);
    });
    return out;
}

}  // namespace

BehindPicture::BehindPicture(const shading::PictureCamera& view, Context& context) {
    chain_.is_float = true;
    const std::uint64_t pixels = std::uint64_t(view.width) * std::uint64_t(view.height);
    chain_.charge = MemoryCharge(context.memory(), pixels * 2 * sizeof(vec4), "what is behind transmissive surfaces");
    chain_.levels.push_back({view.width, view.height, {}, std::vector<vec4>(pixels)});
    static_cast<shading::BehindFactors&>(view_) = shading::behind_factors(view);
}

void BehindPicture::tile(const Tile& tile) {
    MipLevel& whole = chain_.levels[0];
    const auto width = std::size_t(tile.area.width);
    for (int y = 0; y < tile.area.height; ++y)
        std::copy_n(tile.color.begin() + std::ptrdiff_t(std::size_t(y) * width), width,
                    whole.rgba32f.begin() + std::ptrdiff_t(tile.area.y + y) * whole.width + tile.area.x);
}

void BehindPicture::finish(Context& context) {
    while (chain_.levels.back().width > 1 || chain_.levels.back().height > 1)
        chain_.levels.push_back(smaller(chain_.levels.back(), context));
    context.throw_if_cancelled();
    packed_ = pack_texture(chain_, {{}, ColorSpace::linear, Wrap::clamp_to_edge, Wrap::clamp_to_edge},
                           MemoryCharge(context.memory()));
    chain_.levels.clear();
    chain_.charge = {};
    texture_ = with_filters(*packed_, {.wrap_u = Wrap::clamp_to_edge, .wrap_v = Wrap::clamp_to_edge});
    view_.picture = &texture_;
}

}  // namespace rakelight::cpu_shading
