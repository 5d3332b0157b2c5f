// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rakelight/image.h>

namespace rakelight {

/// A wall of bricks, 1024 x 1024, RGB, that repeats; by integers, products and square roots alone.
struct BenchTextures {
    Pixels color;   ///< sRGB codes
    Pixels normal;  ///< tangent space, green up
};

BenchTextures make_bench_textures();

}  // namespace rakelight
