// SPDX-License-Identifier: Apache-2.0
// Causes of a black picture: materials, fog, lights.
#pragma once
#include <cstdint>
#include <string>

#include <rakelight/render/picture.h>

namespace rakelight {

/// Whether a linear color, encoded as it is, has `code` in red, green and blue.
bool is_code(vec3 linear, std::uint8_t code);
/// Whether a linear color is `code` in red, green and blue of the request's 8-bit pictures.
bool shows_as(const PictureRequest& request, vec3 linear, std::uint8_t code);

/// Nothing of the model is lit.
bool is_unlit(const Scene& scene, const PictureRequest& request);
/// Some object has a material that is blended.
bool has_blended(const Scene& scene);

/// The likely reason, without a full stop, why all of the model is black.
/// @param scene  as the engine drew it
std::string why_black(const Scene& scene, const PictureRequest& request);

}  // namespace rakelight
