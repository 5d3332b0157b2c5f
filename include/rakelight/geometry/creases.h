// SPDX-License-Identifier: Apache-2.0
// Creases found by a rule: which edges of a model are hard, with no angle to choose. Needs no Scene.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/base/export.h>
#include <rakelight/geometry/attributes.h>

namespace rakelight {

/// [degrees] An edge that bends by at least this is hard.
inline constexpr double always_hard_deg = 65;
/// [degrees] At least three equal bends in a row up to this are a round shape. 50 lies between the bends of columns of
/// 7 and 8 sides (51.4 and 45).
inline constexpr double round_most_deg = 50;
/// A ring of up to so many equal sides is flat.
inline constexpr std::uint32_t flat_most_sides = 7;
/// [degrees] Bends of less than this are soft.
inline constexpr double soft_below_deg = 8;

/// Statistics over all meshes. An edge counts if exactly two valid faces use it, or two of more faces are paired there,
/// and if it bends by more than the rounding of the positions can bend it.
struct CreaseReport {
    std::uint64_t hard = 0, soft = 0;  ///< edges
    /// [degrees] range of the bends of hard edges, and the largest bend of a soft edge; 0 without such edges
    double hard_least_deg = 0, hard_most_deg = 0, soft_most_deg = 0;

    /// Conventions. Geometry cannot tell a prism with flat sides from a coarse column. Up to 7 equal sides are
    /// flat (hard edges), more are round (soft edges). [n] The number of closed rings of n such sides, n = 6 to 12.
    std::array<std::uint64_t, 13> rings{};
    /// Surfaces of single triangles, without any plane of two or more, that bend by over 30 degrees somewhere and are
    /// smooth: an organic shape, or a stone with facets.
    std::uint64_t smooth_surfaces = 0;
    bool operator==(const CreaseReport&) const = default;
};

/// Result of find_creases().
struct Creases {
    /// [meshes][T] bit k: the edge from corner k to corner (k + 1) % 3 is hard. Edges of one face are not hard.
    std::vector<std::vector<std::uint8_t>> hard;
    CreaseReport report;
};

/// Decides for each edge whether it is hard. The decision needs no angle, and it is the same if the model is placed turned or
/// scaled, renumbered or cut into objects.
///
/// 1. *Rounding.* The positions of a file are rounded: to AttributeMesh::position_step, to decimals or to binary digits
///    if all coordinates of the model lie on such a grid, or to floats. It follows how much each edge may bend by
///    rounding alone. Faces too thin for a normal take that of a neighbor.
/// 2. *Planes.* Faces form one plane if an edge between them bends by at most 0.05 degrees, and what rounding can bend.
///    Two triangles that meet mostly single triangles are in one plane by chance, and count as single ones. So do all
///    faces of a surface whose bends do not stop at what rounding does to planes: squares of a scan.
/// 3. *Widths.* At each edge between two planes, each plane has a width across the edge. Its far side is its farthest
///    edge that is nearly parallel (37 degrees); of several at one distance, one that bends equally.
/// 4. *Decisions*, in this order:
///    - Bends of less than `soft_below_deg` are soft; at least `always_hard_deg` are hard. Of the others, those that
///      rounding alone may have made are soft.
///    - Between single triangles: soft. Only in a small fan of equal bends, over `round_most_deg` are hard.
///    - A wide plane at a narrow one that bends two or three times as much at its far side, up to `round_most_deg`:
///      soft, a fillet begins. With a bend of less than 14 degrees, planes of one width and up to four times as well.
///      The same where a plane meets bent squares.
///    - Equal bends (15 %) between planes of similar width: at least three in a row, between planes of one width, are a
///      round shape, which is soft up to `round_most_deg`. Others are a chamfer, which is hard over 32 degrees.
///    - Far bends within a factor of 2.2, planes of similar width: soft up to `round_most_deg` if both sides have such
///      far bends, a round shape of changing radius. With one such side hard over 32 degrees.
///    - Edges that would be hard, up to `round_most_deg`, are soft where what lies straight across their faces is a round
///      shape by equal bends: flat annuli of tori and rims, tubes of planes and warped squares.
///    - All others are hard, except for two kinds among soft edges: a strip of a fillet may end softly at a round corner,
///      and a turned shape may bend once (both up to 25 degrees) or be a coarse wave (up to `round_most_deg`).
///
/// A threshold moves by up to 2 degrees into the widest gap between the bends of the model, so that rounding never
/// divides edges of one kind. At an edge of more than two faces, the two with the nearest normals and opposite
/// directions are paired first; a pair is decided as above. Unpaired faces are hard there, except that faces join
/// within `soft_below_deg`.
///
/// Expected O(n log n), about 200 bytes per triangle; the same bits for any number of threads. Reentrant.
/// @param meshes smoothing groups, hints, locks, normals and crease angles are not read
/// @param options only `scope` and `weld_distance` are read
/// @throws Error bad_file: as group()
RL_API Creases find_creases(std::span<const AttributeMesh> meshes, const AttributeOptions& options, Context& context);

}  // namespace rakelight
