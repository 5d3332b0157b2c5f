// SPDX-License-Identifier: Apache-2.0
// The stages: weld -> creases and smoothing groups -> mirrored texture coordinates -> sums -> vertices.
#include "geometry/general_attributes.h"

#include <algorithm>
#include <string>

#include "base/format_text.h"
#include "geometry/fits/fit_normals.h"
#include "geometry/sums/finish_vertices.h"
#include "geometry/tangents/tangent_modes.h"

namespace rakelight::geometry {
namespace {

using Plan = AttributePlan::Impl;

// Estimated memory of sums and result, from the number of vertices after splitting.
void check_sums_memory(const AttributePlan::Impl& plan, const AttributeInput& input, Context& context) {
    std::uint64_t row = sizeof(NormalRow) + sizeof(vec3) + 2 * sizeof(std::uint32_t);
    const bool textured = std::find(plan.textured.begin(), plan.textured.end(), 1) != plan.textured.end();
    if (plan.options.tangents && textured) row += sizeof(TangentRow) + sizeof(vec4);
    context.memory().check(plan.topology.group.size() * row +
                               (plan.topology.corner_vertex.empty() ? 0 : 24 * std::uint64_t(input.triangle_count())),
                           "smoothing normals");
}

// Groups whose normals cancelled, as marks on their vertices' common representative.
std::vector<std::uint8_t> marks_of(const VoteSums& sums, const std::vector<std::uint32_t>& vertices, const Plan& plan) {
    std::vector<std::uint8_t> marks;
    if (sums.cancelled_groups.empty() && vertices.empty()) return marks;
    const VertexGroups& groups = plan.groups;
    const std::vector<std::uint32_t>& group = plan.topology.group;
    marks.assign(group.size(), 0);
    for (const std::uint32_t g : sums.cancelled_groups) marks[group[groups.members[groups.begin[g]]]] = 1;
    for (const std::uint32_t v : vertices) marks[group[v]] = 1;
    return marks;
}

// Converts the sums of a plan to vertices.
// @param fit     (sums) replaces normals
// @param finish  (sums) -> Cancelled
// @return marks of cancelled groups
template <class FitSums, class FinishSums>
std::vector<std::uint8_t> add_up(const Plan& plan, const AttributeInput& input, GeneralScratch& scratch,
                                 Context& context, const FitSums& fit, const FinishSums& finish) {
    check_sums_memory(plan, input, context);
    VoteSums sums =
        sum_votes(plan.topology, input, plan.options, context, BlockArray<NormalRow>(std::move(scratch.faces)),
                  BlockArray<TangentRow>(std::move(scratch.corners)));
    sum_groups(sums, plan.groups, plan.topology, input, plan.options, context);
    if (plan.options.normals && is_fitted(plan.options.weight)) fit(sums);
    average_tangents(sums, plan.groups, plan.topology, input, plan.options, context);
    context.throw_if_cancelled();
    const Cancelled cancelled = finish(sums);
    std::vector<std::uint8_t> marks = marks_of(sums, cancelled, plan);
    scratch.faces = sums.normals.take();
    scratch.corners = sums.tangents.take();
    return marks;
}

template <class FinishSums>
std::vector<std::uint8_t> add_up(const Plan& plan, const AttributeInput& input, GeneralScratch& scratch,
                                 Context& context, const FinishSums& finish) {
    const auto fit = [&](VoteSums& sums) { fit_normals(sums, plan.topology, input, plan.options, scratch, context); };
    return add_up(plan, input, scratch, context, fit, finish);
}

// The cancelled groups that add_up() would find, from the sums of normals only.
std::vector<std::uint8_t> find_cancelled(const Plan& plan, const AttributeInput& input, Context& context) {
    check_sums_memory(plan, input, context);
    AttributeOptions options = plan.options;
    options.tangents = false;
    VoteSums sums = sum_votes(plan.topology, input, options, context);
    sum_groups(sums, plan.groups, plan.topology, input, options, context);
    return marks_of(sums, cancelled_vertices(sums, plan.topology, input, context), plan);
}

std::shared_ptr<Plan> describe(std::span<const AttributeMesh> meshes, const AttributeOptions& options) {
    auto plan = std::make_shared<Plan>();
    plan->options = options;
    plan->tangents_after = options.tangents && options.tangent_mode != TangentMode::averaged;
    if (plan->tangents_after) plan->options.tangents = false;
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        if (!options.normals && meshes[m].normals.empty() && !meshes[m].positions.empty())
            throw Error(ErrorCode::bad_file, "no normals to keep", format_text("mesh {}", m));
        plan->vertices.push_back(std::uint32_t(meshes[m].positions.size()));
        plan->triangles.push_back(std::uint32_t(meshes[m].indices.size() / 3));
        plan->textured.push_back(meshes[m].texcoords.empty() ? 0 : 1);
    }
    return plan;
}

bool make_plan(Plan& plan, const AttributeInput& input, Context& context) {
    Grouped grouped = make_groups(plan.base, input, plan.options, context);
    plan.topology = std::move(grouped.topology);
    plan.groups = make_vertex_groups(plan.topology.group, plan.base.scratch);
    return grouped.may_cancel;
}

// Coincident shells of opposite orientation cancel if everything is joined. Such places are regrouped by side; groups
// that still cancel become flat.
// @param cancelled marks of a plan -> marks of the repaired plan
template <class Again>
void mend_cancelled(Plan& plan, const AttributeInput& input, std::vector<std::uint8_t> cancelled, Context& context,
                    const Again& again) {
    for (const JoinRule rule : {JoinRule::side, JoinRule::apart}) {
        if (cancelled.empty()) return;
        take_apart(plan.topology, plan.base, input, plan.options, rule, cancelled, context);
        plan.groups = make_vertex_groups(plan.topology.group);
        cancelled = again();
    }
}

// Both steps at once: the sums that detect cancellation are the result.
template <class FinishSums>
void run(Plan& plan, const AttributeInput& input, GeneralScratch& scratch, Context& context, const FinishSums& finish) {
    plan.base.scratch = &scratch;
    make_plan(plan, input, context);
    plan.base.release();
    const auto sum = [&] {
        return add_up(plan, input, scratch, context, [&](const VoteSums& sums) { return finish(plan, sums); });
    };
    mend_cancelled(plan, input, sum(), context, sum);
    plan.base.release();
}

// The memory of a plan that is not needed any more.
void give_back(Plan& plan, GeneralScratch& scratch) {
    scratch.give(plan.topology.corner_vertex);
    scratch.give(plan.topology.group);
    if (plan.topology.spare.data()) scratch.spare.push_back(std::move(plan.topology.spare));
}

std::vector<MeshAttributes> run(std::span<const AttributeMesh> meshes, const AttributeOptions& options,
                                std::span<const std::uint8_t> wanted, GeneralScratch& scratch, Context& context) {
    check_options(options);
    const AttributeInput input = check_input(meshes, context);
    const std::shared_ptr<Plan> plan = describe(meshes, options);
    plan->base.wanted = wanted;
    std::vector<MeshAttributes> out;
    run(*plan, input, scratch, context, [&](const Plan& p, const VoteSums& sums) {
        return finish_vertices(sums, p.topology, input, p.options, out, context);
    });
    if (plan->tangents_after) add_tangents(out, *plan, input, context);
    give_back(*plan, scratch);
    return out;
}

void make_mended_plan(Plan& plan, const AttributeInput& input, Context& context) {
    if (make_plan(plan, input, context))
        mend_cancelled(plan, input, find_cancelled(plan, input, context), context,
                       [&] { return find_cancelled(plan, input, context); });
}

}  // namespace

