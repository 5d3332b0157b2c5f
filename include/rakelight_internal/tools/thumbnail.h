// SPDX-License-Identifier: Apache-2.0
// Small pictures of models, as file managers show them.
#pragma once
#include <cstddef>
#include <vector>

#include <rakelight/base/export.h>
#include <rakelight/world/request.h>

namespace rakelight {

/// render_picture() into memory, with textures that are decoded at a reduced size: halved until no side is longer than
/// 512 pixels, or than four times the longer side of the picture (past 1024 pixels: twice). So a texel is still smaller
/// than a pixel where the model fills the picture, and nothing pays for the texels that no pixel shows.
/// If all of them together take too long to decode, some are left out, one by one until the rest fits. Those that alone
/// take too long go first. Then go normal, height and occlusion maps, then all but color, opacity and emission, then
/// emission, then the picture of an environment (the built-in studio replaces it), then the rest. Of each kind the larger
/// go first, then those of later materials. Formats and sizes of the picture files decide what takes too long, so the
/// picture is the same on every machine.
/// @param cpu_seconds  [s] > 0: processor time that the thumbnail should take; textures get about half of it
/// @return the bytes of the picture file. Its format follows from the ending of `request.output`
/// @throws Error usage, not_found, bad_file, failed
RL_API std::vector<std::byte> thumbnail(const PictureRequest& request, double cpu_seconds, Context& context);

}  // namespace rakelight
