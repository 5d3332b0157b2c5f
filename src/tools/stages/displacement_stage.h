// SPDX-License-Identifier: Apache-2.0
// The base meshes next to the displaced ones.
#pragma once
#include <rakelight/render/picture.h>

#include "tools/stages/stage.h"

namespace rakelight::stages {

/// Some mesh of the prepared scene was displaced.
bool has_displacement(const Sources& of, const PictureRequest& request);

/// Prepares the scene twice more: without displacement, and cut but not moved.
/// @param request  after decide()
Stage displacement_stage(const Sources& of, const Scene& loaded, const PictureRequest& request, Context& context);

}  // namespace rakelight::stages
