// SPDX-License-Identifier: Apache-2.0
// Which placements of meshes are computed, and which share the result of another.
#pragma once
#include <vector>

#include <rakelight/scene/scene.h>

#include "prepare/normals/smooth_scene.h"
#include "prepare/variants.h"

namespace rakelight {

/// The placements that are computed, and for each placement which of them has its result.
struct SmoothSelection {
    std::vector<Instance> instances;
    std::vector<std::size_t> result_of;  ///< [instances] into `computed`
    std::vector<std::size_t> computed;   ///< into `instances`
    /// Placements whose normals are kept, and which those that are made may meet.
    std::vector<Instance> beside;
    /// [computed, then beside] at its place in the world, else about its own origin
    std::vector<bool> in_world;

    /// [computed, then beside]
    std::vector<Instance> inputs() const;
};

/// Moves, turns, mirrors and scales evenly (to nine digits), so that angles stay.
bool is_similarity(const dmat4& m);

/// @param world [nodes] placements
SmoothSelection select_instances(const Scene& scene, const SmoothRequest& request, const std::vector<dmat4>& world);

}  // namespace rakelight
