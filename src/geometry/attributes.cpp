// SPDX-License-Identifier: Apache-2.0
// Where one crease angle (or none) decides, most places are joined whole, and vertices are welded, never corners: the fast
// path. All else takes the general path.
#include <rakelight/geometry/attributes.h>

#include <string>

#include "base/format_text.h"
#include "geometry/fast/fast_attributes.h"
#include "geometry/fits/fit_normals.h"
#include "geometry/general_attributes.h"

namespace rakelight {
namespace {

using namespace geometry;

using Plan = AttributePlan::Impl;

void check_same(const Plan& plan, std::span<const AttributeMesh> meshes, bool needs_normals) {
    if (meshes.size() != plan.vertices.size())
        throw Error(ErrorCode::bad_file,
                    format_text("{} meshes, but they were grouped as {}", meshes.size(), plan.vertices.size()));
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        const bool fits = meshes[m].positions.size() == plan.vertices[m] &&
                          meshes[m].indices.size() / 3 == plan.triangles[m] &&
                          meshes[m].texcoords.empty() == (plan.textured[m] == 0) &&
                          (!needs_normals || meshes[m].normals.size() == meshes[m].positions.size());
        if (!fits) throw Error(ErrorCode::bad_file, "not the mesh that was grouped", format_text("mesh {}", m));
    }
}

void check_buffers(std::span<const AttributeMesh> meshes, const AttributeOptions& options,
                   std::span<const AttributeBuffers> out) {
    if (out.size() != meshes.size())
        throw Error(ErrorCode::usage, format_text("{} buffers for {} meshes", out.size(), meshes.size()));
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        const auto need = [&](std::size_t given, const char* what) {
            if (given >= meshes[m].positions.size()) return;
            throw Error(ErrorCode::usage,
                        format_text("room for {} {} of {} vertices", given, what, meshes[m].positions.size()),
                        format_text("mesh {}", m));
        };
        need(out[m].normals.size(), "normals");
        if (options.tangents && !meshes[m].texcoords.empty()) need(out[m].tangents.size(), "tangents");
    }
}

}  // namespace

const AttributePlan::Impl& AttributePlan::impl() const {
    if (!impl_) throw Error(ErrorCode::usage, "the plan is empty: it was moved away, or nothing was grouped");
    return *impl_;
}

AttributePlan group(std::span<const AttributeMesh> meshes, const AttributeOptions& options, Context& context) {
    return plan_from({}, meshes, options, context);
}

AttributePlan regroup(const AttributePlan& plan, std::span<const AttributeMesh> meshes, const AttributeOptions& options,
                      Context& context) {
    const Plan& old = plan.impl();
    check_same(old, meshes, false);
    GroupingBase base = old.base;
    if (!same_weld(old.options, options)) base.places = nullptr, base.corners = nullptr, base.creases = nullptr;
    return plan_from(std::move(base), meshes, options, context);
}

std::vector<MeshAttributes> accumulate(const AttributePlan& plan, std::span<const AttributeMesh> meshes,
                                       Context& context) {
    const Plan& impl = plan.impl();
    const AttributeInput input = check_input(meshes, context);
    check_same(impl, meshes, !impl.options.normals);
    return geometry::accumulate(impl, input, context);
}

NormalChoices normal_choices(std::span<const AttributeMesh> meshes, const AttributeOptions& options, Context& context) {
    AttributeOptions asked = options;
    asked.weight = CornerWeight::automatic, asked.normals = true, asked.tangents = false;
    const AttributePlan grouped = group(meshes, asked, context);
    const Plan& plan = grouped.impl();
    const AttributeInput input = check_input(meshes, context);
    VoteSums sums = sum_votes(plan.topology, input, asked, context);
    sum_groups(sums, plan.groups, plan.topology, input, asked, context);
    GeneralScratch scratch;
    NormalChoices choices;
    fit_normals(sums, plan.topology, input, asked, scratch, context, &choices);
    return choices;
}

std::vector<MeshAttributes> compute_attributes(std::span<const AttributeMesh> meshes, const AttributeOptions& options,
                                               Context& context) {
    check_options(options);
    if (geometry::takes_fast_path(meshes, options)) return geometry::fast_attributes(meshes, options, context);
    return geometry::general_attributes(meshes, options, context);
}

struct AttributeWorkspace::Impl {
    geometry::FastScratch scratch;
    geometry::GeneralScratch general;
    Impl() { scratch.general.is_kept = general.is_kept = true; }
};

AttributeWorkspace::AttributeWorkspace() : impl_(std::make_unique<Impl>()) {}
AttributeWorkspace::AttributeWorkspace(AttributeWorkspace&&) noexcept = default;
AttributeWorkspace& AttributeWorkspace::operator=(AttributeWorkspace&&) noexcept = default;
AttributeWorkspace::~AttributeWorkspace() = default;
std::size_t AttributeWorkspace::bytes() const { return impl_ ? impl_->scratch.bytes() + impl_->general.bytes() : 0; }
AttributeWorkspace::Impl& AttributeWorkspace::impl() {
    if (!impl_) impl_ = std::make_unique<Impl>();
    return *impl_;
}

std::vector<SplitAttributes> compute_attributes_into(std::span<const AttributeMesh> meshes,
                                                     const AttributeOptions& options,
                                                     std::span<const AttributeBuffers> out,
                                                     AttributeWorkspace& workspace, Context& context) {
    geometry::check_options(options);
    check_buffers(meshes, options, out);
    if (geometry::takes_fast_path(meshes, options))
        return geometry::fast_attributes(meshes, options, out, workspace.impl().scratch, context);
    return geometry::general_attributes_into(meshes, options, out, workspace.impl().general, context);
}

}  // namespace rakelight
