// SPDX-License-Identifier: Apache-2.0
// Tangents and bitangents of the published method: averaged over all faces at a place, mirrored or not, then
// Gram-Schmidt of the tangent only, then the handedness test against the bitangent. docs/attributes.md has the method.
#include <numeric>

#include "geometry/input/face_vote.h"
#include "geometry/input/orthogonality.h"
#include "geometry/input/perpendicular.h"
#include "geometry/sums/vote_sums.h"
#include "geometry/tangents/tangent_modes.h"
#include "geometry/weld/position_weld.h"

namespace rakelight::geometry {
namespace {

struct Pair {
    dvec3 tangent, bitangent;
};

// Tangent and bitangent of one face in world space, unit; zero without area in space or in the texture. The bitangent
// is -dP/dv.
Pair face_pair(const AttributeMesh& mesh, const std::uint32_t* index, const Placement& placement) {
    const FaceCorners face = face_corners(mesh, index);
    if (!(face_normal(placement, face).length > 0)) return {};
    const TextureEdges e = texture_edges(mesh, index);
    if (e.sign == 0) return {};
    const Direction t = direction_of(placement.linear * ((face.e1 * e.dv2 - face.e2 * e.dv1) * e.sign));
    const Direction b = direction_of(placement.linear * ((face.e1 * e.du2 - face.e2 * e.du1) * e.sign));
    if (!(t.length > 0 && b.length > 0)) return {};
    return {t.unit, b.unit};
}

class Published {
public:
    Published(const AttributePlan::Impl& plan, const AttributeInput& input, Context& context)
        : options_(plan.options),
          input_(input),
          context_(context),
          places_(places_of(plan)),
          appended_base_(appended_base(places_, input)),
          sums_(places_.group.size()) {}

    void sum() {
        const CornerBins bins = bin_corners(places_, input_, {}, context_);
        constexpr std::size_t step = vertices_per_chunk;
        context_.parallel_for((sums_.size() + step - 1) / step, [&](std::size_t c) {
            for (std::size_t g = c * step; g < std::min(sums_.size(), (c + 1) * step); ++g)
                for (std::uint32_t i = bins.begin[g]; i != bins.begin[g + 1]; ++i)
                    if (i == bins.begin[g] || bins.corners[i] / 3 != bins.corners[i - 1] / 3)
                        add_face(bins.corners[i] / 3, sums_[g]);
        });
    }

    void finish(std::uint32_t m, MeshAttributes& out) const {
        if (input_.meshes[m].texcoords.empty()) return;
        const std::uint32_t own = std::uint32_t(input_.meshes[m].positions.size());
        OrthogonalityLoss loss;
        out.tangents.resize(out.normals.size());
        out.bitangents.resize(out.normals.size());
        for (std::uint32_t v = 0; v < out.normals.size(); ++v) {
            const std::uint32_t row =
                v < own ? input_.vertex_base[m] + v : input_.vertex_count() + appended_base_[m] + (v - own);
            vertex(m, sums_[places_.group[row]], v, out, loss);
        }
        if (options_.measure_orthogonality) loss.tell(out);
        count_inverted(input_.meshes[m], out);
    }

private:
    // The plan's vertices, grouped by place alone (scope face: as the normals are).
    Topology places_of(const AttributePlan::Impl& plan) const {
        Topology places = copy_of(plan.topology, input_);
        if (options_.scope == Scope::face) {
            if (!options_.normals) std::iota(places.group.begin(), places.group.end(), 0u);  // each vertex separately
            return places;
        }
        if (!options_.normals)  // the plan's classes then also have equal normals
            places.places = std::make_shared<const std::vector<std::uint32_t>>(
                weld_positions(input_, {.object = options_.scope != Scope::model, .normal = false}, context_));
        for (std::uint32_t v = 0; v < places.group.size(); ++v)
            places.group[v] = (*places.places)[places.source_of(input_, v)];
        return places;
    }

