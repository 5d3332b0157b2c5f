// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include <rakelight/scene/scene.h>

namespace rakelight {

/// A wall of bricks, 1024 x 1024, RGB, that repeats; by integers, products and square roots alone.
struct BenchTextures {
    Pixels color;   ///< sRGB codes
    Pixels normal;  ///< tangent space, green up
};

BenchTextures make_bench_textures();
/// As textures of a scene: 0 the color, 1 the normal map.
std::vector<Texture> make_bench_wall();

}  // namespace rakelight
