// SPDX-License-Identifier: Apache-2.0
// Tessellated built-in shapes: sphere, cylinder, cone, torus, plane.
#pragma once
#include <compare>
#include <cstdint>
#include <optional>
#include <string_view>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

enum class PrimitiveShape : std::uint8_t { sphere, cylinder, cone, torus, plane };

/// The shape, centered at the origin, axis +Y. Lengths in meters, > 0, at most 1e6.
struct PrimitiveRequest {
    PrimitiveShape shape = PrimitiveShape::sphere;
    double radius = 1;          ///< sphere; cylinder; base of the cone; torus: center line of the tube
    double tube_radius = 0.35;  ///< torus; at most `radius`
    double height = 2;          ///< cylinder and cone, centered at the origin; the cone's apex is up
    double width = 2;           ///< plane, along X
    double depth = 2;           ///< plane, along Z; it faces +Y
    int divisions = 1;          ///< plane: quads per side, 1..1024
    /// [m] largest distance between triangles and surface. 0: 1/1000 of the largest radius.
    double tolerance = 0;
    int objects = 1;  ///< cut into so many objects of neighboring triangles, 1..1024, at most the number of triangles

    auto operator<=>(const PrimitiveRequest&) const = default;
};

/// One mesh per object, with a gray material, exact unit normals (sharp rims of cylinder and cone) and texture
/// coordinates. Their u goes once around, from -Z over -X, +Z, +X, and v from top to bottom (torus: from the inside
/// over the top). Caps and plane show the picture upright with -Z up, seen from above. Vertices lie on the surface up
/// to float rounding, and common corners are bit-equal, so solids are closed.
/// @param memory charged for the arrays before they are created; may be null
/// @throws Error usage: a length, count or tolerance out of range, or more than 4 million triangles; bad_file: over the
///         memory budget
Scene make_primitive(const PrimitiveRequest& request, MemoryBudget* memory = nullptr);

/// "sphere", "cylinder", "cone", "torus", "plane"
std::optional<PrimitiveShape> primitive_named(std::string_view name);
const char* name_of(PrimitiveShape shape);

}  // namespace rakelight
