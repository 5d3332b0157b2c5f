// SPDX-License-Identifier: Apache-2.0
#include "geometry/pose/morph.h"

#include <algorithm>
#include <array>

#include "math/linear.h"

namespace rakelight::geometry {
namespace {

constexpr std::size_t chunk = 1024;  // vertices at a time: their sums stay in the cache from target to target

/// Sums component by component, target by target, in loops that the compiler vectorizes.
void add_offsets(std::span<const WeightedTarget> targets, std::size_t first, std::span<vec3> sums) {
    static_assert(sizeof(vec3) == 3 * sizeof(float));
    for (const WeightedTarget& t : targets) {
        const float weight = t.weight;
        float* const to = &sums[0].x;
        const float* const from = &t.offsets[first].x;
        for (std::size_t i = 0; i < 3 * sums.size(); ++i) to[i] += from[i] * weight;
    }
}

/// Calls finish(first, sums) for chunks of vertices.
/// @param start (first vertex, floats) writes the initial values of the sums
template <class Start, class Finish>
void sum_up(std::size_t count, std::span<const WeightedTarget> targets, Context& context, const Start& start,
            const Finish& finish) {
    context.parallel_for((count + chunk - 1) / chunk, [&](std::size_t c) {
        const std::size_t first = c * chunk, vertices = std::min(chunk, count - first);
        std::array<vec3, chunk> sums;
        start(first, std::span(sums).first(vertices));
        add_offsets(targets, first, std::span(sums).first(vertices));
        finish(first, std::span<const vec3>(sums).first(vertices));
    });
}

/// Initial values of the sums.
auto copying(std::span<const vec3> base) {
    return [base](std::size_t first, std::span<vec3> sums) {
        std::copy_n(base.begin() + std::ptrdiff_t(first), sums.size(), sums.begin());
    };
}

}  // namespace

void morph_positions(std::span<const vec3> base, std::span<const WeightedTarget> targets, std::span<vec3> out,
                     Context& context) {
    sum_up(base.size(), targets, context, copying(base), [&](std::size_t first, std::span<const vec3> sums) {
        std::ranges::copy(sums, out.begin() + std::ptrdiff_t(first));
    });
}

void morph_some_positions(std::span<const vec3> base, std::span<const WeightedTarget> targets, std::size_t first,
                          std::span<vec3> out) {
    std::copy_n(base.begin() + std::ptrdiff_t(first), out.size(), out.begin());
    add_offsets(targets, first, out);
}

void morph_normals(std::span<const vec3> base, std::span<const WeightedTarget> targets, std::span<vec3> out,
                   Context& context) {
    sum_up(base.size(), targets, context, copying(base), [&](std::size_t first, std::span<const vec3> sums) {
        for (std::size_t i = 0; i < sums.size(); ++i) out[first + i] = normalize_or(sums[i], base[first + i]);
    });
}

void morph_tangents(std::span<const vec4> base, std::span<const WeightedTarget> targets, std::span<vec4> out,
                    Context& context) {
    sum_up(
        base.size(), targets, context,
        [&](std::size_t first, std::span<vec3> sums) {
            for (std::size_t i = 0; i < sums.size(); ++i) sums[i] = base[first + i].xyz();
        },
        [&](std::size_t first, std::span<const vec3> sums) {
            for (std::size_t i = 0; i < sums.size(); ++i) {
                const vec3 t = normalize_or(sums[i], base[first + i].xyz());
                out[first + i] = {t.x, t.y, t.z, base[first + i].w};
            }
        });
}

}  // namespace rakelight::geometry
