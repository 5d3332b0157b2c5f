// SPDX-License-Identifier: Apache-2.0
#include "tools/surfaces.h"

#include <algorithm>

#include "math/linear.h"
#include "prepare/bind_pose.h"
#include "prepare/smooth_request.h"

namespace rakelight {
namespace {

NormalRule rule_of(const Scene& scene, const Mesh& mesh, NormalSource source) {
    NormalRule rule = normal_rule(scene, mesh, source);
    if (source == NormalSource::automatic && !mesh.normal_choice) rule.scope = Scope::object, rule.groups = true;
    return rule;
}

}  // namespace

Surfaces collect_surfaces(const Scene& scene, std::span<const std::uint32_t> objects, NormalSource source) {
    const std::vector<dmat4> world = bind_pose_matrices(scene);
    Surfaces out;
    out.parts = drawn_instances(scene);
    out.meshes.reserve(out.parts.size());
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
        out.rules.push_back(rule_of(scene, mesh, source));
        m.crease_angle_rad = out.rules.back().crease_angle_rad;
        m.to_world = world[part.node] * translation(mesh.origin);
    }
    return out;
}

}  // namespace rakelight
