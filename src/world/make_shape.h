// SPDX-License-Identifier: Apache-2.0
// Creates a scene from a built-in shape of a world or the command line.
#pragma once
#include <rakelight/base/context.h>
#include <rakelight/io/world.h>

#include "prepare/shapes/primitives.h"

namespace rakelight {

/// The parameters of a shape without placement and material, for reuse of equal shapes.
struct ShapeRequest {
    PrimitiveRequest primitive;  ///< the teapot uses only `divisions` and `tolerance`
    bool is_teapot = false;

    auto operator<=>(const ShapeRequest&) const = default;
};
ShapeRequest request_of(const WorldPrimitive& shape);

/// @throws Error as make_primitive() and make_teapot()
Scene make_shape(const ShapeRequest& request, MemoryBudget* memory);

}  // namespace rakelight
