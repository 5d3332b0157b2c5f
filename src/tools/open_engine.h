// SPDX-License-Identifier: Apache-2.0
// The way of a picture up to the engine, for tools that look into it.
#pragma once
#include <memory>

#include <rakelight/picture.h>

#include "engines/raster/inspection.h"

namespace rakelight {

/// Loads and prepares what `request` describes and opens the soft engine on it.
/// @throws Error as render_picture()
std::unique_ptr<const raster::Inspection> open_engine(const PictureRequest& request, Context& context);

}  // namespace rakelight
