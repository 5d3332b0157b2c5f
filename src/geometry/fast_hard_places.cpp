// SPDX-License-Identifier: Apache-2.0
#include "geometry/fast_stages.h"

#include <bit>

#include "geometry/fast_attributes.h"

namespace rakelight::geometry {
namespace {

// The part of one mesh that touches the places, with local indices.
struct PartMesh {
    std::uint32_t mesh = 0;
    std::vector<std::uint32_t> faces;     ///< of the mesh, ascending
    std::vector<std::uint32_t> vertices;  ///< of the mesh, ascending
    std::vector<std::uint8_t> is_wanted;  ///< [vertices]
    std::vector<vec3> positions;
    std::vector<vec2> texcoords;
    std::vector<std::uint32_t> indices;
};

// Numbers the marked vertices of a mesh from 0 on, in their order.
class VertexRanks {
public:
    explicit VertexRanks(std::size_t vertices) : words_(vertices / 64 + 1), before_(vertices / 64 + 1) {}
    void mark(std::uint32_t v) { words_[v >> 6] |= std::uint64_t(1) << (v & 63); }
    /// All marked ones, ascending; rank() holds from now on.
    std::vector<std::uint32_t> count() {
        std::vector<std::uint32_t> marked;
        for (std::size_t w = 0; w < words_.size(); ++w) {
            before_[w] = std::uint32_t(marked.size());
            for (std::uint64_t left = words_[w]; left != 0; left &= left - 1)
                marked.push_back(std::uint32_t(w * 64 + std::size_t(std::countr_zero(left))));
        }
        return marked;
    }
    std::uint32_t rank(std::uint32_t v) const {
        return before_[v >> 6] + std::uint32_t(std::popcount(words_[v >> 6] & ((std::uint64_t(1) << (v & 63)) - 1)));
    }

private:
    std::vector<std::uint64_t> words_;
    std::vector<std::uint32_t> before_;
};

class Redo {
public:
    Redo(FastState& state, std::span<const std::uint32_t> wanted)
        : state_(state), input_(state.input), wanted_(wanted) {}

    void run(std::span<const AttributeBuffers> out, std::vector<SplitAttributes>& splits) {
        mark();
        collect_faces();
        state_.context.parallel_for(parts_.size(), [&](std::size_t p) { number(parts_[p]); });
        std::vector<AttributeMesh> meshes;
        for (const PartMesh& part : parts_) {
            AttributeMesh& mesh = meshes.emplace_back();
            mesh.object = input_.meshes[part.mesh].object;
            mesh.positions = part.positions;
            mesh.texcoords = part.texcoords;
            mesh.indices = part.indices;
            mesh.to_world = input_.meshes[part.mesh].to_world;
        }
        const std::vector<MeshAttributes> results = general_attributes(meshes, state_.options, state_.context);
        state_.context.parallel_for(parts_.size(), [&](std::size_t p) {
            take(parts_[p], results[p], out[parts_[p].mesh], splits[parts_[p].mesh]);
        });
    }

private:
    bool is_wanted(std::uint32_t vertex) const { return (marks_[vertex >> 5] >> (vertex & 31) & 1) != 0; }

    void mark() {
        marks_.assign(std::size_t(input_.vertex_count()) / 32 + 1, 0);
        for (const std::uint32_t v : wanted_) marks_[v >> 5] |= 1u << (v & 31);
    }

    // Skips stretches of faces whose vertex range contains no marked vertex.
    void collect_faces() {
        const std::vector<std::size_t>& range_base = state_.scratch.range_base;
        std::vector<std::pair<std::uint32_t, std::uint32_t>> stretches;  // mesh, first face
        for (std::uint32_t m = 0; m < input_.meshes.size(); ++m)
            for (std::size_t r = range_base[m]; r < range_base[m + 1]; ++r) {
                const VertexRange range = state_.scratch.ranges[r];
                const auto at = std::lower_bound(wanted_.begin(), wanted_.end(), input_.vertex_base[m] + range.first);
                if (at != wanted_.end() && *at <= input_.vertex_base[m] + range.last)
                    stretches.emplace_back(m, std::uint32_t(r - range_base[m]) * faces_per_range);
            }
        std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> found(stretches.size());  // mesh, face
        state_.context.parallel_for(stretches.size(), [&](std::size_t s) {
            const auto [m, first] = stretches[s];
            const std::uint32_t base = input_.vertex_base[m],
                                faces = std::uint32_t(input_.meshes[m].indices.size() / 3);
            const std::uint32_t* index = input_.meshes[m].indices.data();
            for (std::uint32_t t = first; t < std::min(faces, first + faces_per_range); ++t) {
                const std::uint32_t* corner = index + 3 * std::size_t(t);
                if (is_wanted(base + corner[0]) || is_wanted(base + corner[1]) || is_wanted(base + corner[2]))
                    found[s].emplace_back(m, t);
            }
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

    void number(PartMesh& part) const {
        const AttributeMesh& mesh = input_.meshes[part.mesh];
        VertexRanks ranks(mesh.positions.size());
        for (const std::uint32_t v : part.vertices) ranks.mark(v);
        for (const std::uint32_t t : part.faces)
            for (std::size_t k = 0; k < 3; ++k) ranks.mark(mesh.indices[3 * std::size_t(t) + k]);
        part.vertices = ranks.count();
        for (const std::uint32_t v : part.vertices) {
            part.positions.push_back(mesh.positions[v]);
            if (!mesh.texcoords.empty()) part.texcoords.push_back(mesh.texcoords[v]);
            part.is_wanted.push_back(is_wanted(input_.vertex_base[part.mesh] + v) ? 1 : 0);
        }
        for (const std::uint32_t t : part.faces)
            for (std::size_t k = 0; k < 3; ++k)
                part.indices.push_back(ranks.rank(mesh.indices[3 * std::size_t(t) + k]));
    }

    void take(const PartMesh& part, const MeshAttributes& result, const AttributeBuffers& out,
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
            split.corners.push_back(
                {3 * part.faces[i / 3] + std::uint32_t(i % 3), appended[result.indices[i] - count]});
        }
    }

    FastState& state_;
    const AttributeInput& input_;
    std::span<const std::uint32_t> wanted_;
    std::vector<std::uint32_t> marks_;  // a bit per vertex
    std::vector<PartMesh> parts_;
};

}  // namespace

void redo_places(FastState& state, std::span<const std::uint32_t> vertices, std::span<const AttributeBuffers> out,
                 std::vector<SplitAttributes>& splits) {
    Redo(state, vertices).run(out, splits);
}

}  // namespace rakelight::geometry
