// SPDX-License-Identifier: Apache-2.0
#include "geometry/faults/mesh_faults.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/cancel_check.h"
#include "geometry/input/face_vote.h"

namespace rakelight::geometry {
namespace {

// Bits of what was seen at a vertex or a place.
constexpr std::uint8_t used = 1, plain = 2, mirrored = 4, both = plain | mirrored;

class Faults {
public:
    Faults(const PlacedMeshes& placed, std::uint32_t objects, const Context& context)
        : placed_(placed),
          check_cancel_(context),
          faults_(objects),
          at_vertex_(placed.input.vertex_count(), 0),
          at_place_(placed.input.vertex_count(), 0) {}

    std::vector<ObjectFaults> run() {
        const auto& meshes = placed_.input.meshes;
        std::vector<std::uint32_t> order(meshes.size());  // groups the meshes of an object
        std::iota(order.begin(), order.end(), 0u);
        std::stable_sort(order.begin(), order.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return meshes[a].object < meshes[b].object; });
        for (std::size_t i = 0; i < order.size();) {
            const std::uint32_t object = meshes[order[i]].object;
            std::size_t end = i;
            for (; end < order.size() && meshes[order[end]].object == object; ++end) {
                mark_faces(order[end], faults_[object]);
                count_vertices(order[end], faults_[object]);
            }
            for (; i < end; ++i) clear_places(order[i]);  // the next object may have the same places
        }
        return std::move(faults_);
    }

private:
    void mark_faces(std::uint32_t m, ObjectFaults& faults) {
        const AttributeMesh& mesh = placed_.input.meshes[m];
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            check_cancel_();
            const std::uint32_t* index = &mesh.indices[i];
            const bool degenerate = !(face_normal(placed_.input.placements[m], face_corners(mesh, index)).length > 0);
            faults.degenerate_faces += degenerate;
            std::uint8_t seen = used;
            if (!degenerate && !mesh.texcoords.empty()) {
                const double sign = texture_edges(mesh, index).sign;
                seen = std::uint8_t(used | (sign > 0 ? plain : sign < 0 ? mirrored : 0));
            }
            for (std::size_t k = 0; k < 3; ++k) mark(placed_.input.vertex_base[m] + index[k], seen, faults);
        }
    }

    void mark(std::uint32_t vertex, std::uint8_t seen, ObjectFaults& faults) {
        std::uint8_t& place = at_place_[placed_.place[vertex]];
        const bool was = (place & both) == both;
        place |= seen;
        faults.mirrored_places += !was && (place & both) == both;
        at_vertex_[vertex] |= seen;
    }

    void count_vertices(std::uint32_t m, ObjectFaults& faults) const {
        const AttributeMesh& mesh = placed_.input.meshes[m];
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            const std::uint8_t seen = at_vertex_[placed_.input.vertex_base[m] + v];
            faults.mirror_split_vertices += (seen & both) == both;
            if (!seen || mesh.normals.empty()) continue;
            const double size = length(cast<double>(mesh.normals[v]));
            if (!is_finite(mesh.normals[v]))
                ++faults.non_finite_normals;
            else if (size == 0)
                ++faults.zero_normals;
            else if (!(std::fabs(size - 1) <= unit_length_slack))
                ++faults.non_unit_normals;
        }
    }

    void clear_places(std::uint32_t m) {
        for (std::uint32_t v = placed_.input.vertex_base[m]; v < placed_.input.vertex_base[m + 1]; ++v)
            at_place_[placed_.place[v]] = 0;
    }

    const PlacedMeshes& placed_;
    CancelCheck check_cancel_;
    std::vector<ObjectFaults> faults_;
    std::vector<std::uint8_t> at_vertex_, at_place_;
};

}  // namespace

std::vector<ObjectFaults> count_faults(const PlacedMeshes& placed, std::uint32_t objects, const Context& context) {
    return Faults(placed, objects, context).run();
}

}  // namespace rakelight::geometry
