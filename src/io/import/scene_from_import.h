// SPDX-License-Identifier: Apache-2.0
// What the helper read, made into a scene by our conventions: meters, +Y up, linear colors, texture coordinates v down.
#pragma once
#include <string>

#include <rakelight/scene/scene.h>

#include "io/import/stream_reader.h"
#include "io/reader.h"

namespace rakelight::io {

/// @param ending  of the file's name, lower case, without the dot
/// @throws Error bad_file: nothing to draw, a matrix that is not finite
Scene scene_from_import(import_stream::Import&& import, const std::string& path, const std::string& ending,
                        const ReadOptions& options, Context& context);

namespace detail {

/// Takes the file's axes and unit to ours: the side axis becomes +X, up +Y, front (towards the viewer) +Z, lengths
/// meters.
dmat4 to_our_axes(const import_stream::AxisSystem& axes);

void add_meshes(import_stream::Import& import, const std::string& path, Scene& scene, Context& context);
void add_materials(import_stream::Import& import, const std::string& path, const std::string& ending,
                   bool allow_outside, Scene& scene, Context& context);
void add_lights_and_cameras(const import_stream::Document& document, const std::vector<dmat4>& world,
                            const std::string& path, Scene& scene, Context& context);

}  // namespace detail
}  // namespace rakelight::io
