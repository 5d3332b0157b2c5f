// SPDX-License-Identifier: Apache-2.0
// The steps of a picture up to the engine, for tools that inspect it.
#pragma once
#include <memory>

#include <rakelight/picture.h>

#include "engines/raster/inspect/inspection.h"
#include "render/shader_terms.h"

namespace rakelight {

/// Loads and prepares what `request` describes and opens the soft engine on it. The request gets the look that it asks for.
/// @param shaders  gets engine gl where the request has shaders of the user's; null: a remark says that they are left out
/// @throws Error as render_picture()
std::unique_ptr<const raster::Inspection> open_engine(PictureRequest& request, Context& context,
                                                      std::unique_ptr<ShaderTerms>* shaders = nullptr);

/// The first half of it. @throws Error usage: what is requested is not made of surfaces
Scene load_for_engine(PictureRequest& request, Context& context);
/// The same for a scene that is there. @throws Error usage, as above and of settings; bad_file: see validate()
Scene asked_for_engine(const Scene& scene, PictureRequest& request, Context& context);
/// The second half. @param loaded  of load_for_engine() or asked_for_engine()
std::unique_ptr<const raster::Inspection> open_engine(Scene loaded, PictureRequest& request, Context& context,
                                                      std::unique_ptr<ShaderTerms>* shaders = nullptr);

}  // namespace rakelight
