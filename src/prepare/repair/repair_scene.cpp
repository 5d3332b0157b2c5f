// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <rakelight/base/error.h>
#include <rakelight/base/report.h>

#include "math/linear.h"
#include "prepare/normals/normal_rule.h"
#include "prepare/repair/repair.h"
#include "prepare/variants.h"
#include "scene/materials/material_table.h"
#include "scene/placement.h"
#include "scene/validate_parts.h"

namespace rakelight {
namespace {

bool is_textured(const Scene& scene, const Mesh& mesh) {
    if (mesh.material == no_index) return false;
    const Material& m = scene.materials[mesh.material];
    const auto roles = texture_roles();
    return std::any_of(roles.begin(), roles.end(), [&m](const TextureRole& role) { return bool(role.in(m)); });
}

/// A zero column, or three coplanar columns (to twelve digits).
bool flattens(const dmat4& m) {
    const dvec3 a = normalize_or(m[0].xyz(), dvec3{0, 0, 0}), b = normalize_or(m[1].xyz(), dvec3{0, 0, 0}),
                c = normalize_or(m[2].xyz(), dvec3{0, 0, 0});
    return std::fabs(dot(a, cross(b, c))) <= 1e-12;
}

/// The warning if squared lengths exceed the float range; null: none.
const char* extreme_scale(const dmat4& m) {
    constexpr double largest = 1e18;  // limits as in repair_positions.cpp
    for (std::size_t c = 0; c < 3; ++c) {
        const dvec3 v = m[c].xyz();
        const double size = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
        if (size > largest)
            return "the matrix or scale is so large (more than 1e18) that products of lengths leave the range of float";
        if (size > 0 && size < 1 / largest)
            return "the matrix or scale is so small (less than 1e-18) that products of lengths leave the range of "
                   "float";
    }
    return nullptr;
}

}  // namespace

void check_nodes(const Scene& scene, Report& report) {
    const std::vector<dmat4> world = world_matrices(scene);
    std::vector<bool> draws(scene.nodes.size(), false);
    for (const Instance& instance : drawn_instances(scene)) draws[instance.node] = true;
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        const dquat& q = node.local.rotation;
        if (!node.local.matrix && q == dquat{0, 0, 0, 0})
            report.add(Remark::warning, scene.source, Place{"node", i, node.name}.text(),
                       "the rotation is zero: taken as none");
        if (draws[i] && flattens(world[i]))
            report.add(Remark::warning, scene.source, Place{"node", i, node.name}.text(),
                       "the matrix or scale flattens the object: it has no volume and perhaps no area");
        const char* const extreme = draws[i] ? extreme_scale(world[i]) : nullptr;
        if (extreme) report.add(Remark::warning, scene.source, Place{"node", i, node.name}.text(), extreme);
    }
}

static bool has_lines_or_points(const Scene& scene) {
    for (const Node& node : scene.nodes)
        for (const std::uint32_t mesh : node.meshes)
            if (scene.meshes[mesh].topology != Topology::triangles && !scene.meshes[mesh].indices.empty()) return true;
    return false;
}

Scene repair_scene(Scene scene, NormalSource source, Context& context) {
    std::vector<std::uint32_t> numbers;
    for (const Instance& instance : drawn_instances(scene)) numbers.push_back(instance.mesh);
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());

    std::vector<std::vector<Finding>> findings(numbers.size());
    context.parallel_for(numbers.size(), [&](std::size_t i) {
        Mesh& mesh = scene.meshes[numbers[i]];
        if (!normal_rule(scene, mesh, source).keeps_given) {
            mesh.normals = {};
            mesh.tangents = {};
        }
        repair_positions(mesh, findings[i]);
        repair_texcoords(mesh, is_textured(scene, mesh), findings[i]);
        repair_normals(mesh, findings[i]);
        repair_tangents(mesh, findings[i]);
    });
    for (std::size_t i = 0; i < numbers.size(); ++i)
        for (const Finding& f : findings[i])
            context.report().add(f.remark, scene.source,
                                 Place{"mesh", numbers[i], scene.meshes[numbers[i]].name}.text(), f.message);
    if (triangle_count(scene) == 0 && !has_lines_or_points(scene))
        throw Error(ErrorCode::bad_file, "nothing to draw").with_file(scene.source);
    return scene;
}

}  // namespace rakelight
