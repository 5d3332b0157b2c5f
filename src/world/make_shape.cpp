// SPDX-License-Identifier: Apache-2.0
#include "world/make_shape.h"

#include "base/assert.h"
#include "prepare/prepare_scene.h"
#include "prepare/shapes/teapot.h"
#include "scene/charge_arrays.h"

namespace rakelight {
namespace {

Scene made(const ShapeRequest& r, MemoryBudget* memory) {
    if (!r.is_teapot) return make_primitive(r.primitive, memory);
    const double tolerance = r.primitive.tolerance;
    return make_teapot(tolerance > 0 ? teapot_divisions(tolerance) : r.primitive.divisions, memory);
}

}  // namespace

ShapeRequest request_of(const WorldPrimitive& p) {
    PrimitiveRequest request;
    const auto shape = primitive_named(p.type);
    RL_ASSERT(shape || p.type == "teapot", "the reader lets no other types in");
    request.shape = shape.value_or(PrimitiveShape::sphere);  // unused for the teapot
    request.radius = p.radius, request.tube_radius = p.tube_radius, request.height = p.height;
    request.width = p.width, request.depth = p.depth;
    request.divisions = p.divisions, request.objects = p.objects, request.tolerance = p.tolerance;
    return {request, !shape};
}

Scene make_shape(const ShapeRequest& r, MemoryBudget* memory) {
    Scene scene = made(r, memory);
    // A mesh has four arrays; for shapes cut into many pieces they are tiny.
    const std::uint64_t bytes = table_bytes(scene) + scene.meshes.size() * 4 * bytes_beside_array;
    if (memory) scene.charges.push_back(share(MemoryCharge(*memory, bytes, "a shape")));
    return scene;
}

}  // namespace rakelight
