// SPDX-License-Identifier: Apache-2.0
#include "geometry/tangents/tangent_modes.h"

#include "geometry/tangents/mikktspace.h"

namespace rakelight::geometry {
namespace {

void add_mikktspace(std::vector<MeshAttributes>& meshes, const AttributeInput& input, Context& context) {
    std::uint64_t bytes = 0;
    for (std::size_t m = 0; m < meshes.size(); ++m)
        bytes += mikktspace_bytes(meshes[m].normals.size(), input.meshes[m].indices.size() / 3);
    context.memory().check(bytes, "tangents as MikkTSpace");
    context.parallel_for(meshes.size(), [&](std::size_t m) {
        if (!input.meshes[m].texcoords.empty()) give_mikktspace(input.meshes[m], meshes[m]);
    });
}

}  // namespace

void add_tangents(std::vector<MeshAttributes>& meshes, const AttributePlan::Impl& plan, const AttributeInput& input,
                  Context& context) {
    if (plan.options.tangent_mode == TangentMode::mikktspace) add_mikktspace(meshes, input, context);
    if (is_published(plan.options.tangent_mode)) add_published(meshes, plan, input, context);
}

}  // namespace rakelight::geometry