    void add_face(std::uint32_t triangle, Pair& sum) const {
        const std::uint32_t m = input_.mesh_of_triangle(triangle), t = triangle - input_.triangle_base[m];
        if (input_.meshes[m].texcoords.empty()) return;
        const Pair face =
            face_pair(input_.meshes[m], &input_.meshes[m].indices[3 * std::size_t(t)], input_.placements[m]);
        sum.tangent += face.tangent;
        sum.bitangent += face.bitangent;
    }

    // Division by the number of faces does not change the direction, so sums are only normalized.
    void vertex(std::uint32_t m, const Pair& sum, std::uint32_t v, MeshAttributes& out, OrthogonalityLoss& loss) const {
        const Placement& placement = input_.placements[m];
        const dvec3 object_normal = cast<double>(out.normals[v]);
        dvec3 normal = given_normal(placement, out.normals[v]);
        if (normal == dvec3{}) normal = object_normal;
        const dvec3 summed = unit_of(sum.tangent), bitangent = unit_of(sum.bitangent);
        dvec3 t = direction_of(summed - normal * dot(normal, summed)).unit;
        loss.add(summed != dvec3{} ? skew_deg(normal, summed) : 0);
        const bool orthogonal = options_.orthogonalize == Orthogonalize::attribute || t == dvec3{};
        if (t == dvec3{}) t = perpendicular(normal);
        if (!orthogonal) t = summed;
        double hand = dot(cross(normal, t), bitangent) < 0 ? -1 : 1;
        if (hand < 0 && options_.tangent_mode == TangentMode::published) t = -t, hand = 1;
        const dvec3 b = bitangent != dvec3{} ? bitangent : cross(normal, t) * hand;
        dvec3 back = to_object(placement, t);
        if (orthogonal) back = direction_of(back - object_normal * dot(object_normal, back)).unit;
        if (back == dvec3{}) back = perpendicular(object_normal);
        out.tangents[v] = {float(back.x), float(back.y), float(back.z), float(placement.flip * hand)};
        const dvec3 b_back = to_object(placement, b), crossed = cross(object_normal, back) * (placement.flip * hand);
        out.bitangents[v] = cast<float>(b_back != dvec3{} ? b_back : direction_of(crossed).unit);
    }

    // In object space, like the output.
    static void count_inverted(const AttributeMesh& mesh, MeshAttributes& out) {
        const Placement still{.to_world = {}, .linear = upper_left(dmat4{}), .normal_to_world = upper_left(dmat4{})};
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            const Pair face = face_pair(mesh, &mesh.indices[i], still);
            double along_u = 0, along_v = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t v = out.indices.empty() ? mesh.indices[i + k] : out.indices[i + k];
                const dvec3 t = cast<double>(out.tangents[v].xyz());
                along_u += dot(t, face.tangent);
                along_v += dot(cross(cast<double>(out.normals[v]), t), face.bitangent) * double(out.tangents[v].w);
            }
            out.inverted_faces += along_u < 0 || along_v < 0;
        }
    }

    static dvec3 unit_of(dvec3 sum) { return length(sum) > cancelled_share ? direction_of(sum).unit : dvec3{}; }
    static dvec3 to_object(const Placement& placement, dvec3 direction) {
        return direction_of(times_transposed(placement.normal_to_world, direction)).unit;
    }

    const AttributeOptions& options_;
    const AttributeInput& input_;
    Context& context_;
    Topology places_;
    std::vector<std::uint32_t> appended_base_;
    std::vector<Pair> sums_;  // [output vertices] filled at representatives of places
};

}  // namespace

void add_published(std::vector<MeshAttributes>& meshes, const AttributePlan::Impl& plan, const AttributeInput& input,
                   Context& context) {
    const std::uint64_t corners = 3 * std::uint64_t(input.triangle_count());
    context.memory().check(plan.topology.group.size() * (sizeof(Pair) + 32) + corners * 12, "published tangents");
    Published published(plan, input, context);
    published.sum();
    context.parallel_for(meshes.size(), [&](std::size_t m) { published.finish(std::uint32_t(m), meshes[m]); });
}

}  // namespace rakelight::geometry
