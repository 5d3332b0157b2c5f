// SPDX-License-Identifier: Apache-2.0
// The textures of a thumbnail: reduced, and the less important ones left out where all of them take too long.
#pragma once
#include <cstdint>

#include <rakelight/scene/scene.h>

namespace rakelight {

/// Pictures are left out one by one until the rest takes little enough time: those that alone take too long first, then
/// those that are missed less, then the larger, then those of later materials. Where the picture of the environment is
/// left out, the built-in studio replaces it.
/// @param most_side  [px] > 0, of io::reduced_image(); masks may be larger
/// @param most_work  [pixels] that may be decoded, as io::decoding_work() counts
Scene with_thumbnail_textures(Scene scene, int most_side, std::uint64_t most_work, Context& context);

}  // namespace rakelight
