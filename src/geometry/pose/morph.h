// SPDX-License-Identifier: Apache-2.0
// Morph targets: weighted offsets of positions, normals and tangents. Spans in, spans out; no scene.
#pragma once
#include <span>

#include <rakelight/base/context.h>
#include <rakelight/math/vector.h>

namespace rakelight::geometry {

/// Offsets of one target, [V] or empty, and its weight.
struct WeightedTarget {
    float weight = 0;
    std::span<const vec3> offsets{};
};

/// out = base + sum of weight * offset, in the order of the targets (glTF 2.0, section 3.7.2.2). Bit-identical for any
/// number of threads.
void morph_positions(std::span<const vec3> base, std::span<const WeightedTarget> targets, std::span<vec3> out,
                     Context& context);
/// Bit-identical for `out.size()` vertices from `first` on, on the calling thread.
void morph_some_positions(std::span<const vec3> base, std::span<const WeightedTarget> targets, std::size_t first,
                          std::span<vec3> out);
/// As morph_positions(), then normalized; `base` if the sum vanishes.
void morph_normals(std::span<const vec3> base, std::span<const WeightedTarget> targets, std::span<vec3> out,
                   Context& context);
/// xyz as morph_normals(), w as `base`.
void morph_tangents(std::span<const vec4> base, std::span<const WeightedTarget> targets, std::span<vec4> out,
                    Context& context);

}  // namespace rakelight::geometry
