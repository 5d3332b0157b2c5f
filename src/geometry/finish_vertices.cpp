// SPDX-License-Identifier: Apache-2.0
#include "geometry/finish_vertices.h"

#include <cmath>

#include "geometry/face_vote.h"
#include "geometry/orthogonality.h"
#include "geometry/perpendicular.h"

namespace rakelight::geometry {
namespace {

constexpr dvec3 no_normal{0, 0, 1};

// A matrix that flattens has no inverse; its normals lie along the only direction that its cofactor matrix takes anywhere.
dvec3 to_object(const Placement& placement, dvec3 normal) {
    const dvec3 back = times_transposed(placement.linear, normal);
    const Direction direction = direction_of(back);
    if (direction.length > 1e-12 * placement.scale) return direction.unit;
    return normalize_or(times_transposed(placement.normal_to_world, normal), no_normal);
}

struct TangentRules {
    bool orthogonal;  // Gram-Schmidt
    float* skew;      // [degrees] out: how far the sum is from perpendicular; or null
};

vec4 tangent_of(const Placement& placement, const TangentRow& row, dvec3 normal, dvec3 object_normal, TangentRules rules) {
    dvec3 t = row.tangent - normal * dot(normal, row.tangent);
    const bool vanished = !(length(t) > cancelled_share * std::fabs(row.hand));
    if (vanished) t = perpendicular(normal);
    else if (rules.skew) *rules.skew = float(skew_deg(normal, direction_of(row.tangent).unit));
    const bool orthogonal = rules.orthogonal || vanished;
    dvec3 back = times_transposed(placement.normal_to_world, orthogonal ? t : row.tangent);
    back = direction_of(back).unit;
    if (orthogonal) back = direction_of(back - object_normal * dot(object_normal, back)).unit;
    if (back == dvec3{}) back = perpendicular(object_normal);
    const double hand = row.hand * placement.flip;
    return {float(back.x), float(back.y), float(back.z), hand < 0 ? -1.0f : 1.0f};
}

class Finish {
public:
    Finish(const VoteSums& sums, const Topology& topology, const AttributeInput& input, const AttributeOptions& options)
        : sums_(sums), input_(input), options_(options), topology_(topology), appended_base_(appended_base(topology, input)),
          skew_(options.measure_orthogonality && sums.has_tangents() ? topology.group.size() : 0, 0) {}

    void allocate(std::uint32_t m, MeshAttributes& out) const {
        const std::size_t count = input_.meshes[m].positions.size() + appended_base_[m + 1] - appended_base_[m];
        out.normals.resize(count);
        if (makes_tangents(m)) out.tangents.resize(count);
        out.degenerate_faces = sums_.degenerate_faces[m];
        out.isolated_vertices = sums_.isolated_vertices[m];
        if (appended_base_[m + 1] == appended_base_[m]) return;
        const std::uint32_t fixed = input_.vertex_count(), own = input_.vertex_base[m + 1] - input_.vertex_base[m];
        out.source_vertex.reserve(count - input_.meshes[m].positions.size());
        for (std::uint32_t a = appended_base_[m]; a != appended_base_[m + 1]; ++a)
            out.source_vertex.push_back(topology_.source[a] - input_.vertex_base[m]);
        out.indices.resize(input_.meshes[m].indices.size());
        for (std::size_t i = 0; i < out.indices.size(); ++i) {
            const std::uint32_t v = topology_.corner_vertex[3 * std::size_t(input_.triangle_base[m]) + i];
            out.indices[i] = v < fixed ? v - input_.vertex_base[m] : own + (v - fixed - appended_base_[m]);
        }
    }

    void vertices(const Chunk& chunk, std::vector<MeshAttributes>& out, std::vector<std::uint32_t>& cancelled) {
        for_each_range(chunk, input_.vertex_base, [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
            for (std::uint32_t v = first; v != last; ++v) vertex(m, input_.vertex_base[m] + v, v, v, out[m], cancelled);
        });
        for_each_range(chunk, appended_base_, [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
            const std::uint32_t own = input_.vertex_base[m + 1] - input_.vertex_base[m];
            for (std::uint32_t a = first; a != last; ++a) {
                const std::uint32_t appended = appended_base_[m] + a;
                const std::uint32_t source = topology_.source[appended] - input_.vertex_base[m];
                vertex(m, input_.vertex_count() + appended, own + a, source, out[m], cancelled);
            }
        });
    }

