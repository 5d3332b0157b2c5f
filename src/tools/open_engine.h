// SPDX-License-Identifier: Apache-2.0
// The steps of a picture up to the engine, for tools that inspect it.
#pragma once
#include <memory>

#include <rakelight/render/picture.h>

#include "engines/raster/inspect/inspection.h"
#include "render/remarks/shader_terms.h"

namespace rakelight {

/// Opens the soft engine on a loaded scene as a request wants it. The request gets what is decided, and the settings of the
/// shot.
/// @param loaded   passed validate()
/// @param shaders  gets engine gl where the request has shaders of the user's; null: a remark says that they are left out
/// @throws Error as render_picture(); usage: what is requested is not made of surfaces
std::unique_ptr<const raster::Inspection> open_engine(Scene loaded, PictureRequest& request, Context& context,
                                                      std::unique_ptr<ShaderTerms>* shaders = nullptr);

/// The model of a request. @throws Error as load(); usage: what is requested is not made of surfaces
Scene load_for_engine(const PictureRequest& request, Context& context);

}  // namespace rakelight
