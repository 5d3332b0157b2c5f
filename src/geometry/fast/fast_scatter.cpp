// SPDX-License-Identifier: Apache-2.0
#include "geometry/fast/fast_scatter.h"

#include "geometry/input/corner_weights.h"
#include "geometry/input/face_vote.h"

namespace rakelight::geometry {
namespace {

/// Unit normals and tangents of faces, times the weights of their corners.
template <int row_floats>
class Votes {
public:
    static constexpr int floats = row_floats;
    static constexpr bool counts_degenerate = true;
    explicit Votes(const FastState& state) : state_(state) {}

    float* data() const { return state_.scratch.rows.data(); }
    /// Hashes positions for the weld while they are in the cache.
    void ready(LaneScratch& lane, std::uint32_t m, std::uint32_t first, std::uint32_t last) const {
        hash_places(state_, lane, m, first, last);
    }
    void set(ScatterJob& job, std::uint32_t m) const {
        job.texcoords = state_.is_textured(m) ? &state_.input.meshes[m].texcoords[0].x : nullptr;
        job.weight = VoteWeight(sum_weight(state_.options.weight));
    }
    auto kernel() const {
        return floats == tangent_row_floats ? state_.kernels.scatter_tangents : state_.kernels.scatter_normals;
    }

    // In double, like the general path.
    bool add_odd(const ScatterJob& job, std::uint32_t m, std::uint32_t face, FastParcel<floats> (&parcels)[3]) const {
        const AttributeMesh& mesh = state_.input.meshes[m];
        const std::uint32_t* index = &mesh.indices[3 * std::size_t(face)];
        const FaceCorners corners = face_corners(mesh, index);
        const Direction normal = direction_of(cross(corners.e1, corners.e2));
        if (!(normal.length > 0)) return false;
        const dvec3 weights = corner_weights(state_.options.weight, Placement{}, corners, normal.length);
        FaceTangent tangent;
        if (job.texcoords != nullptr) tangent = face_tangent(mesh, index, Placement{}, corners);
        for (std::size_t k = 0; k < 3; ++k) {
            float(&row)[floats] = parcels[k].row;
            put(row, normal.unit * weights[k]);
            if constexpr (floats == tangent_row_floats) {
                row[3] = float(tangent.hand * weights[k]);
                put(row + 4, tangent.unit * weights[k]);
            }
            row[floats - 1] = weights[k] > least_weight && weights[k] < most_weight ? float(weights[k]) : no_weight;
        }
        return true;
    }

private:
    // Beyond, squares of sums leave float: the general path gets the place.
    static constexpr double least_weight = 1e-15, most_weight = 1e15;
    static constexpr float no_weight = std::numeric_limits<float>::quiet_NaN();

    static void put(float* to, dvec3 v) {
        for (std::size_t a = 0; a < 3; ++a) to[a] = float(v[a]);
    }

    const FastState& state_;
};

template <int floats>
bool scatter(FastState& state) {
    const Votes<floats> votes(state);
    return FastScatter<Votes<floats>>(state, votes).run();
}

}  // namespace

bool scatter_votes(FastState& state) {
    return state.tangents ? scatter<tangent_row_floats>(state) : scatter<normal_row_floats>(state);
}

}  // namespace rakelight::geometry
