// SPDX-License-Identifier: Apache-2.0
#include "tools/bench/bench_textures.h"

#include <algorithm>
#include <cmath>

namespace rakelight {
namespace {

constexpr int size = 1024, brick_width = 128, brick_height = 64;  // [texels]
constexpr double joint = 5, bevel = 7;                            // [texels] half a joint, and the slope beside it
constexpr double bump = 6;                                        // [texels] height of a brick above the joint

std::uint32_t hash(std::uint32_t x, std::uint32_t y) {
    std::uint64_t h = (std::uint64_t(y) << 32 | x) * 0x9e3779b97f4a7c15ull;
    h = (h ^ (h >> 29)) * 0xbf58476d1ce4e5b9ull;
    return std::uint32_t(h >> 32);
}

double smooth_step(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// Random numbers 0..1 on a lattice, smoothly between; repeats with the texture.
double noise(int x, int y, int step) {
    const int cells = size / step, cx = x / step, cy = y / step;
    const auto at = [&](int i, int j) {
        return double(hash(std::uint32_t(i % cells), std::uint32_t(j % cells))) * 0x1p-32;
    };
    const double fx = smooth_step(double(x % step) / step), fy = smooth_step(double(y % step) / step);
    const double top = at(cx, cy) + (at(cx + 1, cy) - at(cx, cy)) * fx;
    const double low = at(cx, cy + 1) + (at(cx + 1, cy + 1) - at(cx, cy + 1)) * fx;
    return top + (low - top) * fy;
}

struct Place {
    int brick;      ///< number of the brick
    double height;  ///< 0 in a joint, 1 on a brick
};

Place place(int x, int y) {
    const int row = y / brick_height, shifted = (x + (row % 2) * brick_width / 2) % size;
    const double dx = std::min(shifted % brick_width, brick_width - 1 - shifted % brick_width) + 0.5;
    const double dy = std::min(y % brick_height, brick_height - 1 - y % brick_height) + 0.5;
    return {row * (size / brick_width) + shifted / brick_width, smooth_step((std::min(dx, dy) - joint) / bevel)};
}

double height(int x, int y) {
    x = (x + size) % size;
    y = (y + size) % size;
    return bump * place(x, y).height + 1.5 * noise(x, y, 16) + 0.75 * noise(x, y, 4);
}

Pixels empty() {
    Pixels p;
    p.width = p.height = size;
    p.channels = 3;
    p.bytes.resize(p.row_bytes() * size);
    return p;
}

void put(Pixels& pixels, int x, int y, double r, double g, double b) {
    std::byte* const to = pixels.row(y) + std::size_t(3 * x);
    int c = 0;
    for (const double value : {r, g, b}) to[c++] = std::byte(int(std::clamp(value, 0.0, 1.0) * 255 + 0.5));
}

}  // namespace

BenchTextures make_bench_textures() {
    BenchTextures made{empty(), empty()};
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const Place p = place(x, y);
            const double tint = 0.78 + 0.22 * double(hash(std::uint32_t(p.brick), 77) >> 16) / 65535;
            const double grain = 0.9 + 0.1 * noise(x, y, 4);
            const double gray = grain * (0.55 + (tint - 0.55) * p.height);
            put(made.color, x, y, gray, gray * (1 - 0.06 * p.height), gray * (1 - 0.12 * p.height));
            // Rows go down and green is up: a height that grows downwards leans the normal up.
            const double dx = 0.5 * (height(x + 1, y) - height(x - 1, y)),
                         dy = 0.5 * (height(x, y + 1) - height(x, y - 1));
            const double scale = 0.5 / std::sqrt(dx * dx + dy * dy + 1);
            put(made.normal, x, y, 0.5 - dx * scale, 0.5 + dy * scale, 0.5 + scale);
        }
    return made;
}

namespace {

ImageHandle image(const char* name, Pixels pixels) {
    auto made = std::make_shared<EncodedImage>();
    made->name = name;
    made->decode = [kept = std::make_shared<const Pixels>(std::move(pixels))](const EncodedImage&, Context&) {
        return *kept;
    };
    return made;
}

}  // namespace

std::vector<Texture> make_bench_wall() {
    BenchTextures textures = make_bench_textures();
    return {{"bricks, color", image("bricks-color", std::move(textures.color)), {}},
            {"bricks, normal", image("bricks-normal", std::move(textures.normal)), {}}};
}

}  // namespace rakelight
