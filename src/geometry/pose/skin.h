// SPDX-License-Identifier: Apache-2.0
// Linear blend skinning of positions, normals and tangents. Spans in, spans out; no scene.
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include <rakelight/base/context.h>
#include <rakelight/math/joint_influence.h>
#include <rakelight/math/vector.h>

namespace rakelight::geometry {

/// Joint matrices in the kernels' layout: the columns of an affine matrix, w unused.
struct alignas(16) JointColumns {
    std::array<std::array<float, 4>, 4> columns;
};

/// Of an affine matrix.
JointColumns columns_of(const dmat4& m);

/// Input vertices: arrays of [V], or empty.
struct SkinInput {
    std::span<const vec3> positions{}, normals{};
    std::span<const vec4> tangents{};
    std::span<const JointInfluence> influences{}, more_influences{};  ///< `influences` is required
    std::span<const JointColumns> joints{};                           ///< joints of all influences with weight > 0
};

/// Output vertices: same sizes as the input, not overlapping it.
struct SkinOutput {
    std::span<vec3> positions{}, normals{};
    std::span<vec4> tangents{};
};

/// Each vertex by the sum of its joints' matrices times their weights (Magnenat-Thalmann, Laperriere, Thalmann 1988,
/// "Joint-Dependent Local Deformations for Hand Animation and Object Grasping"); vertices with zero weights follow the
/// first joint. Normals are transformed by the cofactor of the blended matrix, tangents by the matrix; both are
/// normalized, and w is negated if the blended matrix mirrors. Vanishing directions are not changed. Bit-identical for
/// any number of threads and instruction set.
void skin_vertices(const SkinInput& in, const SkinOutput& out, Context& context);
/// Bit-identical, on the calling thread.
void skin_some_vertices(const SkinInput& in, const SkinOutput& out);

}  // namespace rakelight::geometry
