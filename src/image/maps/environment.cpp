// SPDX-License-Identifier: Apache-2.0
#include "image/maps/environment.h"

#include <algorithm>
#include <cmath>

#include "math/functions.h"
#include "math/linear.h"

namespace rakelight {
namespace {

constexpr int widest_for_sums = 1024;  ///< [px] of the level that irradiance is summed over
constexpr int largest_map = 512;       ///< [texels] of the sharpest octahedral map
constexpr int sizes[environment_levels] = {largest_map, 128, 64, 32, 32, 32, 32, 32};
constexpr int samples[environment_levels] = {1, 48, 96, 128, 192, 256, 256, 256};

/// The largest level of at most this width.
const MipLevel& level_for(const MipChain& chain, int width) {
    for (const MipLevel& level : chain.levels)
        if (level.width <= width) return level;
    return chain.levels.back();
}

// --- diffuse: spherical harmonics

using Harmonics = std::array<dvec3, 9>;

/// The real spherical harmonics up to order 2 without their factors.
std::array<double, 9> polynomials(dvec3 d) {
    return {1, d.y, d.z, d.x, d.x * d.y, d.y * d.z, 3 * d.z * d.z - 1, d.x * d.z, d.x * d.x - d.y * d.y};
}

/// Radiance times each polynomial, summed over a row's part of the sphere.
Harmonics sums_of_row(const MipChain& chain, const MipLevel& level, int y, const std::vector<dvec2>& around) {
    const double top = pi * y / level.height, bottom = pi * (y + 1) / level.height, middle = (top + bottom) / 2;
    const double solid_angle = 2 * pi / level.width * (math::cos(top) - math::cos(bottom));
    const double up = math::cos(middle), across = math::sin(middle);
    Harmonics sums{};
    for (int x = 0; x < level.width; ++x) {
        const vec3 c = linear_texel(chain, level, std::size_t(y) * std::size_t(level.width) + std::size_t(x));
        const dvec2 turn = around[std::size_t(x)];
        const auto p = polynomials({across * turn.x, up, across * turn.y});
        for (std::size_t i = 0; i < 9; ++i)
            sums[i] = sums[i] + dvec3{double(c.x), double(c.y), double(c.z)} * (p[i] * solid_angle);
    }
    return sums;
}

std::array<vec3, 9> irradiance_of(const MipChain& chain, Context& context) {
    const MipLevel& level = level_for(chain, widest_for_sums);
    std::vector<dvec2> around;  // x and z of each column's direction
    for (int x = 0; x < level.width; ++x) {
        const double phi = 2 * pi * ((x + 0.5) / level.width - 0.5);
        around.push_back({math::sin(phi), -math::cos(phi)});
    }
    std::vector<Harmonics> rows(static_cast<std::size_t>(level.height));
    context.parallel_for(rows.size(), [&](std::size_t y) { rows[y] = sums_of_row(chain, level, int(y), around); });
    Harmonics sums{};
    for (const Harmonics& row : rows)
        for (std::size_t i = 0; i < 9; ++i) sums[i] = sums[i] + row[i];
    // (A_l / pi) times the square of the harmonic's factor: A_l is pi, 2 pi / 3, pi / 4
    constexpr double flat = 1 / (4 * pi), linear = 2.0 / 3 * 3 / (4 * pi), squared = 0.25 * 15 / (4 * pi);
    constexpr double factors[9] = {flat, linear, linear, linear, squared, squared, squared / 12, squared, squared / 4};
    std::array<vec3, 9> out;
    for (std::size_t i = 0; i < 9; ++i) {
        const dvec3 c = sums[i] * factors[i];
        out[i] = {float(c.x), float(c.y), float(c.z)};
    }
    return out;
}

// --- glossy: octahedral maps

vec3 blend(const vec3& a, const vec3& b, float t) { return a + (b - a) * t; }

/// Bilinear, continuous across the edges of the map.
vec3 filtered(const OctahedralMap& map, dvec2 uv) {
    const float x = float(uv.x) * float(map.size) - 0.5f, y = float(uv.y) * float(map.size) - 0.5f;
    const int x0 = std::clamp(int(std::floor(x)), -1, map.size - 1),
              y0 = std::clamp(int(std::floor(y)), -1, map.size - 1);
    const float tx = x - float(x0), ty = y - float(y0);
    if (x0 >= 0 && y0 >= 0 && x0 + 1 < map.size && y0 + 1 < map.size)
        return blend(blend(map.at(x0, y0), map.at(x0 + 1, y0), tx),
                     blend(map.at(x0, y0 + 1), map.at(x0 + 1, y0 + 1), tx), ty);
    return blend(blend(bordered_texel(map, x0, y0), bordered_texel(map, x0 + 1, y0), tx),
                 blend(bordered_texel(map, x0, y0 + 1), bordered_texel(map, x0 + 1, y0 + 1), tx), ty);
}

vec3 filtered_panorama(const MipChain& chain, const MipLevel& level, dvec2 uv) {
    const double x = uv.x * level.width - 0.5, y = std::clamp(uv.y * level.height - 0.5, 0.0, double(level.height - 1));
    const int x0 = int(std::floor(x)), y0 = int(y), y1 = std::min(y0 + 1, level.height - 1);
    const auto at = [&](int column, int row) {
        const int wrapped = (column % level.width + level.width) % level.width;
        return linear_texel(chain, level, std::size_t(row) * std::size_t(level.width) + std::size_t(wrapped));
    };
    const float tx = float(x - x0), ty = float(y - y0);
    return blend(blend(at(x0, y0), at(x0 + 1, y0), tx), blend(at(x0, y1), at(x0 + 1, y1), tx), ty);
}

OctahedralMap empty_map(int size) { return {size, std::vector<vec3>(std::size_t(size) * std::size_t(size))}; }

dvec3 direction_at(const OctahedralMap& map, std::size_t x, std::size_t y) {
    return octahedral_direction((double(x) + 0.5) / map.size, (double(y) + 0.5) / map.size);
}

template <class Value>
void fill(OctahedralMap& map, Context& context, const Value& value) {
    const auto n = static_cast<std::size_t>(map.size);
    context.parallel_for(n, [&](std::size_t y) {
        for (std::size_t x = 0; x < n; ++x) map.texels[y * n + x] = value(x, y);
    });
}

OctahedralMap half_of(const OctahedralMap& map) {
    OctahedralMap out = empty_map(map.size / 2);
    for (int y = 0; y < out.size; ++y)
        for (int x = 0; x < out.size; ++x) {
            const vec3 sum = (map.at(2 * x, 2 * y) + map.at(2 * x + 1, 2 * y)) +
                             (map.at(2 * x, 2 * y + 1) + map.at(2 * x + 1, 2 * y + 1));
            out.texels[std::size_t(y) * std::size_t(out.size) + std::size_t(x)] = sum * 0.25f;
        }
    return out;
}

/// A sample direction about the normal +Z.
struct LobeSample {
    vec3 to_light;
    float weight;  ///< n.l
    float level;   ///< mip level that matches the solid angle of the sample
};

/// Radical inverse in base 2, [0, 1) (van der Corput 1935).
double radical_inverse(std::uint32_t i) {
    double out = 0, digit = 0.5;
    for (; i != 0; i >>= 1, digit /= 2) out += double(i & 1u) * digit;
    return out;
}

/// Half vectors by the GGX distribution (Walter et al. 2007, eq. 35 and 36) with view = normal; mip levels as in
/// Krivanek & Colbert 2008, "Real-time Shading with Filtered Importance Sampling", eq. 13.
std::vector<LobeSample> lobe_samples(double roughness, int count, int map_size) {
    const double alpha2 = roughness * roughness * roughness * roughness;
    std::vector<LobeSample> out;
    for (int i = 0; i < count; ++i) {
        const double a = (i + 0.5) / count, phi = 2 * pi * radical_inverse(std::uint32_t(i));
        const double cos2 = (1 - a) / (1 + (alpha2 - 1) * a), cosine = std::sqrt(cos2), sine = std::sqrt(1 - cos2);
        const dvec3 h{sine * math::cos(phi), sine * math::sin(phi), cosine};
        const dvec3 l = h * (2 * cosine) - dvec3{0, 0, 1};
        if (!(l.z > 0)) continue;
        const double divisor = cos2 * (alpha2 - 1) + 1, density = alpha2 / (pi * divisor * divisor) / 4;  // of l [1/sr]
        const double sample = 1 / (count * density), texel = 4 * pi / (double(map_size) * map_size);
        const double level = std::max(0.5 * math::log2(sample / texel) - 0.5, 0.0);
        out.push_back({{float(l.x), float(l.y), float(l.z)}, float(l.z), float(level)});
    }
    return out;
}

/// Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
struct Frame {
    dvec3 t, b;
    explicit Frame(dvec3 n) {
        const double sign = n.z < 0 ? -1 : 1, a = -1 / (sign + n.z), c = n.x * n.y * a;
        t = {1 + sign * n.x * n.x * a, sign * c, -sign * n.x};
        b = {c, sign + n.y * n.y * a, -n.y};
    }
};

vec3 mean_of_lobe(const std::vector<OctahedralMap>& halves, const std::vector<LobeSample>& lobe, dvec3 n) {
    const Frame frame(n);
    vec3 sum{0, 0, 0};
    float weights = 0;
    for (const LobeSample& s : lobe) {
        const dvec2 uv =
            octahedral(frame.t * double(s.to_light.x) + frame.b * double(s.to_light.y) + n * double(s.to_light.z));
        const float level = std::min(s.level, float(halves.size() - 1));
        const auto lower = static_cast<std::size_t>(level);
        vec3 light = filtered(halves[lower], uv);
        if (lower + 1 < halves.size()) light = blend(light, filtered(halves[lower + 1], uv), level - float(lower));
        sum = sum + light * s.weight;
        weights += s.weight;
    }
    return sum * (1 / weights);
}

}  // namespace

dvec2 octahedral(dvec3 d) {
    const double scale = 1 / (std::abs(d.x) + std::abs(d.y) + std::abs(d.z));
    double x = d.x * scale, z = d.z * scale;
    if (d.y < 0) {
        const double folded_x = (1 - std::abs(z)) * (x < 0 ? -1 : 1);
        z = (1 - std::abs(x)) * (z < 0 ? -1 : 1);
        x = folded_x;
    }
    return {0.5 + 0.5 * x, 0.5 + 0.5 * z};
}

dvec3 octahedral_direction(double u, double v) {
    double x = 2 * u - 1, z = 2 * v - 1;
    const double y = 1 - std::abs(x) - std::abs(z);
    if (y < 0) {
        const double unfolded_x = (1 - std::abs(z)) * (x < 0 ? -1 : 1);
        z = (1 - std::abs(x)) * (z < 0 ? -1 : 1);
        x = unfolded_x;
    }
    return normalize_or(dvec3{x, y, z}, dvec3{0, 1, 0});
}

dvec2 equirectangular(dvec3 d) {
    return {0.5 + math::atan2(d.x, -d.z) / (2 * pi), math::acos(std::clamp(d.y, -1.0, 1.0)) / pi};
}

dvec3 equirectangular_direction(double u, double v) {
    const double phi = 2 * pi * (u - 0.5), across = math::sin(pi * v);
    return {across * math::sin(phi), math::cos(pi * v), -across * math::cos(phi)};
}

const vec3& bordered_texel(const OctahedralMap& map, int x, int y) {
    const int last = map.size - 1;
    if (x < 0 || x > last) x = std::clamp(x, 0, last), y = last - y;
    if (y < 0 || y > last) y = std::clamp(y, 0, last), x = last - x;
    return map.at(x, y);
}

OctahedralMap sharp_map(const MipChain& panorama, Context& context) {
    const MipLevel& full = panorama.levels[0];
    int size = 16;  // similar angular resolution as the picture
    while (size < largest_map && 2 * size <= full.width) size *= 2;
    const MipLevel& level = level_for(panorama, 2 * size);
    OctahedralMap map = empty_map(size);
    fill(map, context, [&](std::size_t x, std::size_t y) {
        return filtered_panorama(panorama, level, equirectangular(direction_at(map, x, y)));
    });
    return map;
}

EnvironmentLight make_environment_light(const MipChain& panorama, Context& context) {
    EnvironmentLight out;
    out.irradiance = irradiance_of(panorama, context);
    std::vector<OctahedralMap> halves{sharp_map(panorama, context)};
    while (halves.back().size > 4) halves.push_back(half_of(halves.back()));
    out.mirrored.push_back(halves[0]);
    for (int level = 1; level < environment_levels; ++level) {
        const double roughness = double(level) / (environment_levels - 1);
        const auto lobe = lobe_samples(roughness, samples[level], halves[0].size);
        OctahedralMap map = empty_map(std::min(sizes[level], halves[0].size));
        fill(map, context,
             [&](std::size_t x, std::size_t y) { return mean_of_lobe(halves, lobe, direction_at(map, x, y)); });
        out.mirrored.push_back(std::move(map));
    }
    return out;
}

vec3 irradiance_over_pi(const EnvironmentLight& light, vec3 normal) {
    const auto p = polynomials({double(normal.x), double(normal.y), double(normal.z)});
    dvec3 sum{};
    for (std::size_t i = 0; i < 9; ++i) {
        const vec3 c = light.irradiance[i];
        sum = sum + dvec3{double(c.x), double(c.y), double(c.z)} * p[i];
    }
    return {float(sum.x), float(sum.y), float(sum.z)};
}

}  // namespace rakelight
