// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

enum class BenchShape : std::uint8_t { sphere, knot, torus };

/// A closed grid of about `triangles` (at least 20), of radius about 1 around the origin: positions, normals of the surface,
/// tangents along u, texture coordinates, indices. No triangle is degenerate.
/// @param variant  0..1, how wavy it is
Mesh make_bench_shape(BenchShape shape, std::uint64_t triangles, double variant, const Context& context);

}  // namespace rakelight
