// SPDX-License-Identifier: Apache-2.0
#include "shading/lights/environment_table.h"

#include <algorithm>
#include <cmath>

#include "image/maps/environment.h"
#include "math/functions.h"
#include "math/linear.h"
#include "shading/lights/luminance.h"

namespace rakelight::shading {
namespace {

constexpr int widest = 1024, highest = 512;  ///< [px] of the level that is looked at

/// Of the mean, added everywhere: what a level of 8 bits rounds to black, and what coarser levels bring from farther off.
constexpr double even_share = 0.005;

const MipLevel& level_for(const MipChain& sky) {
    for (const MipLevel& level : sky.levels)
        if (level.width <= widest && level.height <= highest) return level;
    return sky.levels.back();
}

std::vector<double> luminances_of(const MipChain& sky, const MipLevel& level) {
    std::vector<double> out(std::size_t(level.width) * std::size_t(level.height));
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = luminance_of(linear_texel(sky, level, i));
    return out;
}

/// Means of the bilinear picture instead of texels. Of a texel as wide as the picture's, a quarter at either side is a ramp to
/// its neighbor: 1/8, 6/8, 1/8; less in proportion where it stands for several.
void blend_rows(std::vector<double>& values, int width, int height, double part) {
    std::vector<double> row(static_cast<std::size_t>(width));
    for (int y = 0; y < height; ++y) {
        double* const v = values.data() + std::size_t(y) * std::size_t(width);
        std::copy(v, v + width, row.begin());
        for (int x = 0; x < width; ++x) {
            const double left = row[std::size_t((x + width - 1) % width)], right = row[std::size_t((x + 1) % width)];
            v[x] = (1 - 2 * part) * v[x] + part * (left + right);
        }
    }
}

void blend_columns(std::vector<double>& values, int width, int height, double part) {
    const auto w = static_cast<std::size_t>(width);
    std::vector<double> above(values.begin(), values.begin() + width);  // at the poles the last row continues
    for (int y = 0; y < height; ++y)
        for (std::size_t x = 0; x < w; ++x) {
            double* const v = values.data() + std::size_t(y) * w + x;
            const double own = *v, below = y + 1 < height ? v[w] : own;
            *v = (1 - 2 * part) * own + part * (above[x] + below);
            above[x] = own;
        }
}

bool has_light(const MipChain& sky, const MipLevel& level) {
    const std::size_t count = std::size_t(level.width) * std::size_t(level.height);
    for (std::size_t i = 0; i < count; ++i)
        if (luminance_of(linear_texel(sky, level, i)) > 0) return true;
    return false;
}

/// Instead of means over texels their part of all light.
void weigh(std::vector<double>& values, int width, const std::vector<double>& solid_angles) {
    double light = 0, sphere = 0;
    const auto w = static_cast<std::size_t>(width);
    for (std::size_t i = 0; i < values.size(); ++i) {
        light += values[i] * solid_angles[i / w];
        sphere += solid_angles[i / w];
    }
    const double even = light > 0 ? even_share * light / sphere : 1;
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = (values[i] + even) * solid_angles[i / w];
}

}  // namespace

EnvironmentTable::EnvironmentTable(const MipChain& sky, Context& context) {
    if (sky.levels.empty()) return;
    const MipLevel& full = sky.levels[0];
    const MipLevel& level = level_for(sky);
    const std::uint64_t count = std::uint64_t(level.width) * std::uint64_t(level.height);
    charge_ = MemoryCharge(context.memory(), AliasTable::bytes_for(count), "the table of the environment's light");
    context.memory().check(AliasTable::bytes_to_make(count) + count * sizeof(double),
                           "the table of the environment's light");
    std::vector<double> values = luminances_of(sky, level);
    const bool is_black = std::all_of(values.begin(), values.end(), [](double v) { return v == 0; });
    if (is_black && !has_light(sky, full)) {
        charge_ = {};
        return;
    }
    width_ = level.width, height_ = level.height;
    blend_rows(values, width_, height_, 0.125 * width_ / full.width);
    blend_columns(values, width_, height_, 0.125 * height_ / full.height);
    for (int y = 0; y <= height_; ++y) row_tops_.push_back(math::cos(pi * y / height_));
    std::vector<double> solid_angles;
    for (std::size_t y = 0; y + 1 < row_tops_.size(); ++y) {
        solid_angles.push_back(2 * pi / width_ * (row_tops_[y] - row_tops_[y + 1]));
        per_sr_.push_back(float(1 / solid_angles.back()));
    }
    weigh(values, width_, solid_angles);
    texels_ = AliasTable(values);
}

EnvironmentTable::Sample EnvironmentTable::sample(dvec2 u) const noexcept {
    if (empty()) return {};
    const AliasTable::Sample texel = texels_.sample(u.x);
    const std::uint32_t x = texel.index % std::uint32_t(width_), y = texel.index / std::uint32_t(width_);
    const double cosine = row_tops_[y] + (row_tops_[y + 1] - row_tops_[y]) * u.y;
    const double across = std::sqrt(std::max(1 - cosine * cosine, 0.0));
    const double phi = 2 * pi * ((x + texel.rest) / width_ - 0.5);
    const dvec3 d{across * math::sin(phi), cosine, -across * math::cos(phi)};
    return {cast<float>(d), texel.probability * per_sr_[y]};
}

float EnvironmentTable::pdf(vec3 direction) const noexcept {
    const dvec3 d = cast<double>(direction);
    const double length = std::sqrt(dot(d, d));
    if (empty() || !std::isfinite(length) || length == 0) return 0;
    const dvec2 uv = equirectangular(d / length);
    const auto cell = [](double at, int count) { return std::uint32_t(std::clamp(at * count, 0.0, count - 1.0)); };
    const std::uint32_t x = cell(uv.x, width_), y = cell(uv.y, height_);
    return texels_.probability(y * std::uint32_t(width_) + x) * per_sr_[y];
}

}  // namespace rakelight::shading
