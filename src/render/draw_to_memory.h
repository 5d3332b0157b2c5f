// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rakelight/picture.h>
#include <rakelight/session.h>

namespace rakelight {

/// Like draw_to_files(), but only the color, as a PNG file would hold it, into memory.
void draw_to_memory(Session& session, const Shot& shot, const PictureRequest& request, PictureResult& result,
                    Pixels& color, Context& context);

}  // namespace rakelight
