// SPDX-License-Identifier: Apache-2.0
#include "radiosity/sky_suns.h"

#include <algorithm>
#include <span>

#include "image/maps/environment.h"
#include "math/functions.h"
#include "math/linear.h"
#include "shading/lights/luminance.h"

namespace rakelight::radiosity {
namespace {

constexpr double bright = 4;  ///< times the mean luminance
constexpr std::size_t max_suns = 16;

/// Excess light of a texel.
struct Excess {
    int x, y;
    dvec3 direction, irradiance;
    double power;  ///< luminance of the irradiance
};

double solid_angle(const SkyMap& sky, int y) {
    const double top = math::cos(pi * y / sky.height), bottom = math::cos(pi * (y + 1) / sky.height);
    return 2 * pi / sky.width * (top - bottom);
}

double mean_luminance(const SkyMap& sky) {
    double sum = 0;
    for (int y = 0; y < sky.height; ++y) {
        double row = 0;
        for (int x = 0; x < sky.width; ++x)
            row += shading::luminance_of(sky.texels[std::size_t(y) * std::size_t(sky.width) + std::size_t(x)]);
        sum += row * solid_angle(sky, y);
    }
    return sum / (4 * pi);
}

std::vector<Excess> take_excess(SkyMap& sky, double most) {
    std::vector<Excess> out;
    for (int y = 0; y < sky.height; ++y)
        for (int x = 0; x < sky.width; ++x) {
            dvec3& texel = sky.texels[std::size_t(y) * std::size_t(sky.width) + std::size_t(x)];
            const double luminance = shading::luminance_of(texel);
            if (!(luminance > most)) continue;
            const dvec3 irradiance = texel * ((1 - most / luminance) * solid_angle(sky, y));
            out.push_back({x, y, equirectangular_direction((x + 0.5) / sky.width, (y + 0.5) / sky.height), irradiance,
                           shading::luminance_of(irradiance)});
            texel = texel * (most / luminance);
        }
    return out;
}

double power_of(std::span<const Excess> region) {
    double sum = 0;
    for (const Excess& e : region) sum += e.power;
    return sum;
}

/// Sorts a region along its longer side.
/// @return number of texels in the first half by power; at least one, not all
std::size_t cut(std::span<Excess> region, const SkyMap& sky) {
    const auto [left, right] = std::ranges::minmax(region, {}, &Excess::x);
    const auto [top, bottom] = std::ranges::minmax(region, {}, &Excess::y);
    const double narrowing = math::sin(pi * (top.y + bottom.y + 1) / (2.0 * sky.height));
    const bool is_wide = (right.x - left.x) * narrowing > bottom.y - top.y;
    std::ranges::sort(region, [&](const Excess& a, const Excess& b) {
        const int first = is_wide ? a.x - b.x : a.y - b.y, second = is_wide ? a.y - b.y : a.x - b.x;
        return first != 0 ? first < 0 : second < 0;
    });
    const double half = power_of(region) / 2;
    double sum = 0;
    std::size_t count = 0;
    while (count + 1 < region.size() && (count == 0 || sum < half)) sum += region[count++].power;
    return count;
}

SkySun sun_of(std::span<const Excess> region) {
    SkySun sun{};
    for (const Excess& e : region) sun.direction += e.direction * e.power, sun.irradiance += e.irradiance;
    sun.direction = normalize_or(sun.direction, region.front().direction);
    return sun;
}

}  // namespace

std::vector<SkySun> take_suns(SkyMap& sky) {
    std::vector<Excess> excess = take_excess(sky, bright * mean_luminance(sky));
    if (excess.empty()) return {};
    std::vector<std::span<Excess>> regions{excess};
    while (regions.size() < max_suns) {
        const auto strongest = std::ranges::max_element(
            regions, {}, [](std::span<const Excess> region) { return region.size() > 1 ? power_of(region) : -1.0; });
        const std::span<Excess> region = *strongest;
        if (region.size() < 2) break;
        const std::size_t first = cut(region, sky);
        *strongest = region.first(first);
        regions.push_back(region.subspan(first));
    }
    std::vector<SkySun> suns;
    for (const std::span<Excess> region : regions) suns.push_back(sun_of(region));
    return suns;
}

SkyMap shrunk(const SkyMap& sky, int width, int height) {
    SkyMap out{width, height, std::vector<dvec3>(std::size_t(width) * std::size_t(height))};
    std::vector<double> weight(out.texels.size());
    for (int y = 0; y < sky.height; ++y)
        for (int x = 0; x < sky.width; ++x) {
            const std::size_t to =
                std::size_t(y * height / sky.height) * std::size_t(width) + std::size_t(x * width / sky.width);
            const double angle = solid_angle(sky, y);
            out.texels[to] += sky.texels[std::size_t(y) * std::size_t(sky.width) + std::size_t(x)] * angle;
            weight[to] += angle;
        }
    for (std::size_t i = 0; i < out.texels.size(); ++i)
        if (weight[i] > 0) out.texels[i] = out.texels[i] / weight[i];
    return out;
}

}  // namespace rakelight::radiosity
