// SPDX-License-Identifier: Apache-2.0
#include "geometry/morph.h"

#include <algorithm>

#include "math/linear.h"

namespace rakelight::geometry {
namespace {

constexpr std::size_t chunk = 4096;  // vertices at a time

/// Calls f(v, sum) for every vertex. @param start  of the sum at a vertex
template <class Start, class Finish>
void sum_up(std::size_t count, std::span<const WeightedTarget> targets, Context& context, const Start& start,
            const Finish& finish) {
    context.parallel_for((count + chunk - 1) / chunk, [&](std::size_t c) {
        for (std::size_t v = c * chunk; v < std::min(count, (c + 1) * chunk); ++v) {
            vec3 sum = start(v);
            for (const WeightedTarget& t : targets) sum += t.offsets[v] * t.weight;
            finish(v, sum);
        }
    });
}

}  // namespace

void morph_positions(std::span<const vec3> base, std::span<const WeightedTarget> targets, std::span<vec3> out,
                     Context& context) {
    sum_up(
        base.size(), targets, context, [&](std::size_t v) { return base[v]; },
        [&](std::size_t v, vec3 sum) { out[v] = sum; });
}

void morph_normals(std::span<const vec3> base, std::span<const WeightedTarget> targets, std::span<vec3> out,
                   Context& context) {
    sum_up(
        base.size(), targets, context, [&](std::size_t v) { return base[v]; },
        [&](std::size_t v, vec3 sum) { out[v] = normalize_or(sum, base[v]); });
}

void morph_tangents(std::span<const vec4> base, std::span<const WeightedTarget> targets, std::span<vec4> out,
                    Context& context) {
    sum_up(
        base.size(), targets, context, [&](std::size_t v) { return base[v].xyz(); },
        [&](std::size_t v, vec3 sum) {
            const vec3 t = normalize_or(sum, base[v].xyz());
            out[v] = {t.x, t.y, t.z, base[v].w};
        });
}

}  // namespace rakelight::geometry
