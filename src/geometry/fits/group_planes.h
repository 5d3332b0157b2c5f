// SPDX-License-Identifier: Apache-2.0
// Planes of two or more triangles, and which of them rules a place.
#pragma once
#include "geometry/fits/spokes.h"

namespace rakelight::geometry {

/// Faces that are joined by edges within corner groups and lie in one plane.
struct FacePlanes {
    static constexpr std::uint32_t alone = 0xffffffffu;
    BlockArray<std::uint32_t> plane_of;  ///< [triangles] alone: no other face is in its plane; empty: all are alone
    std::vector<double> area;            ///< [planes] [m^2]
    std::vector<std::uint8_t> is_open;   ///< [planes] not 0: it may be larger than what is known of it
    MemoryCharge charge;

    bool empty() const { return plane_of.empty(); }
    bool has_open() const;
    /// Whether an open plane is at one of the corners.
    bool has_open(std::span<const std::uint32_t> corners) const;
};
/// @param pairs  [any parts] flat faces that share an edge
/// @param known  [groups] not 0: the rings have its corners; empty: those of all
FacePlanes face_planes(const GroupRings& rings, std::span<const std::vector<Spokes::FacePair>> pairs, std::size_t faces,
                       std::span<const std::uint8_t> known, GeneralScratch& scratch, Context& context);

/// The planes at a place. A plane counts by its whole area, so that it does not matter how it is cut into triangles.
struct PlanesAtPlace {
    dvec3 normal;             ///< of the largest plane: of its faces at the place
    double share = 0;         ///< of the largest plane in the area of all planes here
    double planar_share = 0;  ///< of the planes of two or more triangles in it
    bool rules = false;       ///< the largest one has two or more triangles, and is not alone
};
/// @param memory  reused
PlanesAtPlace planes_at(const GroupRings& rings, const FacePlanes& planes, std::uint32_t group,
                        std::vector<std::uint32_t>& memory);

}  // namespace rakelight::geometry
