// SPDX-License-Identifier: Apache-2.0
// The door of <rakelight/attributes.h>: weld -> creases and smoothing groups -> mirrored texture coordinates -> sums ->
// vertices. Where everything at a place is joined (crease angle pi, no groups) the second stage has nothing to do, and only
// vertices are welded, never corners: the fast path.
#include <rakelight/attributes.h>

#include <numeric>
#include <string>

#include "geometry/attribute_input.h"
#include "geometry/attribute_plan.h"
#include "geometry/fast_attributes.h"
#include "geometry/finish_vertices.h"
#include "geometry/mirror_split.h"
#include "geometry/near_weld.h"
#include "geometry/position_weld.h"
#include "geometry/refine_groups.h"
#include "geometry/tangent_modes.h"
#include "geometry/vote_sums.h"

namespace rakelight {
namespace {

using namespace geometry;

struct Outcome {
    std::shared_ptr<AttributePlan::Impl> plan;
    std::vector<MeshAttributes> meshes;
};

bool has_groups(std::span<const AttributeMesh> meshes) {
    return std::any_of(meshes.begin(), meshes.end(), [](const AttributeMesh& m) {
        return m.smoothing.empty() ? !m.smoothing_hint.empty() : m.group_kind != GroupKind::none;
    });
}

// A rough sum of what grouping holds at once: numbers and grid entries per vertex, lists and normals per triangle.
void check_grouping_memory(const AttributeInput& input, bool refines, Context& context) {
    const std::uint64_t vertices = input.vertex_count(), triangles = input.triangle_count();
    context.memory().check(vertices * 112 + (refines ? triangles * 112 : 0), "smoothing normals");
}

// The same for the sums and the result, when it is known how many vertices there are after splitting.
void check_sums_memory(const AttributePlan::Impl& plan, Context& context) {
    std::uint64_t row = sizeof(NormalRow) + sizeof(vec3) + 2 * sizeof(std::uint32_t);
    const bool textured = std::find(plan.textured.begin(), plan.textured.end(), 1) != plan.textured.end();
    if (plan.options.tangents && textured) row += sizeof(TangentRow) + sizeof(vec4);
    context.memory().check(plan.topology.group.size() * row + plan.topology.corner_vertex.size() * 8, "smoothing normals");
}

Topology group_positions(const AttributeInput& input, const AttributeOptions& options, Context& context) {
    const bool groups = has_groups(input.meshes);
    const bool flat = options.scope == Scope::face || (options.crease_angle_rad == 0 && !groups);
    const bool refines = options.normals && (flat || groups || options.fans || options.crease_angle_rad + 1e-6 < pi);
    check_grouping_memory(input, refines, context);
    Topology topology;
    if (options.normals && flat) {
        topology.position_class.resize(input.vertex_count());
        std::iota(topology.position_class.begin(), topology.position_class.end(), 0u);
    } else {
        const WeldKey key{.object = options.scope != Scope::model, .normal = !options.normals};
        topology.position_class = weld_positions(input, key, context);
        if (options.normals) weld_near(topology.position_class, input, key, options.weld_distance, context);
    }
    topology.group = topology.position_class;
    context.throw_if_cancelled();
    if (refines)
        refine_groups(topology, input, options, flat ? JoinRule::apart : JoinRule::crease, face_normals(input, context), {},
                      context);
    context.throw_if_cancelled();
    const bool textured = std::any_of(input.meshes.begin(), input.meshes.end(),
                                      [](const AttributeMesh& m) { return !m.texcoords.empty(); });
    if (options.tangents && textured) split_mirrored(topology, input, !options.normals, context);
    return topology;
}

// Groups whose normals cancelled, as marks on their vertices' common representative.
std::vector<std::uint8_t> marks_of(const VoteSums& sums, const VertexGroups& groups, const Finished& finished,
                                   const Topology& topology) {
    std::vector<std::uint8_t> marks;
    if (sums.cancelled_groups.empty() && finished.cancelled.empty()) return marks;
    marks.assign(topology.group.size(), 0);
    for (const std::uint32_t g : sums.cancelled_groups) marks[topology.group[groups.members[groups.begin[g]]]] = 1;
    for (const std::uint32_t v : finished.cancelled) marks[topology.group[v]] = 1;
    return marks;
}

std::vector<MeshAttributes> add_up(const AttributePlan::Impl& plan, const AttributeInput& input, Context& context,
                                   std::vector<std::uint8_t>& cancelled) {
    check_sums_memory(plan, context);
    VoteSums sums = sum_votes(plan.topology, input, plan.options, context);
    sum_groups(sums, plan.groups, plan.topology, input, plan.options, context);
    context.throw_if_cancelled();
    Finished finished = finish_vertices(sums, plan.topology, input, plan.options, context);
    cancelled = marks_of(sums, plan.groups, finished, plan.topology);
    return std::move(finished.meshes);
}

// Coincident shells that face opposite ways cancel where all is joined. Such places are grouped again by sides; what cancels
// even then is left flat, which cannot cancel.
Outcome run(std::span<const AttributeMesh> meshes, const AttributeOptions& options, Context& context) {
    check_options(options);
    const AttributeInput input = check_input(meshes, context);
    for (std::size_t m = 0; m < meshes.size() && !options.normals; ++m)
        if (meshes[m].normals.empty() && !meshes[m].positions.empty())
            throw Error(ErrorCode::bad_file, "no normals to keep", "mesh " + std::to_string(m));
    Outcome outcome;
    outcome.plan = std::make_shared<AttributePlan::Impl>();
    AttributePlan::Impl& plan = *outcome.plan;
    plan.options = options;
    plan.tangents_after = options.tangents && options.tangent_mode != TangentMode::averaged;
    if (plan.tangents_after) plan.options.tangents = false;
    for (const AttributeMesh& mesh : meshes) {
        plan.vertices.push_back(std::uint32_t(mesh.positions.size()));
        plan.triangles.push_back(std::uint32_t(mesh.indices.size() / 3));
        plan.textured.push_back(mesh.texcoords.empty() ? 0 : 1);
    }
    plan.topology = group_positions(input, plan.options, context);
    plan.groups = make_vertex_groups(plan.topology.group);
    std::vector<std::uint8_t> cancelled;
    outcome.meshes = add_up(plan, input, context, cancelled);
    for (const JoinRule rule : {JoinRule::side, JoinRule::apart}) {
        if (cancelled.empty()) break;
        refine_groups(plan.topology, input, plan.options, rule, face_normals(input, context), cancelled, context);
        plan.groups = make_vertex_groups(plan.topology.group);
        outcome.meshes = add_up(plan, input, context, cancelled);
    }
    if (plan.tangents_after) add_tangents(outcome.meshes, plan, input, context);
    return outcome;
}

}  // namespace

AttributePlan group(std::span<const AttributeMesh> meshes, const AttributeOptions& options, Context& context) {
    return AttributePlan(run(meshes, options, context).plan);
}

std::vector<MeshAttributes> accumulate(const AttributePlan& plan, std::span<const AttributeMesh> meshes, Context& context) {
    const AttributePlan::Impl& impl = plan.impl();
    const AttributeInput input = check_input(meshes, context);
    if (meshes.size() != impl.vertices.size())
        throw Error(ErrorCode::bad_file, std::to_string(meshes.size()) + " meshes, but they were grouped as " +
                                             std::to_string(impl.vertices.size()));
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        const bool fits = meshes[m].positions.size() == impl.vertices[m] && meshes[m].indices.size() / 3 == impl.triangles[m] &&
                          meshes[m].texcoords.empty() == (impl.textured[m] == 0) &&
                          (impl.options.normals || meshes[m].normals.size() == meshes[m].positions.size());
        if (!fits) throw Error(ErrorCode::bad_file, "not the mesh that was grouped", "mesh " + std::to_string(m));
    }
    std::vector<std::uint8_t> cancelled;  // by a pose: such vertices keep what their own faces say
    std::vector<MeshAttributes> out = add_up(impl, input, context, cancelled);
    if (impl.tangents_after) add_tangents(out, impl, input, context);
    return out;
}

std::vector<MeshAttributes> compute_attributes(std::span<const AttributeMesh> meshes, const AttributeOptions& options,
                                               Context& context) {
    check_options(options);
    if (geometry::takes_fast_path(meshes, options)) return geometry::fast_attributes(meshes, options, context);
    return geometry::general_attributes(meshes, options, context);
}

std::vector<MeshAttributes> geometry::general_attributes(std::span<const AttributeMesh> meshes, const AttributeOptions& options,
                                                         Context& context) {
    return run(meshes, options, context).meshes;
}

}  // namespace rakelight
