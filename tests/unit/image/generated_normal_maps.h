// SPDX-License-Identifier: Apache-2.0
// Green-up normal maps as generators and bakers make them, and pictures of no height field: what guesses about maps are
// measured on.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <rakelight/math/vector.h>

namespace rakelight::test {

/// Slopes of a height along u and upwards.
struct TexelSlope {
    double p = 0, q = 0;
};

struct NormalCodes {
    std::string name;
    int size = 0;
    std::vector<std::uint32_t> texels;  ///< [size * size]
    bool is_field = true;               ///< of a height field, so that it can be told which way green points
};

inline std::uint32_t normal_code(TexelSlope s, bool green_down = false) {
    const double length = std::sqrt(s.p * s.p + s.q * s.q + 1);
    const double n[3] = {-s.p / length, (green_down ? s.q : -s.q) / length, 1 / length};
    std::uint32_t code = 0xff000000u;
    for (int k = 0; k < 3; ++k) code |= std::uint32_t(std::lround((n[k] * 0.5 + 0.5) * 255)) << (8 * k);
    return code;
}

inline NormalCodes codes_of(std::string name, int size, const std::function<TexelSlope(int, int)>& slope,
                            bool is_field = true) {
    NormalCodes c{std::move(name), size, {}, is_field};
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) c.texels.push_back(normal_code(slope(x, y)));
    return c;
}

/// The same with green turned round.
inline NormalCodes turned_green(NormalCodes c) {
    for (std::uint32_t& t : c.texels) t = (t & 0xffff00ffu) | (255 - (t >> 8 & 255u)) << 8;
    return c;
}

/// How a height map is made into slopes.
enum class Stencil : std::uint8_t { central, forward, sobel };
inline const char* name_of(Stencil s) {
    return s == Stencil::central ? "central" : s == Stencil::forward ? "forward" : "sobel";
}

/// Heights [0..1] of a tile, in `levels` steps; 0: as they are.
inline NormalCodes from_heights(std::string name, int size, const std::function<double(int, int)>& height, double depth,
                                Stencil stencil, int levels = 0) {
    std::vector<double> h;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const double value = height(x, y);
            h.push_back(levels > 0 ? std::round(value * levels) / levels : value);
        }
    const auto at = [&](int x, int y) { return h[std::size_t((y + size) % size * size + (x + size) % size)] * depth; };
    name += std::string(" by ") + name_of(stencil) + (levels > 0 ? " of 8 bits" : "");
    return codes_of(name, size, [&](int x, int y) -> TexelSlope {
        switch (stencil) {
            case Stencil::central:
                return {(at(x + 1, y) - at(x - 1, y)) / 2, (at(x, y - 1) - at(x, y + 1)) / 2};
            case Stencil::forward:
                return {at(x + 1, y) - at(x, y), at(x, y) - at(x, y + 1)};
            case Stencil::sobel:
                break;
        }
        TexelSlope s;
        for (int k = -1; k <= 1; ++k) {
            s.p += (2 - std::abs(k)) * (at(x + 1, y + k) - at(x - 1, y + k)) / 8;
            s.q += (2 - std::abs(k)) * (at(x + k, y - 1) - at(x + k, y + 1)) / 8;
        }
        return s;
    });
}

/// Numbers of 0..1 that a place alone decides.
inline double noise_at(int x, int y, int seed) {
    auto h = std::uint32_t(x) * 0x9e3779b1u ^ std::uint32_t(y) * 0x85ebca77u ^ std::uint32_t(seed) * 0xc2b2ae3du;
    h = (h ^ h >> 15) * 0x2c1b3c6du, h = (h ^ h >> 12) * 0x297a2d39u;
    return double((h ^ h >> 15) & 0xffffffu) / 0x1000000;
}

/// Smooth noise of a lattice that wraps round.
inline double smooth_noise(int x, int y, int size, int cells, int seed) {
    const double u = double(x) * cells / size, v = double(y) * cells / size;
    const int i = int(u), j = int(v);
    const auto ease = [](double t) { return t * t * (3 - 2 * t); };
    const double a = ease(u - i), b = ease(v - j);
    const auto at = [&](int dx, int dy) { return noise_at((i + dx) % cells, (j + dy) % cells, seed); };
    return (at(0, 0) * (1 - a) + at(1, 0) * a) * (1 - b) + (at(0, 1) * (1 - a) + at(1, 1) * a) * b;
}

/// A place in a wall of 8 rows of 4 bricks.
struct BrickPlace {
    int row, column;
    double left, top, right, bottom;  ///< [rows] to the brick's borders
};
inline BrickPlace brick_at(int x, int y, int size) {
    const double v = 8 * (y + 0.5) / size;
    const int row = int(v);
    const double u = 4 * (x + 0.5) / size + 0.5 * (row % 2);
    const int column = int(u);
    return {row, column % 4, 2 * (u - column), v - row, 2 - 2 * (u - column), 1 - (v - row)};
}

