// SPDX-License-Identifier: Apache-2.0
#include "geometry/fast/fast_hard_places.h"

#include "geometry/fast/fast_stages.h"
#include "geometry/general_attributes.h"

namespace rakelight::geometry {

HardPlaces::HardPlaces(FastState& state, std::span<const std::uint32_t> wanted)
    : state_(state), input_(state.input), wanted_(wanted), marks_(state.input.vertex_count(), wanted) {
    constexpr std::uint64_t bytes_per_vertex = 400;  // with six faces, as they are here
    state_.context.memory().check(bytes_per_vertex * wanted.size(), "smoothing normals at creases");
    collect_faces();
    state_.context.parallel_for(parts_.size(), [&](std::size_t p) { number(parts_[p]); });
    for (const PartMesh& part : parts_) {
        AttributeMesh& mesh = meshes_.emplace_back();
        mesh.object = input_.meshes[part.mesh].object;
        mesh.positions = part.positions;
        mesh.texcoords = part.texcoords;
        mesh.indices = part.indices;
        mesh.to_world = input_.meshes[part.mesh].to_world;
        mesh.crease_angle_rad = input_.meshes[part.mesh].crease_angle_rad;
        is_wanted_.insert(is_wanted_.end(), part.is_wanted.begin(), part.is_wanted.end());
    }
}

std::size_t HardPlaces::corners() const {
    std::size_t sum = 0;
    for (const PartMesh& part : parts_) sum += part.indices.size();
    return sum;
}

void HardPlaces::take(std::span<const MeshAttributes> results, std::span<const AttributeBuffers> out,
                      std::vector<SplitAttributes>& splits) const {
    state_.context.parallel_for(parts_.size(), [&](std::size_t p) {
        take(parts_[p], results[p], out[parts_[p].mesh], splits[parts_[p].mesh]);
    });
}

void HardPlaces::collect_faces() {
    const std::vector<FaceStretch> stretches = stretches_with(state_, wanted_);
    std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> found(stretches.size());  // mesh, face
    state_.context.parallel_for(stretches.size(), [&](std::size_t s) {
        for_each_marked_face(input_, marks_, stretches[s],
                             [&](std::uint32_t m, std::uint32_t t) { found[s].emplace_back(m, t); });
    });
    std::vector<std::uint32_t> part_of(input_.meshes.size(), 0xffffffffu);
    const auto part = [&](std::uint32_t m) -> PartMesh& {
        if (part_of[m] == 0xffffffffu) {
            part_of[m] = std::uint32_t(parts_.size());
            parts_.emplace_back().mesh = m;
        }
        return parts_[part_of[m]];
    };
    for (std::size_t i = 0; i < wanted_.size();) {  // also those that no face uses; in the order of the meshes
        const std::uint32_t m = input_.mesh_of_vertex(wanted_[i]);
        for (; i < wanted_.size() && wanted_[i] < input_.vertex_base[m + 1]; ++i)
            part(m).vertices.push_back(wanted_[i] - input_.vertex_base[m]);
    }
    for (const auto& list : found)
        for (const auto& [m, t] : list) part(m).faces.push_back(t);
}

void HardPlaces::number(PartMesh& part) const {
    const AttributeMesh& mesh = input_.meshes[part.mesh];
    MarkedVertices marks(mesh.positions.size(), part.vertices);
    for (const std::uint32_t t : part.faces)
        for (std::size_t k = 0; k < 3; ++k) marks.mark(mesh.indices[3 * std::size_t(t) + k]);
    const VertexRanks ranks(marks);
    part.vertices = ranks.all();
    part.positions.reserve(part.vertices.size());
    part.is_wanted.reserve(part.vertices.size());
    part.indices.reserve(3 * part.faces.size());
    for (const std::uint32_t v : part.vertices) {
        part.positions.push_back(mesh.positions[v]);
        if (!mesh.texcoords.empty()) part.texcoords.push_back(mesh.texcoords[v]);
        part.is_wanted.push_back(is_wanted(input_.vertex_base[part.mesh] + v) ? 1 : 0);
    }
    for (const std::uint32_t t : part.faces)
        for (std::size_t k = 0; k < 3; ++k) part.indices.push_back(ranks.rank(mesh.indices[3 * std::size_t(t) + k]));
}

void HardPlaces::take(const PartMesh& part, const MeshAttributes& result, const AttributeBuffers& out,
                      SplitAttributes& split) const {
    const std::uint32_t count = std::uint32_t(part.vertices.size());
    const bool has_tangents = !result.tangents.empty();
    for (std::uint32_t v = 0; v < count; ++v) {
        if (part.is_wanted[v] == 0) continue;
        out.normals[part.vertices[v]] = result.normals[v];
        if (has_tangents) out.tangents[part.vertices[v]] = result.tangents[v];
    }
    std::vector<std::uint32_t> appended(result.source_vertex.size());  // index in the whole mesh
    for (std::size_t a = 0; a < appended.size(); ++a) {
        const std::uint32_t source = result.source_vertex[a];
        if (part.is_wanted[source] == 0) continue;
        appended[a] = std::uint32_t(input_.meshes[part.mesh].positions.size() + split.source_vertex.size());
        split.source_vertex.push_back(part.vertices[source]);
        split.normals.push_back(result.normals[count + a]);
        if (has_tangents) split.tangents.push_back(result.tangents[count + a]);
    }
    for (std::size_t i = 0; i < result.indices.size(); ++i) {
        if (result.indices[i] < count || part.is_wanted[part.indices[i]] == 0) continue;
        split.corners.push_back({3 * part.faces[i / 3] + std::uint32_t(i % 3), appended[result.indices[i] - count]});
    }
}

void redo_places(FastState& state, std::span<const std::uint32_t> vertices, std::span<const AttributeBuffers> out,
                 std::vector<SplitAttributes>& splits) {
    const HardPlaces places(state, vertices);
    places.take(
        general_attributes(places.meshes(), state.options, places.wanted(), state.scratch.general, state.context), out,
        splits);
}

}  // namespace rakelight::geometry
