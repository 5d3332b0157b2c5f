// SPDX-License-Identifier: Apache-2.0
// Subdivision surfaces: uniform refinement of a control surface, with limit positions and limit normals.
//
// OpenSubdiv provides topology and sharpness of the refined levels. Points are computed here, in double and without
// libm, so that they are bit-identical on every machine.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <rakelight/base/context.h>

#include "geometry/refine/surface_pieces.h"

namespace rakelight::geometry {

enum class Scheme : std::uint8_t { catmull_clark, loop };

struct ControlSurface {
    Scheme scheme = Scheme::catmull_clark;
    int level = 1;                                      ///< 1..10: every edge becomes 2^level
    Polygons faces;                                     ///< corners are vertices; Loop: triangles
    std::vector<dvec3> positions;                       ///< [V] finite
    std::vector<std::array<std::uint32_t, 2>> creases;  ///< edges
    double sharpness =
        10;  ///< of creases: 0 none, 10 or more infinitely sharp; s: the first s levels (DeRose et al. 1998)
    std::vector<std::uint32_t> pinned;  ///< vertices with fixed positions
    /// Fixes boundary vertices of a single face; else the boundary is smooth there.
    bool sharpens_corners = true;
};

/// Faces in the order of their control faces.
struct LimitSurface {
    std::uint32_t corners_of_face = 4;     ///< Catmull-Clark 4, Loop 3
    std::vector<dvec3> positions;          ///< [V'] on the limit surface
    std::vector<dvec3> normals;            ///< [N] unit, of the limit surface; at creases one for each side
    std::vector<std::uint32_t> vertices;   ///< [F' * corners_of_face] into positions
    std::vector<std::uint32_t> normal_of;  ///< [F' * corners_of_face] into normals
};

/// Refinement rule of values at corners.
enum class ValueRule : std::uint8_t {
    smooth,      ///< as positions; chart borders are smooth curves
    fixed_ends,  ///< as positions, but chart borders stay straight
    linear       ///< halfway between the corners
};

/// Face-varying values: texture coordinates, colors.
struct ControlValues {
    std::vector<std::uint32_t> corners;  ///< [corners of the faces] into values; charts end where neighbors differ
    std::vector<dvec4> values;
    ValueRule rule = ValueRule::fixed_ends;
};
struct LimitValues {
    std::vector<std::uint32_t> corners;  ///< [as LimitSurface::vertices] into values
    std::vector<dvec4> values;
};

/// @param faces  of the control surface; 2^64 - 1: too many to count
std::uint64_t fine_face_count(Scheme scheme, int level, const Polygons& faces);

/// [bytes] approximate peak of subdivide() and one subdivide_values() call for this many fine faces.
std::uint64_t subdivision_bytes(Scheme scheme, std::uint64_t fine_faces);

/// Masks: Catmull & Clark 1978, Loop 1987, with creases after DeRose, Kass & Truong 1998; edges still sharp at the last
/// level are sharp in the limit. Bit-identical for any number of threads.
/// @throws Error bad_file: more vertices, or faces at a vertex, than OpenSubdiv supports; failed: cancelled
LimitSurface subdivide(const ControlSurface& surface, Context& context);
LimitValues subdivide_values(const ControlSurface& surface, const ControlValues& values, Context& context);

}  // namespace rakelight::geometry