AttributePlan plan_from(GroupingBase base, std::span<const AttributeMesh> meshes, const AttributeOptions& options,
                        Context& context) {
    check_options(options);
    const AttributeInput input = check_input(meshes, context);
    const std::shared_ptr<Plan> plan = describe(meshes, options);
    plan->base = std::move(base);
    make_mended_plan(*plan, input, context);
    return AttributePlan(plan);
}

std::vector<MeshAttributes> accumulate(const Plan& plan, const AttributeInput& input, Context& context) {
    GeneralScratch scratch;
    std::vector<MeshAttributes> out;  // groups that cancel in a pose keep the sums of their own faces
    add_up(plan, input, scratch, context, [&](const VoteSums& sums) {
        return finish_vertices(sums, plan.topology, input, plan.options, out, context);
    });
    if (plan.tangents_after) add_tangents(out, plan, input, context);
    return out;
}

std::vector<MeshAttributes> general_attributes(std::span<const AttributeMesh> meshes, const AttributeOptions& options,
                                               std::span<const std::uint8_t> wanted, GeneralScratch& scratch,
                                               Context& context) {
    return run(meshes, options, wanted, scratch, context);
}
std::vector<MeshAttributes> general_attributes(std::span<const AttributeMesh> meshes, const AttributeOptions& options,
                                               Context& context) {
    GeneralScratch scratch;
    return run(meshes, options, {}, scratch, context);
}

