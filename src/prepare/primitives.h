// SPDX-License-Identifier: Apache-2.0
// Solids of formulas as triangle scenes: sphere, cylinder, cone, torus, plane.
#pragma once
#include <compare>
#include <cstdint>
#include <optional>
#include <string_view>

#include <rakelight/context.h>
#include <rakelight/scene.h>

namespace rakelight {

enum class PrimitiveShape : std::uint8_t { sphere, cylinder, cone, torus, plane };

/// What is to be made, about the origin, axis +Y. Lengths in meters, more than 0, at most 1e6.
struct PrimitiveRequest {
    PrimitiveShape shape = PrimitiveShape::sphere;
    double radius = 1;          ///< sphere; cylinder; base of the cone; torus: from its center to that of the tube
    double tube_radius = 0.35;  ///< torus; at most `radius`
    double height = 2;          ///< cylinder and cone, half of it above the origin; the cone's tip is up
    double width = 2;           ///< plane, along X
    double depth = 2;           ///< plane, along Z; it faces +Y
    int divisions = 1;          ///< plane: quads a side, 1..1024
    /// [m] largest distance between the triangles and the surface. 0: a thousandth of the largest radius.
    double tolerance = 0;
    int objects = 1;  ///< cut into so many objects of neighboring triangles, 1..1024, at most the number of triangles

    auto operator<=>(const PrimitiveRequest&) const = default;
};

/// One mesh an object, with one gray material, unit normals that are the surface's own (rims of cylinder and cone are
/// sharp) and texture coordinates: u once around, from -Z over -X, +Z, +X, v from top to bottom (torus: from the inside
/// over the top); caps and plane show the picture upright with -Z up as seen from above. Vertices lie on the surface up
/// to the rounding of floats and corners of neighbors are bit-equal: solids are closed.
/// @param memory charged for the arrays before they are created; may be null
/// @throws Error usage: a length, count or tolerance out of range, or more than 4 million triangles; bad_file: over the
///         memory budget
Scene make_primitive(const PrimitiveRequest& request, MemoryBudget* memory = nullptr);

/// "sphere", "cylinder", "cone", "torus", "plane"
std::optional<PrimitiveShape> primitive_named(std::string_view name);
const char* name_of(PrimitiveShape shape);

}  // namespace rakelight
