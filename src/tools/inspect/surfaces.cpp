// SPDX-License-Identifier: Apache-2.0
#include "tools/inspect/surfaces.h"

#include <algorithm>

#include "math/linear.h"
#include "prepare/normals/bind_pose.h"
#include "prepare/normals/tangent_coordinates.h"

namespace rakelight {
namespace {

/// Whether any part has a choice of its own: then all are taken as a picture has them, since what says nothing is
/// smoothed together with what says "model".
bool has_choices(const Scene& scene, std::span<const Instance> parts) {
    return std::any_of(parts.begin(), parts.end(),
                       [&](const Instance& part) { return scene.meshes[part.mesh].normal_choice.has_value(); });
}

}  // namespace

bool keep_some(const Surfaces& surfaces) {
    for (std::size_t i = 0; i < surfaces.meshes.size(); ++i)
        if (surfaces.rules[i].keeps_given && !surfaces.meshes[i].normals.empty()) return true;
    return false;
}

Surfaces collect_surfaces(const Scene& scene, std::span<const std::uint32_t> objects, NormalSource source) {
    const std::vector<dmat4> world = bind_pose_matrices(scene);
    Surfaces out;
    out.parts = drawn_instances(scene);
    out.meshes.reserve(out.parts.size());
    const bool per_object = source == NormalSource::automatic && !has_choices(scene, out.parts);
    for (const Instance& part : out.parts) {
        const Mesh& mesh = scene.meshes[part.mesh];
        AttributeMesh& m = out.meshes.emplace_back();
        m.object = std::uint32_t(std::lower_bound(objects.begin(), objects.end(), part.node) - objects.begin());
        m.positions = mesh.positions;
        m.indices = mesh.indices;
        m.normals = mesh.normals;
        out.texcoords.push_back(tangent_texcoords(mesh, tangent_coordinates(scene, mesh, TangentNeed::everywhere)));
        m.texcoords = out.texcoords.back();
        m.smoothing = mesh.smoothing;
        if (!mesh.smoothing.empty())
            m.group_kind = mesh.smoothing_kind == SmoothingKind::masks ? GroupKind::masks : GroupKind::numbers;
        m.smoothing_hint = mesh.smoothing_hint;
        m.position_step = mesh.position_step;
        out.rules.push_back(normal_rule(scene, mesh, source));
        if (per_object) out.rules.back().scope = Scope::object, out.rules.back().groups = true;
        m.crease_angle_rad = out.rules.back().crease_angle_rad;
        m.to_world = world[part.node] * translation(mesh.origin);
    }
    return out;
}

}  // namespace rakelight
