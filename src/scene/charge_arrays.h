// SPDX-License-Identifier: Apache-2.0
// Arrays that a step of preparing made: charged to the budget as long as somebody holds them.
#pragma once
#include <set>

#include <rakelight/context.h>
#include <rakelight/scene.h>

namespace rakelight {

/// The arrays of the scene's meshes that no charge pays for: the caller's own, made in memory. By Block::identity().
std::set<const void*> unpaid_arrays(const Scene& scene);

/// Charges the arrays of meshes that `made` has and nobody pays for. Who made them has asked the budget for them before.
/// @param own  the caller's, which stay as they are
/// @throws Error bad_file: over the memory budget
void charge_new_arrays(const Scene& made, const std::set<const void*>& own, Context& context);

/// [bytes] of the nodes and meshes themselves: what a copy of the scene takes.
std::uint64_t table_bytes(const Scene& scene);

}  // namespace rakelight
