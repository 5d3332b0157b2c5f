// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include <rakelight/io/world.h>

namespace rakelight {

/// The lines `keys` and `interpolation` of a camera or light in a world file; empty: not animated. Properties without a
/// key are skipped.
/// @throws Error usage: a track without a key
std::string text_of_tracks(const WorldFile& world, AnimationPath path, std::size_t element);

}  // namespace rakelight
