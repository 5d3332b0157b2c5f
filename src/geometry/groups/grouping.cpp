// SPDX-License-Identifier: Apache-2.0
#include "geometry/groups/grouping.h"

#include <algorithm>
#include <numeric>

#include "geometry/groups/mirror_split.h"
#include "geometry/groups/refine_groups.h"
#include "geometry/weld/near_weld.h"
#include "geometry/weld/position_weld.h"

namespace rakelight::geometry {
namespace {

bool has_groups(std::span<const AttributeMesh> meshes) {
    return std::any_of(meshes.begin(), meshes.end(), [](const AttributeMesh& m) {
        return m.smoothing.empty() ? !m.smoothing_hint.empty() : m.group_kind != GroupKind::none;
    });
}

// Estimated peak memory of grouping: indices and grid entries per vertex, lists and normals per triangle.
void check_memory(const AttributeInput& input, bool refines, Context& context) {
    const std::uint64_t vertices = input.vertex_count(), triangles = input.triangle_count();
    context.memory().check(vertices * 112 + (refines ? triangles * 72 : 0), "smoothing normals");
}

std::shared_ptr<const std::vector<std::uint32_t>> weld(const AttributeInput& input, const AttributeOptions& options,
                                                       GeneralScratch* scratch, Context& context) {
    const WeldKey key{.object = options.scope != Scope::model, .normal = !options.normals};
    auto places = std::make_shared<std::vector<std::uint32_t>>(weld_positions(input, key, context, nullptr, scratch));
    if (options.normals) weld_near(*places, input, key, options.weld_distance, context);
    context.throw_if_cancelled();
    return places;
}

std::shared_ptr<const std::vector<std::uint32_t>> each_vertex_alone(const AttributeInput& input) {
    auto places = std::make_shared<std::vector<std::uint32_t>>(input.vertex_count());
    std::iota(places->begin(), places->end(), 0u);
    return places;
}

CornerBins bins_by_place(const Topology& topology, const AttributeInput& input, GroupingBase& base, Context& context) {
    if (!base.scratch) return bin_corners(topology, input, base.wanted, context);
    CornerBins memory;
    memory.corners = BlockArray<std::uint32_t>(std::move(base.scratch->corners));
    memory.begin = base.scratch->take_words();
    BlockArray<std::uint16_t> keys(std::move(base.scratch->keys));
    CornerBins bins = bin_corners(topology, input, base.wanted, context, std::move(memory), &keys);
    base.scratch->keys = keys.take();
    return bins;
}

}  // namespace

const FaceNormals& GroupingBase::face_normals(const AttributeInput& input, Context& context) {
    if (!normals) {
        FaceNormals memory;
        if (scratch) memory = FaceNormals(std::move(scratch->faces));
        normals = std::make_shared<FaceNormals>(geometry::face_normals(input, context, std::move(memory)));
    }
    return *normals;
}

void GroupingBase::release() {
    if (scratch && normals) scratch->faces = normals->take();
    if (scratch && corners) scratch->corners = corners->corners.take(), scratch->give(corners->begin);
    places = nullptr, normals = nullptr, corners = nullptr, creases = nullptr;
}

bool same_weld(const AttributeOptions& a, const AttributeOptions& b) {
    return (a.scope == Scope::model) == (b.scope == Scope::model) && a.normals == b.normals &&
           a.weld_distance == b.weld_distance;
}

const CreaseEdges& crease_edges(GroupingBase& base, const AttributeInput& input, const AttributeOptions& options,
                                Context& context) {
    if (!base.places) base.places = weld(input, options, base.scratch, context);
    if (!base.creases)
        base.creases = std::make_shared<CreaseEdges>(
            decide_creases(input, *base.places, base.face_normals(input, context), context));
    return *base.creases;
}

Grouped make_groups(GroupingBase& base, const AttributeInput& input, const AttributeOptions& options,
                    Context& context) {
    const bool groups = has_groups(input.meshes);
    const CreaseRange creases = crease_range(input.meshes, options);
    const bool flat = options.normals && (options.scope == Scope::face || (creases.most == 0 && !groups));
    const bool refines = options.normals && (flat || groups || options.fans || !creases.joins_all());
    check_memory(input, refines, context);
    if (!flat && !base.places) base.places = weld(input, options, base.scratch, context);
    Grouped made;
    made.topology.places = flat ? each_vertex_alone(input) : base.places;
    if (base.scratch) made.topology.group = base.scratch->take_words();
    made.topology.group.assign(made.topology.places->begin(), made.topology.places->end());
    if (base.scratch) made.topology.spare = base.scratch->take<char>(12 * std::size_t(input.triangle_count())).take();
    if (refines) {
        const CreaseEdges* const edges =
            creases.has_rule && !flat ? &crease_edges(base, input, options, context) : nullptr;
        const JoinRules rules(input, made.topology, options, flat ? JoinRule::apart : JoinRule::crease,
                              base.face_normals(input, context), edges);
        context.throw_if_cancelled();
        CornerBins flat_bins;
        if (flat)
            flat_bins = bin_corners(made.topology, input, {}, context);
        else if (!base.corners)
            base.corners = std::make_shared<CornerBins>(bins_by_place(made.topology, input, base, context));
        made.may_cancel =
            refine_groups(made.topology, input, rules, flat ? flat_bins : *base.corners, context, base.scratch);
    }
    context.throw_if_cancelled();
    const bool textured = std::any_of(input.meshes.begin(), input.meshes.end(),
                                      [](const AttributeMesh& m) { return !m.texcoords.empty(); });
    if (options.tangents && textured) split_mirrored(made.topology, input, !options.normals, context);
    made.may_cancel &= options.normals;
    return made;
}

void take_apart(Topology& topology, GroupingBase& base, const AttributeInput& input, const AttributeOptions& options,
                JoinRule rule, const std::vector<std::uint8_t>& selected, Context& context) {
    const JoinRules rules(input, topology, options, rule, base.face_normals(input, context));
    refine_groups(topology, input, rules, bin_corners(topology, input, selected, context), context);
}

}  // namespace rakelight::geometry
