// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rakelight/picture.h>
#include <rakelight/session.h>

namespace rakelight {

/// As draw_to_files(), but the color alone, as a PNG file would hold it, into memory.
void draw_to_memory(Session& session, const Camera& camera, const PictureRequest& request, PictureResult& result,
                    Pixels& color, Context& context);

/// What whoever gets the file has to know of its colors.
std::string comment_of(const RenderSettings& settings);

}  // namespace rakelight
