// SPDX-License-Identifier: Apache-2.0
// The output vertex of each corner, and the groups of output vertices with one normal. The grouping stages refine it in
// order: weld, creases and smoothing groups, mirrored texture coordinates, cancelling shells.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/corners/corner_bins.h"
#include "geometry/input/attribute_input.h"

namespace rakelight::geometry {

/// The corner before one in its face: where the edge that ends at it begins.
inline std::uint32_t corner_before(std::uint32_t corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }
inline std::uint32_t corner_after(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

/// Output vertices have global indices: first the input's (as in AttributeInput), then the appended ones.
struct Topology {
    std::shared_ptr<const std::vector<std::uint32_t>>
        places;                         ///< [input vertices] smallest one at the same place; never null
    std::vector<std::uint32_t> group;   ///< [output vertices] one of the vertices that share its normal; group[g] == g
    std::vector<std::uint32_t> source;  ///< [appended] the input vertex that each copies
    BlockArray<std::uint32_t> corner_vertex;  ///< [3 * triangles] output vertex; empty: nothing was split
    Block spare;                              ///< memory for corner_vertex

    std::uint32_t vertex_of(const AttributeInput& input, std::uint32_t mesh, std::uint32_t corner) const {
        return corner_vertex.empty() ? input.corner_vertex(mesh, corner) : corner_vertex[corner];
    }
    std::uint32_t source_of(const AttributeInput& input, std::uint32_t vertex) const {
        return vertex < input.vertex_count() ? vertex : source[vertex - input.vertex_count()];
    }
};

Topology copy_of(const Topology& topology, const AttributeInput& input);

/// Fills corner_vertex from the input's indices if it is empty.
void materialize_corners(Topology& topology, const AttributeInput& input, Context& context);

/// [sources] position of each after a stable sort.
/// @param count upper bound of sources, exclusive
std::vector<std::uint32_t> rank_by_source(const std::vector<std::uint32_t>& sources, std::uint32_t count,
                                          GeneralScratch& scratch);

/// Renumbers the appended vertices by source: vertices of one mesh become contiguous, in the order of their sources.
void sort_appended(Topology& topology, const AttributeInput& input, Context& context);

/// The corners at each group of vertices.
/// @param selected  [output vertices] only groups g with selected[g] != 0 get a bin; empty: all
/// @param bins, keys reused memory, contents are ignored; `keys` keeps it. Null: allocate
CornerBins bin_corners(const Topology& topology, const AttributeInput& input, std::span<const std::uint8_t> selected,
                       Context& context, CornerBins bins = {}, BlockArray<std::uint16_t>* keys = nullptr);

/// [triangles] Unit normal of each face in the world; zero where it has no vote.
using FaceNormals = BlockArray<dvec3>;
/// @param memory reused, contents are ignored
FaceNormals face_normals(const AttributeInput& input, Context& context, FaceNormals memory = {});

}  // namespace rakelight::geometry
