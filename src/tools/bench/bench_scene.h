// SPDX-License-Identifier: Apache-2.0
// The scene of the measurements of pictures, made by formulas: the same bits on every machine, no file.
#pragma once
#include <cstdint>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

inline constexpr std::uint32_t bench_lights_max = 8;             ///< that reach everywhere
inline constexpr std::uint32_t bench_small_lights_max = 10'000;  ///< more than those: lights with a range
inline constexpr float bench_small_range = 1;                    ///< [m] about an object's own size

/// Displaced spheres, (2,3) torus knots and wavy tori in fixed random places, sizes, turns, colors and order; about 60 % of
/// a picture of 16:9 is covered. One mesh, one classical material (Blinn-Phong, exponent 48) and one node each; normals,
/// tangents and texture coordinates; a brick wall as color and normal map of 1024 x 1024 for all; one camera; point lights
/// that are attenuated by 1 / (c + l d + q d^2).
/// @param triangles  of all objects, about; at least 20 an object are made
/// @param objects    1 to 100 000
/// @param lights     0 to bench_small_lights_max: up to bench_lights_max as above, more of them photometric ones of
///                   bench_small_range, evenly through the space of the objects
Scene make_bench_scene(std::uint64_t triangles, std::uint32_t objects, std::uint32_t lights, Context& context);
/// Its lights alone.
std::vector<Light> make_bench_lights(std::uint32_t lights);

}  // namespace rakelight
