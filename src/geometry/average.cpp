// SPDX-License-Identifier: Apache-2.0
// average(): means of face values over the groups of a plan.
#include <algorithm>
#include <string>

#include "base/format_text.h"
#include "geometry/attribute_plan.h"
#include "geometry/input/corner_weights.h"
#include "geometry/sums/vote_sums.h"

namespace rakelight {
namespace {

using namespace geometry;

/// The sum over the faces at one vertex or group.
struct ValueRow {
    dvec3 sum;
    double weight = 0;
    vec3 least, most;  ///< meaningful where weight > 0
};

void add(ValueRow& to, const ValueRow& from) {
    if (!(from.weight > 0)) return;
    to.least = to.weight > 0 ? min(to.least, from.least) : from.least;
    to.most = to.weight > 0 ? max(to.most, from.most) : from.most;
    to.sum += from.sum;
    to.weight += from.weight;
}

/// Clamped to the range of the values, which rounding could leave.
vec3 mean_of(const ValueRow& row) {
    if (!(row.weight > 0)) return {};
    return min(max(cast<float>(row.sum / row.weight), row.least), row.most);
}

void check_values(const AttributePlan::Impl& plan, std::span<const AttributeMesh> meshes,
                  std::span<const std::span<const vec3>> values) {
    if (meshes.size() != plan.vertices.size() || values.size() != meshes.size())
        throw Error(ErrorCode::bad_file, format_text("{} meshes and values of {}, but {} meshes were grouped",
                                                     meshes.size(), values.size(), plan.vertices.size()));
    for (std::size_t m = 0; m < meshes.size(); ++m)
        if (meshes[m].positions.size() != plan.vertices[m] || meshes[m].indices.size() / 3 != plan.triangles[m] ||
            values[m].size() != plan.triangles[m])
            throw Error(ErrorCode::bad_file, "not the mesh that was grouped, or not a value for each triangle",
                        format_text("mesh {}", m));
}

/// Each corner belongs to the vertex of the plan, so meshes can be summed in parallel.
class ValueSums {
public:
    ValueSums(const AttributePlan::Impl& plan, const AttributeInput& input, Context& context)
        : plan_(plan),
          input_(input),
          charge_(context.memory(), plan.topology.group.size() * sizeof(ValueRow), "averaging values"),
          rows_(plan.topology.group.size()) {}

    void add_faces(std::uint32_t m, std::span<const vec3> values) {
        const AttributeMesh& mesh = input_.meshes[m];
        const Placement& placement = input_.placements[m];
        for (std::uint32_t t = 0; t < values.size(); ++t) {
            const FaceCorners face = face_corners(mesh, mesh.indices.data() + 3 * std::size_t(t));
            const Direction normal = face_normal(placement, face);
            if (!(normal.length > 0)) continue;
            const dvec3 weights = corner_weights(plan_.options.weight, placement, face, normal.length);
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t corner = 3 * (input_.triangle_base[m] + t) + k;
                add(rows_[plan_.topology.vertex_of(input_, m, corner)],
                    {cast<double>(values[t]) * weights[k], weights[k], values[t], values[t]});
            }
        }
    }

    void add_groups() {
        const VertexGroups& groups = plan_.groups;
        for (std::size_t g = 0; g < groups.size(); ++g) {
            ValueRow sum;
            for (std::uint32_t i = groups.begin[g]; i < groups.begin[g + 1]; ++i) add(sum, rows_[groups.members[i]]);
            for (std::uint32_t i = groups.begin[g]; i < groups.begin[g + 1]; ++i) rows_[groups.members[i]] = sum;
        }
    }

    /// Those of the input's vertices, then of the appended ones.
    std::vector<vec3> means(std::uint32_t m, const std::vector<std::uint32_t>& appended) const {
        std::vector<vec3> out;
        out.reserve(plan_.vertices[m] + appended[m + 1] - appended[m]);
        for (std::uint32_t v = input_.vertex_base[m]; v < input_.vertex_base[m + 1]; ++v)
            out.push_back(mean_of(rows_[v]));
        for (std::uint32_t a = appended[m]; a < appended[m + 1]; ++a)
            out.push_back(mean_of(rows_[input_.vertex_count() + a]));
        return out;
    }

private:
    const AttributePlan::Impl& plan_;
    const AttributeInput& input_;
    MemoryCharge charge_;
    std::vector<ValueRow> rows_;  ///< [output vertices]
};

}  // namespace

std::vector<std::vector<vec3>> average(const AttributePlan& plan, std::span<const AttributeMesh> meshes,
                                       std::span<const std::span<const vec3>> values, Context& context) {
    const AttributePlan::Impl& impl = plan.impl();
    check_values(impl, meshes, values);
    const AttributeInput input = check_input(meshes, context);
    ValueSums sums(impl, input, context);
    context.parallel_for(meshes.size(), [&](std::size_t m) { sums.add_faces(std::uint32_t(m), values[m]); });
    sums.add_groups();
    const std::vector<std::uint32_t> appended = appended_base(impl.topology, input);
    std::vector<std::vector<vec3>> out(meshes.size());
    context.parallel_for(meshes.size(), [&](std::size_t m) { out[m] = sums.means(std::uint32_t(m), appended); });
    return out;
}

}  // namespace rakelight