inline double brick_height(int x, int y, int size, double grain) {
    const BrickPlace b = brick_at(x, y, size);
    const double t = std::clamp((std::min({b.left, b.top, b.right, b.bottom}) - 0.08) / 0.1, 0.0, 1.0);
    return 0.9 * t * t * (3 - 2 * t) + grain * noise_at(x, y, 7);
}

/// Slopes of each direction by themselves, as an artist paints them: p by the distance to the left and right border,
/// q by that to the upper and lower one. In the corners this is no height field.
inline TexelSlope painted_brick(int x, int y, int size, double strength) {
    const BrickPlace b = brick_at(x, y, size);
    const auto edge = [](double d) { return std::max(0.0, 1 - d / 0.12); };
    return {strength * (edge(b.left) - edge(b.right)), strength * (edge(b.bottom) - edge(b.top))};
}

/// Flat bricks, each of a lean of its own.
inline TexelSlope leaning_brick(int x, int y, int size, int seed) {
    const BrickPlace b = brick_at(x, y, size);
    if (std::min({b.left, b.top, b.right, b.bottom}) < 0.08) return {};
    return {noise_at(b.column, b.row, seed) - 0.5, noise_at(b.column, b.row, seed + 1) - 0.5};
}

inline void add_height_fields(int size, std::vector<NormalCodes>& to) {
    const auto fractal = [size](int x, int y) {
        return 0.5 * smooth_noise(x, y, size, 4, 1) + 0.3 * smooth_noise(x, y, size, 8, 2) +
               0.2 * smooth_noise(x, y, size, 16, 3);
    };
    const auto domes = [size](int x, int y) {
        const double u = std::fmod(6.0 * x / size, 1.0) - 0.5, v = std::fmod(6.0 * y / size, 1.0) - 0.5;
        return std::sqrt(std::max(0.0, 0.16 - u * u - v * v)) * 2.5;
    };
    const auto weave = [size](int x, int y) {
        const double a = std::sin(2 * pi * 8 * x / size), b = std::sin(2 * pi * 8 * y / size);
        return 0.5 + 0.25 * (a * a * b - b * b * a);
    };
    for (const Stencil stencil : {Stencil::central, Stencil::forward, Stencil::sobel})
        for (const double depth : {1.0, 8.0})
            for (const int levels : {0, 255}) {
                const std::string deep = depth > 1 ? "deep " : "shallow ", of = " " + std::to_string(size);
                for (const double grain : {0.0, 0.04, 0.3})
                    to.push_back(from_heights(
                        deep + "bricks, grain " + std::to_string(grain).substr(0, 4) + of, size,
                        [=](int x, int y) { return brick_height(x, y, size, grain); }, depth, stencil, levels));
                to.push_back(from_heights(deep + "noise" + of, size, fractal, depth, stencil, levels));
                to.push_back(from_heights(deep + "domes" + of, size, domes, depth, stencil, levels));
                to.push_back(from_heights(deep + "weave" + of, size, weave, depth, stencil, levels));
            }
}

/// What is painted or scanned without a height field behind it: nobody can tell which way its green points.
inline void add_others(int size, std::vector<NormalCodes>& to) {
    const std::string of = " " + std::to_string(size);
    for (const double strength : {0.2, 1.0, 3.0})
        to.push_back(codes_of(
            "painted bricks, " + std::to_string(strength).substr(0, 3) + of, size,
            [=](int x, int y) { return painted_brick(x, y, size, strength); }, false));
    for (int seed = 0; seed < 8; ++seed) {
        to.push_back(codes_of(
            "leaning bricks " + std::to_string(seed) + of, size,
            [=](int x, int y) { return leaning_brick(x, y, size, seed); }, false));
        to.push_back(codes_of(
            "random normals " + std::to_string(seed) + of, size,
            [=](int x, int y) {
                return TexelSlope{noise_at(x, y, seed) - 0.5, noise_at(x, y, seed + 50) - 0.5};
            },
            false));
        to.push_back(codes_of(
            "smooth random normals " + std::to_string(seed) + of, size,
            [=](int x, int y) {
                return TexelSlope{2 * smooth_noise(x, y, size, 8, seed) - 1,
                                  2 * smooth_noise(x, y, size, 8, seed + 50) - 1};
            },
            false));
        to.push_back(codes_of(  // slopes along the contours of a height: brushed or combed
            "combed noise " + std::to_string(seed) + of, size,
            [=](int x, int y) {
                const auto h = [&](int dx, int dy) {
                    return smooth_noise((x + dx + size) % size, (y + dy + size) % size, size, 8, seed);
                };
                return TexelSlope{4 * (h(0, -1) - h(0, 1)), 4 * (h(-1, 0) - h(1, 0))};
            },
            false));
    }
}

inline std::vector<NormalCodes> generated_normal_maps() {
    std::vector<NormalCodes> all;
    for (const int size : {64, 256}) {
        add_height_fields(size, all);
        add_others(size, all);
    }
    return all;
}

}  // namespace rakelight::test
