// SPDX-License-Identifier: Apache-2.0
// Morph targets: offsets times weights upon vertices and their directions. Spans in, spans out; no scene.
#pragma once
#include <span>

#include <rakelight/context.h>
#include <rakelight/vector.h>

namespace rakelight::geometry {

/// Offsets of one target, [V] or empty, and how much of them counts.
struct WeightedTarget {
    float weight = 0;
    std::span<const vec3> offsets{};
};

/// out = base + sum of weight * offset, in the order of the targets (glTF 2.0, section 3.7.2.2). The same bits for any
/// number of threads.
void morph_positions(std::span<const vec3> base, std::span<const WeightedTarget> targets, std::span<vec3> out,
                     Context& context);
/// The same bits for `out.size()` vertices from `first` on, by the calling thread.
void morph_some_positions(std::span<const vec3> base, std::span<const WeightedTarget> targets, std::size_t first,
                          std::span<vec3> out);
/// As morph_positions(), of length 1 after; where the sum vanishes, as `base`.
void morph_normals(std::span<const vec3> base, std::span<const WeightedTarget> targets, std::span<vec3> out,
                   Context& context);
/// xyz as morph_normals(), w as `base`.
void morph_tangents(std::span<const vec4> base, std::span<const WeightedTarget> targets, std::span<vec4> out,
                    Context& context);

}  // namespace rakelight::geometry
