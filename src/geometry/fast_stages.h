// SPDX-License-Identifier: Apache-2.0
// The stages of the fast path, in their order. Each is in the source named beside it.
#pragma once
#include "geometry/fast_state.h"

namespace rakelight::geometry {

// --- fast_scatter.cpp ----------------------------------------------------------------------------------------

/// Adds the votes of all faces to the rows of their vertices, inside each mesh. Fixed pieces of about 128k triangles own
/// vertex ranges; votes for another piece's vertex are handed over and added in the order of the pieces, so the bits do not depend
/// on the threads. Faces on which float is not safe are computed in double and then rounded.
/// @return false: an index is out of range (nothing was read through it)
bool scatter_votes(FastState& state);

// --- fast_weld.cpp -------------------------------------------------------------------------------------------

std::uint32_t weld_partition_bits(std::uint32_t vertices);

/// Writes the hashes of positions first .. last - 1 of a mesh (in the world, -0 as +0; with scope `object` also of the object)
/// and counts them by their partitions in the lane.
void hash_places(const FastState& state, LaneScratch& lane, std::uint32_t mesh, std::uint32_t first,
                 std::uint32_t last);

/// Finds the vertices that share a place (exactly, -0 equal to +0; with scope `object` only inside one object) and gives each
/// class its common row: the sum of its members' rows in the order of their numbers. All places must have been hashed. One
/// radix partition by hash, then a table for each partition that fits the cache; all members of a class lie in one partition,
/// so no two threads meet in a class.
void weld_rows(FastState& state);

// --- fast_classes.cpp ----------------------------------------------------------------------------------------

/// Gives the members of each class their common sums: normals of all; tangents of those members of one handedness whose own
/// tangents lie within 45 degrees of one another (connected pairs). Where float cannot tell what the general path would do
/// (normals that nearly cancel, mirrored charts at one vertex, angles near 45 degrees) the class is left to it: weight -1.
/// @param duplicates  whole classes: all members but one, with that one; sorted here
void join_classes(FastState& state, std::vector<Duplicate>& duplicates);

// --- fast_finish.cpp -----------------------------------------------------------------------------------------

/// From the sums to unit normals and tangents in the caller's buffers.
/// @return the vertices left to the general path, ascending, numbered through; what was written for them is worthless
std::vector<std::uint32_t> finish_rows(FastState& state);

// --- fast_hard_places.cpp ------------------------------------------------------------------------------------

/// Gives some places to the general path: a model of all faces that touch them, whose results for these vertices replace what
/// the fast path wrote. All that the general path decides at a place depends on the faces there alone.
/// @param vertices  ascending, numbered through; with a vertex all others at its place
/// @param splits    [meshes] gets the vertices that had to be split
void redo_places(FastState& state, std::span<const std::uint32_t> vertices, std::span<const AttributeBuffers> out,
                 std::vector<SplitAttributes>& splits);

}  // namespace rakelight::geometry
