// SPDX-License-Identifier: Apache-2.0
#include "geometry/weld/position_grid.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace rakelight::geometry {
namespace {

/// A grid whose step is one over a power of a base. The finest level has room for float coordinates of size 1.
struct Base {
    double base;
    int levels;
    std::uint64_t divisor;  // a coordinate uses the last digit if it is no multiple of this
    std::uint32_t least_digits, least_values;
};
constexpr Base decimal{10, 8, 10, 4, 8}, binary{2, 20, 2, 1, 16};

constexpr double float_rounding = 0x1p-24;  // relative
constexpr double coarser_by = 8;            // a step is at least so many float steps at the largest coordinate

double power(double base, int exponent) {
    double p = 1;
    for (int i = 0; i < exponent; ++i) p *= base;
    return p;
}

/// What the coordinates of one mesh, or of several, have in common.
struct Levels {
    double largest = 0;
    int of_decimal = 0, of_binary = 0;  // the coarsest grid that all coordinates are on; its number of levels: none
    void add(const Levels& o) {
        largest = std::max(largest, o.largest);
        of_decimal = std::max(of_decimal, o.of_decimal), of_binary = std::max(of_binary, o.of_binary);
    }
};

bool lies_on(double x, double steps) {
    const double scaled = x * steps;
    return std::fabs(scaled - std::nearbyint(scaled)) <= std::fabs(scaled) * (1.01 * float_rounding);
}
int level_of(double x, const Base& base, int least) {
    double steps = power(base.base, least);
    for (; least < base.levels && !lies_on(x, steps); ++least) steps *= base.base;
    return least;
}

/// Calls body(mesh, x) for the finite coordinates of a chunk's meshes without a known step.
template <class Body>
void for_each_coordinate(const AttributeInput& input, const Chunk& chunk, const Body& body) {
    for_each_range(chunk, input.vertex_base, [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
        if (input.meshes[m].position_step > 0) return;
        for (std::uint32_t v = first; v < last; ++v) {
            const vec3 p = input.meshes[m].positions[v];
            if (!is_finite(p)) continue;
            for (const float x : {p.x, p.y, p.z}) body(m, double(x));
        }
    });
}

std::vector<Levels> levels_of(const AttributeInput& input, const std::vector<Chunk>& chunks, Context& context) {
    std::vector<std::vector<Levels>> found(chunks.size());
    context.parallel_for(chunks.size(), [&](std::size_t c) {
        found[c].resize(chunks[c].mesh_end - chunks[c].mesh_begin);
        for_each_coordinate(input, chunks[c], [&](std::uint32_t m, double x) {
            Levels& l = found[c][m - chunks[c].mesh_begin];
            l.largest = std::max(l.largest, std::fabs(x));
            l.of_decimal = level_of(x, decimal, l.of_decimal);
            l.of_binary = level_of(x, binary, l.of_binary);
        });
    });
    std::vector<Levels> out(input.meshes.size());
    for (std::size_t c = 0; c < chunks.size(); ++c)
        for (std::uint32_t m = chunks[c].mesh_begin; m != chunks[c].mesh_end; ++m)
            out[m].add(found[c][m - chunks[c].mesh_begin]);
    return out;
}

/// Different coordinates as marks in a table, so that neither order nor number matters.
struct Digits {
    static constexpr std::uint64_t table = 4093;  // a prime
    std::array<std::uint64_t, 64> all{}, last{};  // all coordinates but 0; those that use the last digit
    std::uint32_t kinds = 0;                      // bit n: a last digit n

    void add(double x, double steps, const Base& base) {
        const double scaled = std::nearbyint(std::fabs(x * steps));
        if (!(scaled > 0) || scaled > 0x1p52) return;
        const std::uint64_t count = std::uint64_t(scaled), mark = count % table;
        all[mark / 64] |= 1ull << mark % 64;
        if (count % base.divisor == 0) return;
        last[mark / 64] |= 1ull << mark % 64;
        kinds |= 1u << count % base.divisor;
    }
    void add(const Digits& o) {
        for (std::size_t i = 0; i < all.size(); ++i) all[i] |= o.all[i], last[i] |= o.last[i];
        kinds |= o.kinds;
    }
    bool show_rounding(const Base& base) const {
        std::uint32_t different = 0, used = 0;
        for (std::size_t i = 0; i < all.size(); ++i)
            different += std::uint32_t(std::popcount(all[i])), used += std::uint32_t(std::popcount(last[i]));
        return used >= base.least_values && 3 * used >= different &&
               std::uint32_t(std::popcount(kinds)) >= base.least_digits;
    }
};

bool is_coarse(double steps, double largest) { return largest * steps * (2 * float_rounding) * coarser_by <= 1; }

/// Half a step in object space if the coordinates show that they were rounded to the grid, else 0.
/// @param only  the mesh, or all of them if it is no mesh
double grid_error(const AttributeInput& input, const std::vector<Chunk>& chunks, const Base& base, int level,
                  double largest, std::uint32_t only, Context& context) {
    const double steps = power(base.base, level);
    if (level >= base.levels || !is_coarse(steps, largest)) return 0;
    std::vector<Digits> found(chunks.size());
    context.parallel_for(chunks.size(), [&](std::size_t c) {
        if (only < input.meshes.size() && (only < chunks[c].mesh_begin || only >= chunks[c].mesh_end)) return;
        for_each_coordinate(input, chunks[c], [&](std::uint32_t m, double x) {
            if (m == only || only >= input.meshes.size()) found[c].add(x, steps, base);
        });
    });
    Digits digits;
    for (const Digits& some : found) digits.add(some);
    return digits.show_rounding(base) ? 0.5 / steps : 0;
}

double grid_error(const AttributeInput& input, const std::vector<Chunk>& chunks, const Levels& levels,
                  std::uint32_t only, Context& context) {
    const double error = grid_error(input, chunks, decimal, levels.of_decimal, levels.largest, only, context);
    if (error > 0) return error;
    return grid_error(input, chunks, binary, levels.of_binary, levels.largest, only, context);
}

}  // namespace

std::vector<double> position_rounding(const AttributeInput& input, Context& context) {
    constexpr std::uint32_t most_alone = 256;  // meshes that are examined alone
    const std::uint32_t count = std::uint32_t(input.meshes.size());
    const std::vector<Chunk> chunks = make_chunks(input.vertex_base, vertices_per_chunk);
    const std::vector<Levels> levels = levels_of(input, chunks, context);
    Levels all;
    for (const Levels& l : levels) all.add(l);
    const double together = grid_error(input, chunks, all, count, context);
    std::vector<double> out(count);
    for (std::uint32_t m = 0; m < count; ++m) {
        const AttributeMesh& mesh = input.meshes[m];
        double error = 0.5 * mesh.position_step;
        if (!(error > 0)) error = together;
        if (!(error > 0) && count > 1 && count <= most_alone) error = grid_error(input, chunks, levels[m], m, context);
        out[m] = std::max(error, 2 * float_rounding * levels[m].largest) * input.placements[m].scale;
        if (!std::isfinite(out[m])) out[m] = 0;
    }
    return out;
}

}  // namespace rakelight::geometry
