// SPDX-License-Identifier: Apache-2.0
#include "tools/bench/bench_model.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "math/functions.h"

namespace rakelight {
namespace {

constexpr double roughness = 0.25;  // of the grid's step

struct Grid {
    std::uint32_t rows, columns;
    std::vector<double> sin_a, cos_a, sin_b, cos_b;

    double waved = -1;  ///< share of the rows that have waves, if not negative; else the heights are random

    Grid(std::uint32_t r, std::uint32_t c) : rows(r), columns(c) {
        for (std::uint32_t i = 0; i < columns; ++i) {
            sin_a.push_back(math::sin(2 * pi * i / columns));
            cos_a.push_back(math::cos(2 * pi * i / columns));
        }
        for (std::uint32_t i = 0; i <= rows; ++i) {
            sin_b.push_back(math::sin(pi * (i + 1) / (rows + 2)));
            cos_b.push_back(math::cos(pi * (i + 1) / (rows + 2)));
        }
    }
    // A hash of the place, so every part finds the same.
    double random_height(std::uint32_t row, std::uint32_t c) const {
        std::uint64_t h = (std::uint64_t(row) << 32 | c) * 0x9e3779b97f4a7c15ull;
        h = (h ^ (h >> 29)) * 0xbf58476d1ce4e5b9ull;
        return roughness * double(h >> 11) * 0x1p-53;
    }
    double wave_height(std::uint32_t row, std::uint32_t c) const {
        if (row > waved * rows) return 0;
        const double waves = std::max(1.0, std::floor(columns / 24.0));
        return math::sin(2 * pi * (c * waves / columns + row / 35.0)) * math::sin(2 * pi * row / 24.0);
    }
    vec3 position(std::uint32_t row, std::uint32_t column) const {
        const std::uint32_t c = column % columns;
        const double size = 1 + pi / rows * (waved < 0 ? random_height(row, c) : wave_height(row, c));
        return {float(size * sin_b[row] * cos_a[c]), float(-size * cos_b[row]), float(-size * sin_b[row] * sin_a[c])};
    }
};

struct Patch {
    std::uint32_t row_begin, row_end, column_begin, column_end;
};

BenchPart make_part(const Grid& grid, Patch p) {
    BenchPart part;
    const std::uint32_t width = p.column_end - p.column_begin + 1, height = p.row_end - p.row_begin + 1;
    part.positions.reserve(std::size_t(width) * height);
    part.texcoords.reserve(std::size_t(width) * height);
    for (std::uint32_t r = p.row_begin; r <= p.row_end; ++r)
        for (std::uint32_t c = p.column_begin; c <= p.column_end; ++c) {
            part.positions.push_back(grid.position(r, c));
            part.texcoords.push_back({float(c) / float(grid.columns), 1 - float(r) / float(grid.rows)});
        }
    part.indices.reserve(std::size_t(6) * (width - 1) * (height - 1));
    for (std::uint32_t r = 0; r + 1 < height; ++r)
        for (std::uint32_t c = 0; c + 1 < width; ++c) {
            const std::uint32_t a = r * width + c, d = a + width;
            for (const std::uint32_t v : {a, a + 1, d + 1, a, d + 1, d}) part.indices.push_back(v);
        }
    return part;
}

void shuffle(BenchPart& part, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::vector<std::uint32_t> order(part.positions.size());
    std::iota(order.begin(), order.end(), 0u);
    std::shuffle(order.begin(), order.end(), random);
    BenchPart mixed;
    mixed.positions.resize(order.size());
    mixed.texcoords.resize(order.size());
    for (std::size_t v = 0; v < order.size(); ++v) {
        mixed.positions[order[v]] = part.positions[v];
        mixed.texcoords[order[v]] = part.texcoords[v];
    }
    for (std::uint32_t& v : part.indices) v = order[v];
    order.resize(part.indices.size() / 3);
    std::iota(order.begin(), order.end(), 0u);
    std::shuffle(order.begin(), order.end(), random);
    for (const std::uint32_t t : order)
        mixed.indices.insert(mixed.indices.end(),
                             {part.indices[3 * std::size_t(t)], part.indices[3 * std::size_t(t) + 1],
                              part.indices[3 * std::size_t(t) + 2]});
    part = std::move(mixed);
}

}  // namespace

std::uint64_t BenchModel::triangles() const {
    std::uint64_t sum = 0;
    for (const BenchPart& p : parts) sum += p.indices.size() / 3;
    return sum;
}
std::uint64_t BenchModel::vertices() const {
    std::uint64_t sum = 0;
    for (const BenchPart& p : parts) sum += p.positions.size();
    return sum;
}

std::vector<AttributeMesh> BenchModel::meshes(bool textured) const {
    std::vector<AttributeMesh> all;
    for (const BenchPart& p : parts) {
        AttributeMesh& mesh = all.emplace_back();
        mesh.object = std::uint32_t(all.size() - 1);
        mesh.positions = p.positions;
        mesh.indices = p.indices;
        if (textured) mesh.texcoords = p.texcoords;
    }
    return all;
}

static Grid grid_of(std::uint64_t triangles) {
    const std::uint32_t rows = std::max(2u, std::uint32_t(std::sqrt(double(triangles) / 4)));
    return {rows, 2 * rows};
}

static BenchModel sphere_of(const Grid& grid, std::uint32_t parts, bool shuffled) {
    const std::uint32_t rows = grid.rows, columns = grid.columns;
    BenchModel model;
    model.grid_step = pi / rows;
    const std::uint32_t bands = std::min(parts, std::max(1u, rows / 4));
    for (std::uint32_t band = 0; band < bands; ++band) {
        const auto share = [](std::uint64_t count, std::uint32_t i, std::uint32_t n) {
            return std::uint32_t(count * i / n);
        };
        const std::uint32_t pieces = share(parts, band + 1, bands) - share(parts, band, bands);
        for (std::uint32_t i = 0; i < pieces; ++i) {
            model.parts.push_back(make_part(grid, {share(rows, band, bands), share(rows, band + 1, bands),
                                                   share(columns, i, pieces), share(columns, i + 1, pieces)}));
            if (shuffled) shuffle(model.parts.back(), std::uint32_t(model.parts.size()));
        }
    }
    return model;
}

BenchModel make_bench_sphere(std::uint64_t triangles, std::uint32_t parts, bool shuffled) {
    return sphere_of(grid_of(triangles), parts, shuffled);
}

BenchModel make_waved_sphere(std::uint64_t triangles, std::uint32_t parts, double share) {
    Grid grid = grid_of(triangles);
    grid.waved = share;
    return sphere_of(grid, parts, false);
}

BenchModel make_uneven_sphere(std::uint64_t triangles, std::uint32_t parts) {
    // A band of all rows' share has rows * columns * 2 triangles, with twice the base's columns on average.
    const std::uint32_t rows = std::max(2 * parts, std::uint32_t(std::sqrt(double(triangles) / 4))),
                        columns = std::max<std::uint32_t>(3, std::uint32_t(double(triangles) / (4.0 * rows)));
    BenchModel model;
    model.grid_step = 2 * pi / columns;
    const auto ripple = [](double a, double b) { return 1 + 0.02 * math::sin(5 * a) * math::sin(7 * b); };
    for (std::uint32_t band = 0; band < parts; ++band) {
        const std::uint32_t own = columns * (1 + band % 3), high = std::max(1u, rows / parts);
        const double from = pi * (0.02 + 0.96 * band / parts) + model.grid_step / 8,
                     to = pi * (0.02 + 0.96 * (band + 1) / parts);
        BenchPart& part = model.parts.emplace_back();
        for (std::uint32_t r = 0; r <= high; ++r)
            for (std::uint32_t c = 0; c <= own; ++c) {
                const double a = 2 * pi * (c % own) / own, b = from + (to - from) * r / high, size = ripple(a, b);
                part.positions.push_back({float(size * math::sin(b) * math::cos(a)), float(-size * math::cos(b)),
                                          float(-size * math::sin(b) * math::sin(a))});
                part.texcoords.push_back({float(c) / float(own), float(b / pi)});
            }
        for (std::uint32_t r = 0; r < high; ++r)
            for (std::uint32_t c = 0; c < own; ++c) {
                const std::uint32_t v = r * (own + 1) + c, d = v + own + 1;
                for (const std::uint32_t i : {v, v + 1, d + 1, v, d + 1, d}) part.indices.push_back(i);
            }
    }
    return model;
}

}  // namespace rakelight
