// SPDX-License-Identifier: Apache-2.0
#include "shading/lights/mean_map.h"

#include <algorithm>
#include <cmath>

#include "math/linear.h"

namespace rakelight::shading {
namespace {

constexpr int most_cells = 32;
constexpr int most_texels = 256;  ///< [px] of a side of the level that is summed
constexpr double least = 1.0 / 4096;

const MipLevel& level_for(const MipChain& chain) {
    for (const MipLevel& level : chain.levels)
        if (level.width <= most_texels && level.height <= most_texels) return level;
    return chain.levels.back();
}

int cells_of(int texels) { return std::min(texels, most_cells); }

/// Cells of an axis, `end` excluded.
struct Cells {
    int begin, end;
};

Cells touched(float from, float to, Wrap wrap, float border, int count) {
    double low = double(from), high = double(to);
    if (!(high - low < 1)) return {0, count};  // or not a number
    if (wrap == Wrap::clamp_to_edge) {
        low = std::clamp(low, 0.0, 1.0), high = std::clamp(high, 0.0, 1.0);
    } else {
        const double whole = std::floor(low);
        low -= whole, high -= whole;
        if (high > 1) return {0, count};
        if (wrap == Wrap::mirrored_repeat && std::fmod(whole, 2.0) != 0) {
            std::swap(low, high);
            low = 1 - low, high = 1 - high;
        }
    }
    const auto cell = [count](double at) { return std::clamp(int(at * count), 0, count - 1); };
    return {cell(std::max(low - double(border), 0.0)), cell(std::min(high + double(border), 1.0)) + 1};
}

}  // namespace

std::uint64_t MeanMap::bytes_for(int width, int height) {
    return std::uint64_t(cells_of(width) + 1) * std::uint64_t(cells_of(height) + 1) * sizeof(Sum);
}

MeanMap::MeanMap(const MipChain& chain) {
    const MipLevel& level = level_for(chain);
    width_ = cells_of(level.width), height_ = cells_of(level.height);
    border_ = {1 / float(level.width), 1 / float(level.height)};
    const auto stride = static_cast<std::size_t>(width_ + 1);
    sums_.resize(stride * std::size_t(height_ + 1));
    const double part = double(width_) * height_ / (double(level.width) * level.height);  // of a cell
    for (int y = 0; y < level.height; ++y)
        for (int x = 0; x < level.width; ++x) {
            Sum& cell =
                sums_[std::size_t(y * height_ / level.height + 1) * stride + std::size_t(x * width_ / level.width + 1)];
            const std::size_t i = std::size_t(y) * std::size_t(level.width) + std::size_t(x);
            const dvec3 c = cast<double>(linear_texel(chain, level, i));
            cell.color += dvec3{std::max(c.x, 0.0), std::max(c.y, 0.0), std::max(c.z, 0.0)} * part;
        }
    for (Sum& s : sums_) s.cells = s.color == dvec3{} ? 0 : 1;
    for (std::size_t i = stride; i < sums_.size(); ++i)
        if (i % stride != 0) sums_[i] = {sums_[i].color + sums_[i - 1].color, sums_[i].cells + sums_[i - 1].cells};
    for (std::size_t i = stride; i < sums_.size(); ++i)
        sums_[i] = {sums_[i].color + sums_[i - stride].color, sums_[i].cells + sums_[i - stride].cells};
}

dvec3 MeanMap::mean(const UvBox& box, Wrap wrap_u, Wrap wrap_v) const {
    const Cells x = touched(box.low.x, box.high.x, wrap_u, border_.x, width_);
    const Cells y = touched(box.low.y, box.high.y, wrap_v, border_.y, height_);
    const Sum a = sum(x.begin, y.begin), b = sum(x.end, y.begin), c = sum(x.begin, y.end), d = sum(x.end, y.end);
    if (!(d.cells - c.cells - (b.cells - a.cells) > 0)) return {};
    const dvec3 inside = (d.color - c.color) - (b.color - a.color);
    const dvec3 here = inside / double((x.end - x.begin) * (y.end - y.begin));
    const dvec3 floor = sum(width_, height_).color * (least / (double(width_) * height_));
    return {std::max(here.x, floor.x), std::max(here.y, floor.y), std::max(here.z, floor.z)};
}

}  // namespace rakelight::shading
