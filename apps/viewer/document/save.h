// SPDX-License-Identifier: Apache-2.0
// A look as text: a world file that `rakelight render` reproduces, and its command line.
#pragma once
#include <string>

#include "document.h"

namespace rakelight::viewer {

/// The content of a world file at `path` whose picture is this look's. Names of files are from the world's folder.
/// Cameras of another world file come with the rounding of one look_at(), see to_toml().
/// @throws Error usage: a look that no world file can say; and as read_world()
WorldFile world_of(const Look& look, const Model& model, int width, int height, const std::string& path);

/// Parts of the look that no world file can hold, for people: "1 light that is off, ..."; empty: none.
std::string not_saved(const Look& look);

/// "rakelight render MODEL -o picture.png --resolution 640,480 ...", each word quoted for a shell where it must be, except for
/// what not_on_command_line() says.
std::string command_line_of(const Look& look, const Model& model, int width, int height);
/// For people: "changed materials, samples"; empty: nothing. Settings of a world file that are at their default again have no words.
std::string not_on_command_line(const Look& look, const Model& model);

/// "folder/name.scene.toml" beside the model, for shapes in the working folder; one that does not exist yet.
std::string free_world_name(const std::string& model_file);
/// "folder/name-seamless.obj" beside the model, likewise; of formats that cannot be written as .glb.
std::string free_seamless_name(const std::string& model_file);
/// "name-1.png", "name-2.png", ... in the working folder: the first of which nothing is there yet, not
/// "name-1.depth.png" either.
std::string free_name(const std::string& model_file, const std::string& middle, const std::string& ending);

}  // namespace rakelight::viewer
