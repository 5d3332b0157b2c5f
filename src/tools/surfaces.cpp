// SPDX-License-Identifier: Apache-2.0
#include "tools/surfaces.h"

#include <algorithm>

#include "math/linear.h"
#include "prepare/bind_pose.h"
#include "prepare/smooth_request.h"

namespace rakelight {

Surfaces collect_surfaces(const Scene& scene, std::span<const std::uint32_t> objects) {
    const std::vector<dmat4> world = bind_pose_matrices(scene);
    Surfaces out;
    out.parts = drawn_instances(scene);
    for (const Instance& part : out.parts) {
        const Mesh& mesh = scene.meshes[part.mesh];
        AttributeMesh& m = out.meshes.emplace_back();
        m.object = std::uint32_t(std::lower_bound(objects.begin(), objects.end(), part.node) - objects.begin());
        m.positions = mesh.positions;
        m.indices = mesh.indices;
        m.normals = mesh.normals;
        const std::uint32_t set = tangent_set(scene, mesh, TangentWish::everywhere);
        if (set != none) m.texcoords = mesh.texcoords[set];
        m.smoothing = mesh.smoothing;
        if (!mesh.smoothing.empty())
            m.group_kind = mesh.smoothing_kind == SmoothingKind::masks ? GroupKind::masks : GroupKind::numbers;
        m.smoothing_hint = mesh.smoothing_hint;
        m.position_step = mesh.position_step;
        m.to_world = world[part.node] * translation(mesh.origin);
    }
    return out;
}

}  // namespace rakelight
