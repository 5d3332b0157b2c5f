// SPDX-License-Identifier: Apache-2.0
// Copies of a mesh share the table of its morph targets; one that is to have other targets gets a table of its own.
#pragma once
#include <cstddef>
#include <utility>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

#include "scene/charge_arrays.h"

namespace rakelight {

/// Calls change(target, number) for each target of a new table. The table and its new arrays are charged.
/// @throws Error bad_file: over the memory budget
template <class Change>
void change_targets(Mesh& mesh, const Change& change, Context& context) {
    if (mesh.targets.empty()) return;
    const Block<MorphTarget> before = mesh.targets;
    MemoryCharge charge(context.memory(), table_bytes(before.span()), "morph targets");
    std::vector<MorphTarget> targets(before.begin(), before.end());
    for (std::size_t t = 0; t < targets.size(); ++t) {
        change(targets[t], t);
        const auto pay = [&](const Block<vec3>& made, const Block<vec3>& was) {
            if (made == was || made.is_charged()) return;
            made.attach_charge(
                MemoryCharge(context.memory(), made.size() * sizeof(vec3) + bytes_beside_array, "morph targets"));
        };
        pay(targets[t].positions, before[t].positions);
        pay(targets[t].normals, before[t].normals);
        pay(targets[t].tangents, before[t].tangents);
    }
    mesh.targets = {std::move(targets), std::move(charge)};
}

}  // namespace rakelight
