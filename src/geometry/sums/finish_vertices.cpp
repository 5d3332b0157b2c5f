// SPDX-License-Identifier: Apache-2.0
#include "geometry/sums/finish_vertices.h"

#include <cmath>

#include "geometry/input/face_vote.h"
#include "geometry/input/orthogonality.h"
#include "geometry/input/perpendicular.h"

namespace rakelight::geometry {
namespace {

constexpr dvec3 no_normal{0, 0, 1};

}  // namespace

dvec3 to_object(const Placement& placement, dvec3 normal) {
    const dvec3 back = times_transposed(placement.linear, normal);
    const Direction direction = direction_of(back);
    if (direction.length > 1e-12 * placement.scale) return direction.unit;
    return normalize_or(times_transposed(placement.normal_to_world, normal), no_normal);
}

namespace {

struct TangentRules {
    bool orthogonal;  // Gram-Schmidt
    float* skew;      // [degrees] out: deviation of the sum from perpendicular; may be null
};

vec4 tangent_of(const Placement& placement, const TangentRow& row, dvec3 normal, dvec3 object_normal,
                TangentRules rules) {
    dvec3 t = row.tangent - normal * dot(normal, row.tangent);
    const bool vanished = !(length(t) > cancelled_share * std::fabs(row.hand));
    if (vanished)
        t = perpendicular(normal);
    else if (rules.skew)
        *rules.skew = float(skew_deg(normal, direction_of(row.tangent).unit));
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
        : sums_(sums),
          input_(input),
          options_(options),
          topology_(topology),
          appended_base_(appended_base(topology, input)),
          skew_(options.measure_orthogonality && sums.has_tangents() ? topology.group.size() : 0, 0) {}

    std::uint32_t appended(std::uint32_t m) const { return appended_base_[m + 1] - appended_base_[m]; }

    void allocate(std::uint32_t m, MeshAttributes& out) const {
        const std::size_t own = input_.meshes[m].positions.size(), count = own + appended(m);
        out.normals.resize(count);
        if (makes_tangents(m)) out.tangents.resize(count);
        describe(m, out);
        if (count == own) return;
        out.indices.resize(input_.meshes[m].indices.size());
        for (std::size_t i = 0; i < out.indices.size(); ++i) out.indices[i] = vertex_of(m, i);
    }

    void allocate(std::uint32_t m, SplitAttributes& out) const {
        out.normals.resize(appended(m));
        if (makes_tangents(m)) out.tangents.resize(appended(m));
        describe(m, out);
        const std::span<const std::uint32_t> indices = input_.meshes[m].indices;
        for (std::size_t i = 0; i < indices.size() && appended(m) != 0; ++i)
            if (const std::uint32_t v = vertex_of(m, i); v != indices[i]) out.corners.push_back({std::uint32_t(i), v});
    }

    // Output positions of a mesh's vertices: the input's, and the appended ones.
    struct Target {
        vec3 *normals, *more_normals;
        vec4 *tangents, *more_tangents;
    };
    Target target(std::uint32_t m, MeshAttributes& out) const {
        const std::size_t own = input_.meshes[m].positions.size(), own_tangents = makes_tangents(m) ? own : 0;
        return {out.normals.data(), out.normals.data() + own, out.tangents.data(), out.tangents.data() + own_tangents};
    }
    static Target target(const AttributeBuffers& out, SplitAttributes& split) {
        return {out.normals.data(), split.normals.data(), out.tangents.data(), split.tangents.data()};
    }

    /// @param target_of  mesh -> Target
    template <class TargetOf>
    void vertices(const Chunk& chunk, const TargetOf& target_of, Cancelled& cancelled) {
        for_each_range(chunk, input_.vertex_base, [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
            const Target to = target_of(m);
            for (std::uint32_t v = first; v != last; ++v)
                vertex(m, input_.vertex_base[m] + v, v, to.normals + v, to.tangents + (makes_tangents(m) ? v : 0),
                       cancelled);
        });
        for_each_range(chunk, appended_base_, [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
            const Target to = target_of(m);
            for (std::uint32_t a = first; a != last; ++a) {
                const std::uint32_t row = appended_base_[m] + a, source = topology_.source[row] - input_.vertex_base[m];
                vertex(m, input_.vertex_count() + row, source, to.more_normals + a,
                       to.more_tangents + (makes_tangents(m) ? a : 0), cancelled);
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

    // Local vertex index of a corner.
    std::uint32_t vertex_of(std::uint32_t m, std::size_t corner) const {
        const std::uint32_t fixed = input_.vertex_count(), base = input_.vertex_base[m];
        const std::uint32_t v = topology_.corner_vertex[3 * std::size_t(input_.triangle_base[m]) + corner];
        return v < fixed ? v - base : input_.vertex_base[m + 1] - base + (v - fixed - appended_base_[m]);
    }

    template <class Out>
    void describe(std::uint32_t m, Out& out) const {
        out.degenerate_faces = sums_.degenerate_faces[m];
        out.isolated_vertices = sums_.isolated_vertices[m];
        out.source_vertex.reserve(appended(m));
        for (std::uint32_t a = appended_base_[m]; a != appended_base_[m + 1]; ++a)
            out.source_vertex.push_back(topology_.source[a] - input_.vertex_base[m]);
    }

    void vertex(std::uint32_t m, std::uint32_t row, std::uint32_t source, vec3* to_normal, vec4* to_tangent,
                Cancelled& cancelled) {
        const NormalRow& sum = sums_.normals[row];
        const Placement& placement = input_.placements[m];
        dvec3 normal, object_normal = no_normal;
        if (!options_.normals || is_locked(input_.meshes[m], source)) {
            const vec3 given = input_.meshes[m].normals[source];
            normal = given_normal(placement, given);
            if (normal != dvec3{}) object_normal = direction_of(cast<double>(given)).unit;
            const double square = dot(cast<double>(given), cast<double>(given));
            const bool is_unit = std::fabs(square - 1) < 1e-5;  // kept bit-identical
            *to_normal = is_unit ? given : cast<float>(object_normal);
        } else {
            if (sum.weight > 0) {
                if (has_cancelled(sum))
                    cancelled.push_back(row);
                else
                    normal = direction_of(sum.normal).unit;
            }
            if (normal != dvec3{}) object_normal = to_object(placement, normal);
            *to_normal = cast<float>(object_normal);
        }
        if (!makes_tangents(m)) return;
        const TangentRules rules{options_.orthogonalize == Orthogonalize::attribute,
                                 skew_.empty() ? nullptr : &skew_[row]};
        if (normal != dvec3{})
            *to_tangent = tangent_of(placement, sums_.tangents[row], normal, object_normal, rules);
        else
            *to_tangent = {1, 0, 0, 1};
    }

    const VoteSums& sums_;
    const AttributeInput& input_;
    const AttributeOptions& options_;
    const Topology& topology_;
    std::vector<std::uint32_t> appended_base_;
    std::vector<float> skew_;  // [output vertices] degrees, or empty
};

template <class Out, class TargetOf>
Cancelled finish_all(Finish& finish, const AttributeInput& input, std::vector<Out>& out, const TargetOf& target_of,
                     Context& context) {
    out.clear();
    out.resize(input.meshes.size());
    const std::vector<Chunk> chunks = make_chunks(input.vertex_base, vertices_per_chunk);
    context.parallel_for(chunks.size(), [&](std::size_t c) {
        if (chunks[c].piece != 0) return;  // one thread per mesh allocates
        for (std::uint32_t m = chunks[c].mesh_begin; m != chunks[c].mesh_end; ++m) finish.allocate(m, out[m]);
    });
    std::vector<Cancelled> cancelled(chunks.size());
    context.parallel_for(chunks.size(), [&](std::size_t c) { finish.vertices(chunks[c], target_of, cancelled[c]); });
    Cancelled all;
    for (const Cancelled& part : cancelled) all.insert(all.end(), part.begin(), part.end());
    return all;
}

}  // namespace

Cancelled finish_vertices(const VoteSums& sums, const Topology& topology, const AttributeInput& input,
                          const AttributeOptions& options, std::vector<MeshAttributes>& out, Context& context) {
    Finish finish(sums, topology, input, options);
    Cancelled cancelled = finish_all(
        finish, input, out, [&](std::uint32_t m) { return finish.target(m, out[m]); }, context);
    context.parallel_for(input.meshes.size(), [&](std::size_t m) { finish.measure(std::uint32_t(m), out[m]); });
    return cancelled;
}

Cancelled finish_vertices(const VoteSums& sums, const Topology& topology, const AttributeInput& input,
                          const AttributeOptions& options, std::span<const AttributeBuffers> out,
                          std::vector<SplitAttributes>& splits, Context& context) {
    Finish finish(sums, topology, input, options);
    return finish_all(
        finish, input, splits, [&](std::uint32_t m) { return Finish::target(out[m], splits[m]); }, context);
}

}  // namespace rakelight::geometry
