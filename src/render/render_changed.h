// SPDX-License-Identifier: Apache-2.0
// render_picture() with a step between loading and drawing.
#pragma once
#include <functional>
#include <vector>

#include <rakelight/picture.h>

namespace rakelight {

/// render_picture() into memory. @param change  makes the scene to draw of the one that was loaded
PictureResult render_changed(const PictureRequest& request, const std::function<Scene(Scene)>& change,
                             std::vector<std::byte>& file, Context& context);

}  // namespace rakelight