    /// Of all vertices of a mesh, in their order.
    void measure(std::uint32_t m, MeshAttributes& out) const {
        if (skew_.empty() || out.tangents.empty()) return;
        const std::uint32_t fixed = input_.vertex_count();
        OrthogonalityLoss loss;
        for (std::uint32_t v = input_.vertex_base[m]; v != input_.vertex_base[m + 1]; ++v) loss.add(skew_[v]);
        for (std::uint32_t a = appended_base_[m]; a != appended_base_[m + 1]; ++a) loss.add(skew_[fixed + a]);
        loss.tell(out);
    }

private:
    bool makes_tangents(std::uint32_t m) const { return options_.tangents && !input_.meshes[m].texcoords.empty(); }

    void vertex(std::uint32_t m, std::uint32_t row, std::uint32_t to, std::uint32_t source, MeshAttributes& out,
                std::vector<std::uint32_t>& cancelled) {
        const NormalRow& sum = sums_.normals[row];
        const Placement& placement = input_.placements[m];
        dvec3 normal, object_normal = no_normal;
        if (!options_.normals || is_locked(input_.meshes[m], source)) {
            const vec3 given = input_.meshes[m].normals[source];
            normal = given_normal(placement, given);
            if (normal != dvec3{}) object_normal = direction_of(cast<double>(given)).unit;
            const double square = dot(cast<double>(given), cast<double>(given));
            const bool is_unit = std::fabs(square - 1) < 1e-5;  // then its very bits are kept
            out.normals[to] = is_unit ? given : cast<float>(object_normal);
        } else {
            if (sum.weight > 0) {
                if (has_cancelled(sum)) cancelled.push_back(row);
                else normal = direction_of(sum.normal).unit;
            }
            if (normal != dvec3{}) object_normal = to_object(placement, normal);
            out.normals[to] = cast<float>(object_normal);
        }
        if (!makes_tangents(m)) return;
        const TangentRules rules{options_.orthogonalize == Orthogonalize::attribute, skew_.empty() ? nullptr : &skew_[row]};
        if (normal != dvec3{}) out.tangents[to] = tangent_of(placement, sums_.tangents[row], normal, object_normal, rules);
        else out.tangents[to] = {1, 0, 0, 1};
    }

    const VoteSums& sums_;
    const AttributeInput& input_;
    const AttributeOptions& options_;
    const Topology& topology_;
    std::vector<std::uint32_t> appended_base_;
    std::vector<float> skew_;  // [output vertices] degrees, or empty
};

}  // namespace

Finished finish_vertices(const VoteSums& sums, const Topology& topology, const AttributeInput& input,
                         const AttributeOptions& options, Context& context) {
    Finish finish(sums, topology, input, options);
    Finished finished;
    finished.meshes.resize(input.meshes.size());
    const std::vector<Chunk> chunks = make_chunks(input.vertex_base, vertices_per_chunk);
    context.parallel_for(chunks.size(), [&](std::size_t c) {
        if (chunks[c].piece != 0) return;  // one thread a mesh allocates
        for (std::uint32_t m = chunks[c].mesh_begin; m != chunks[c].mesh_end; ++m) finish.allocate(m, finished.meshes[m]);
    });
    std::vector<std::vector<std::uint32_t>> cancelled(chunks.size());
    context.parallel_for(chunks.size(), [&](std::size_t c) { finish.vertices(chunks[c], finished.meshes, cancelled[c]); });
    context.parallel_for(input.meshes.size(), [&](std::size_t m) { finish.measure(std::uint32_t(m), finished.meshes[m]); });
    for (const auto& part : cancelled) finished.cancelled.insert(finished.cancelled.end(), part.begin(), part.end());
    return finished;
}

}  // namespace rakelight::geometry
