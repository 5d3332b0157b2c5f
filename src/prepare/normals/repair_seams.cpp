// SPDX-License-Identifier: Apache-2.0
#include "prepare/normals/repair_seams.h"

#include <cstdio>

#include <rakelight/scene/validate.h>

#include "base/format_text.h"
#include "prepare/normals/bind_pose.h"
#include "prepare/normals/normal_rule.h"
#include "prepare/normals/turned_normals.h"
#include "prepare/prepare_scene.h"
#include "scene/charge_arrays.h"

namespace rakelight {
namespace {

/// In the world, skinned ones in bind pose.
PlacedParts parts_of(const Scene& scene, const SeamRequest& request, const std::vector<dmat4>& world) {
    PlacedParts parts;
    for (const Instance& instance : drawn_instances(scene)) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        NormalRule rule{.crease_angle_rad = own_crease_angle(mesh)};
        if (request.source) rule = normal_rule(scene, mesh, *request.source);
        if (mesh.normals.empty() || (request.source && !rule.joins_seams)) continue;
        parts.add(instance, mesh, world[instance.node]);
        parts.meshes.back().crease_angle_rad = rule.crease_angle_rad;
    }
    return parts;
}

}  // namespace

Scene join_seams(Scene scene, const SeamRequest& request, SeamReport& seams, Context& context) {
    const std::vector<dmat4> world = bind_pose_matrices(scene);
    const PlacedParts parts = parts_of(scene, request, world);
    parts.check_memory(context);
    std::vector<MeshSeams> turned = join_seams(parts.meshes, request.options, seams, context);
    if (seams.turned == 0) return scene;
    scene = with_turned_normals(std::move(scene), parts, std::move(turned), request.keep_instances, context);
    warn_of_parting_vertices(scene, parts.instances, world, context);
    return scene;
}

Scene repair_seams(const Scene& scene, const SeamOptions& options, Context& context, SeamReport* seams,
                   bool keep_instances) {
    validate(scene);
    SeamReport unread;
    Scene out =
        join_seams(scene, {.options = options, .keep_instances = keep_instances}, seams ? *seams : unread, context);
    charge_new_arrays(out, unpaid_arrays(scene), context);
    return out;
}

std::string describe(const SeamReport& seams, std::uint64_t missing_made) {
    char text[200];
    std::string out =
        format_text("{} of {} {}normals turn", seams.turned, seams.normals, missing_made > 0 ? "" : "authored ");
    if (seams.turned > 0) {
        std::snprintf(text, sizeof text, " (at most %.3g degrees, %.3g on average)", seams.max_deg, seams.mean_deg);
        out += text;
    }
    if (missing_made > 0) out += format_text(", {} missing normals made", missing_made);
    if (seams.flat_pairs > 0)
        out += format_text(", {} pairs of flat faces at borders keep their edge", seams.flat_pairs);
    if (seams.crease_pairs > 0)
        out += format_text(", {} pairs of faces at borders keep an authored crease", seams.crease_pairs);
    if (seams.unusable > 0) out += format_text(", {} that are zero or not finite stay so", seams.unusable);
    return out;
}

}  // namespace rakelight
