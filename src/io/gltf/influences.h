// SPDX-License-Identifier: Apache-2.0
// Skin influences of vertices: the eight strongest of all sets, with weights that sum to 1.
#pragma once
#include <cstdint>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

#include "io/gltf/vertex_data.h"

namespace rakelight::io::gltf {

struct Influences {
    Block<JointInfluence> first, next;  ///< Mesh::influences, Mesh::more_influences
};

/// JOINTS_n and WEIGHTS_n.
struct InfluenceSet {
    std::vector<std::uint32_t> joints;  ///< [V * 4]
    std::vector<float> weights;         ///< [V * 4]
    MemoryCharge charge;
};

/// Vertices with more than eight joints; with negative or non-finite weights; whose weights do not sum to 1; sum to 0.
struct InfluenceFaults {
    std::uint64_t surplus = 0, bad_weights = 0, bad_sums = 0, no_sums = 0;
};

/// Of all sets of a primitive, which are not empty.
/// @throws Error bad_file: over the memory budget
Influences strongest_influences(const std::vector<InfluenceSet>& sets, InfluenceFaults& faults, Context& context);

/// JOINTS_n and WEIGHTS_n of a primitive as [V] influences, empty where it has none, and where no vertex has more
/// than four. Joints of weight 0 become 0. Says
/// in the report where a vertex had more than eight, and where weights were negative, not finite, or did not sum to 1.
/// @throws Error: one of a pair is missing, wrong types or counts.
Influences read_influences(VertexData& vertices, const Document& document, const Value& primitive);

/// One more than the largest joint that counts; 0 for none.
std::uint32_t joints_used(const Mesh& mesh);

}  // namespace rakelight::io::gltf
