// SPDX-License-Identifier: Apache-2.0
// What of a request cannot be, or has no effect.
#pragma once
#include <string>

#include <rakelight/world/request.h>

namespace rakelight {

/// Folders that are missing are made when the file is. @throws Error failed: something else has the name of such a folder, or
/// the output is a folder
void check_output_place(const std::string& output);

/// Warns of unused settings of paths and of ambient occlusion.
void warn_of_unused(const PictureRequest& request, Report& report);

/// Warns of settings for normals where none is computed.
void warn_of_unused_normals(const Scene& scene, const PictureRequest& request, Report& report);

/// Warns of shading rules that match nothing in the scene.
void warn_of_unknown_names(const Scene& scene, const RenderSettings& settings, Report& report);

}  // namespace rakelight
