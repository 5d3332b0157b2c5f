// SPDX-License-Identifier: Apache-2.0
// A shape of a world or of a command line as a scene.
#pragma once
#include <rakelight/context.h>
#include <rakelight/world.h>

#include "prepare/primitives.h"

namespace rakelight {

/// What makes one shape equal to another, but for place and material.
struct ShapeRequest {
    PrimitiveRequest primitive;  ///< of the teapot only `divisions` and `tolerance` count
    bool is_teapot = false;

    auto operator<=>(const ShapeRequest&) const = default;
};
ShapeRequest request_of(const WorldPrimitive& shape);

/// @throws Error as make_primitive() and make_teapot()
Scene make_shape(const ShapeRequest& request, MemoryBudget* memory);

}  // namespace rakelight
