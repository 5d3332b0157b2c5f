// SPDX-License-Identifier: Apache-2.0
// Texture placements of foreign formats as affine maps of our (v down) texture coordinates.
#pragma once
#include <optional>

#include <rakelight/scene/scene.h>

#include "io/import/stream_format.h"

namespace rakelight::io {

/// u' = a u + b v + c, v' = d u + e v + f
struct TextureAffine {
    double a = 1, b = 0, c = 0, d = 0, e = 1, f = 0;
};

/// The map of a link, in v-down coordinates on both sides.
TextureAffine placement_of(const import_stream::TextureLink& link);

/// The same as offset, rotation and scale; nullopt when the map shears (placement_of() never does) or has no width.
std::optional<TextureTransform> as_transform(const TextureAffine& map);

}  // namespace rakelight::io
