// SPDX-License-Identifier: Apache-2.0
// The stages of the fast path in order, each with its source.
#pragma once
#include <algorithm>

#include "geometry/fast/fast_state.h"

namespace rakelight::geometry {

// --- fast_scatter.cpp ----------------------------------------------------------------------------------------

/// Adds the votes of all faces to the rows of their vertices, inside each mesh (fast_scatter.h). Faces for which float is
/// not safe are computed in double and rounded.
/// @return false: an index is out of range (nothing was read through it)
bool scatter_votes(FastState& state);

// --- fast_weld.cpp -------------------------------------------------------------------------------------------

std::uint32_t weld_partition_bits(std::uint32_t vertices);

/// Writes the hashes of positions first .. last - 1 of a mesh (world space, -0 as +0; with scope `object` including the
/// object) and counts them by partition in the lane.
void hash_places(const FastState& state, LaneScratch& lane, std::uint32_t mesh, std::uint32_t first,
                 std::uint32_t last);

/// Welds vertices (exactly, -0 equal to +0; with scope `object` only inside one object) and gives each class the sum of
/// its members' rows in index order. All places must be hashed. One radix partition by hash, then a cache-sized hash
/// table per partition; each class lies in one partition, so threads do not share classes.
void weld_rows(FastState& state);

// --- fast_classes.cpp ----------------------------------------------------------------------------------------

/// Gives the members of each class their common sums: normals of all; tangents of members of one handedness within 45
/// degrees of each other (connected pairs). Classes that float cannot decide like the general path (nearly cancelling
/// normals, mirrored charts at one vertex, angles near 45 degrees) are left to it: weight -1.
/// @param duplicates  whole classes: all members but one, with that one; sorted here
void join_classes(FastState& state, std::vector<Duplicate>& duplicates);

/// Calls body(members, ascending) for each class.
/// @param duplicates  after join_classes()
template <class Body>
void for_each_class(std::span<const Duplicate> duplicates, const Body& body) {
    std::vector<std::uint32_t> members;
    for (std::size_t i = 0; i < duplicates.size();) {
        const std::uint32_t winner = duplicates[i].winner;
        members.assign(1, winner);
        for (; i < duplicates.size() && duplicates[i].winner == winner; ++i) members.push_back(duplicates[i].vertex);
        std::rotate(members.begin(), members.begin() + 1, std::upper_bound(members.begin() + 1, members.end(), winner));
        body(std::span<const std::uint32_t>(members));
    }
}

// --- fast_finish.cpp -----------------------------------------------------------------------------------------

/// From the sums to unit normals and tangents in the caller's buffers.
/// @return global indices of vertices left to the general path, ascending; their output is invalid
std::vector<std::uint32_t> finish_rows(FastState& state);

/// Tangents again, for other normals in the caller's buffers.
void finish_tangents(FastState& state);

// --- fast_looks.cpp ------------------------------------------------------------------------------------------

/// The smallest crease angle [rad] for which float decides.
constexpr double least_crease_rad = radians(1);

/// Looks at the faces of each place from its normal. Where they go around it once, and none turns away from it by more than
/// half the crease angle, all are joined. Open are creases, borders, bumps, and where surfaces touch. Rows hold LookRow
/// afterwards.
/// @return global indices of vertices of open places, ascending; with a vertex all others at its place
std::vector<std::uint32_t> look_at_places(FastState& state);

// --- fast_fans.cpp -------------------------------------------------------------------------------------------

/// Walks the faces of open places over common edges.
/// @param open  as look_at_places() returns them
/// @return those left to the general path: their faces are not one fan within the crease angle
std::vector<std::uint32_t> walk_fans(FastState& state, std::span<const std::uint32_t> open);

// --- fast_fits.cpp -------------------------------------------------------------------------------------------

/// Fits normals, and then makes tangents.
/// @param hard    vertices left to the general path, as look_at_places() returns them
/// @param splits  [meshes] gets the split vertices
void fit_places(FastState& state, std::span<const std::uint32_t> hard, std::span<const AttributeBuffers> out,
                std::vector<SplitAttributes>& splits);

// --- fast_hard_places.cpp ------------------------------------------------------------------------------------

/// Recomputes some places by the general path with all faces that touch them, and replaces the output of the fast path.
/// The general path's result at a place depends only on the faces there.
/// @param vertices global indices, ascending; with a vertex all others at its place
/// @param splits [meshes] gets the split vertices
void redo_places(FastState& state, std::span<const std::uint32_t> vertices, std::span<const AttributeBuffers> out,
                 std::vector<SplitAttributes>& splits);

}  // namespace rakelight::geometry