GroupedPart::GroupedPart(std::span<const AttributeMesh> meshes, const AttributeOptions& options,
                         std::span<const std::uint8_t> wanted, GeneralScratch& scratch, Context& context)
    : input_(check_input(meshes, context)), plan_(describe(meshes, options)), scratch_(scratch), context_(context) {
    plan_->base.wanted = wanted;
    plan_->base.scratch = &scratch;
    make_mended_plan(*plan_, input_, context);
    plan_->base.release();
}
GroupedPart::~GroupedPart() { give_back(*plan_, scratch_); }

const Topology& GroupedPart::topology() const { return plan_->topology; }

VoteSums GroupedPart::sums() const {
    AttributeOptions options = plan_->options;
    options.tangents = false;
    VoteSums sums = sum_votes(plan_->topology, input_, options, context_);
    sum_groups(sums, plan_->groups, plan_->topology, input_, options, context_);
    return sums;
}

std::vector<MeshAttributes> GroupedPart::finish(const std::function<void(VoteSums&)>& fit) const {
    std::vector<MeshAttributes> out;
    add_up(*plan_, input_, scratch_, context_, fit, [&](const VoteSums& sums) {
        return finish_vertices(sums, plan_->topology, input_, plan_->options, out, context_);
    });
    return out;
}

SplitAttributes split_from(const AttributeMesh& mesh, const MeshAttributes& result, const AttributeBuffers& out) {
    const std::size_t count = mesh.positions.size();
    SplitAttributes split;
    std::copy_n(result.normals.begin(), count, out.normals.begin());
    split.normals.assign(result.normals.begin() + std::ptrdiff_t(count), result.normals.end());
    if (!result.tangents.empty()) {
        std::copy_n(result.tangents.begin(), count, out.tangents.begin());
        split.tangents.assign(result.tangents.begin() + std::ptrdiff_t(count), result.tangents.end());
    }
    split.source_vertex = result.source_vertex;
    for (std::size_t i = 0; i < result.indices.size(); ++i)
        if (result.indices[i] != mesh.indices[i]) split.corners.push_back({std::uint32_t(i), result.indices[i]});
    split.degenerate_faces = result.degenerate_faces;
    split.isolated_vertices = result.isolated_vertices;
    return split;
}

std::vector<SplitAttributes> general_attributes_into(std::span<const AttributeMesh> meshes,
                                                     const AttributeOptions& options,
                                                     std::span<const AttributeBuffers> out, GeneralScratch& scratch,
                                                     Context& context) {
    std::vector<SplitAttributes> splits;
    if (options.tangents &&
        options.tangent_mode != TangentMode::averaged) {  // computed from complete arrays of normals
        const std::vector<MeshAttributes> results = run(meshes, options, {}, scratch, context);
        for (std::size_t m = 0; m < meshes.size(); ++m) splits.push_back(split_from(meshes[m], results[m], out[m]));
        return splits;
    }
    check_options(options);
    const AttributeInput input = check_input(meshes, context);
    const std::shared_ptr<Plan> plan = describe(meshes, options);
    run(*plan, input, scratch, context, [&](const Plan& p, const VoteSums& sums) {
        return finish_vertices(sums, p.topology, input, p.options, out, splits, context);
    });
    give_back(*plan, scratch);
    return splits;
}

}  // namespace rakelight::geometry
