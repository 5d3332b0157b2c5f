// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include <rakelight/world.h>

namespace rakelight {

/// `keys` and `interpolation` of a camera or light of a world, as lines of its section; empty: it does not move.
/// What a light of its type has no key for is left out.
/// @throws Error usage: a track that no key says
std::string text_of_tracks(const WorldFile& world, AnimationPath path, std::size_t element);

}  // namespace rakelight
