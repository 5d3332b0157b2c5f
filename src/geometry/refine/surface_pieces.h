// SPDX-License-Identifier: Apache-2.0
// Builds one subdivision surface from polygons of any objects: connectivity along edges, and boundaries.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <rakelight/math/vector.h>

namespace rakelight::geometry {

/// Polygons, each a loop of different corners, counter-clockwise as seen from outside.
struct Polygons {
    std::vector<std::uint32_t> first = {0};  ///< [F + 1] into `corners`
    std::vector<std::uint32_t> corners;

    std::uint32_t count() const { return std::uint32_t(first.size() - 1); }
    std::uint32_t size(std::uint32_t face) const { return first[face + 1] - first[face]; }
    /// The corner after, and before, a corner of a face.
    std::uint32_t next(std::uint32_t face, std::uint32_t c) const {
        return c + 1 == first[face + 1] ? first[face] : c + 1;
    }
    std::uint32_t previous(std::uint32_t face, std::uint32_t c) const {
        return c == first[face] ? first[face + 1] - 1 : c - 1;
    }
    void end_face() { first.push_back(std::uint32_t(corners.size())); }
};

struct PieceOptions {
    double crease_angle_rad = 4;  ///< edges whose faces are bent more become creases; > pi: none
    /// [corners] Not 0: the edge that begins there becomes a crease; empty: none. One of the two faces suffices.
    std::vector<std::uint8_t> is_hard{};
    bool sharpens_corners = true;  ///< the boundary rule that will hold (see ControlSurface)
};

/// Vertices and faces without an edge of three faces, and without faces that turn opposite ways along an edge.
struct SurfacePieces {
    std::vector<std::uint32_t> vertices;                ///< [corners] < place_of.size()
    std::vector<std::uint32_t> place_of;                ///< [V]
    std::vector<std::array<std::uint32_t, 2>> creases;  ///< vertices at both ends
    std::vector<std::uint32_t> pinned;                  ///< vertices that must stay where they are
    std::uint64_t parted_edges = 0;                     ///< where not all faces at the edge are joined by it
};

/// Joins two faces along an edge that they use in opposite directions. At edges of more faces, the pair with the
/// smallest dihedral angle is joined, repeatedly. A face is not joined to its own reverse (the back of a leaf). Corners
/// at one place that are connected over joined edges are one vertex. If several vertices are at one place, and their
/// surfaces do not end along the same edges, all of them are pinned, so that no crack opens.
/// @param faces      corners are places
/// @param positions [places] O(n log n); the result is equal for any number of threads.
SurfacePieces part_surface(const Polygons& faces, const std::vector<dvec3>& positions, const PieceOptions& options);

}  // namespace rakelight::geometry
