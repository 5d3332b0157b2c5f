// SPDX-License-Identifier: Apache-2.0
// The pipeline made of glass: what each stage of the soft engine makes of a model, as pictures, tables and a page.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <rakelight/export.h>
#include <rakelight/picture.h>

namespace rakelight {

/// What was written.
struct StagesResult {
    std::string file{}, folder{};      ///< the model; what was written
    std::vector<std::string> files{};  ///< names in the folder, index.html first; empty: `folder` is a page alone
};

/// A folder of files, or one page.
enum class StagesForm : std::uint8_t {
    folder,
    single_file  ///< `request.output` names a page that holds its pictures and tables itself
};

/// Writes a folder with index.html (readable without scripts), a JSON table for each stage and PNG pictures: model, world,
/// camera and clip space, clipped polygons, normalized device coordinates, screen, culled faces, coverage, depth,
/// visibility, normals, each light's terms, the picture. `request.output` names the folder. All of it appears at once or not
/// at all; a folder that exists is replaced when it is empty or holds nothing but what this function once wrote.
/// @throws Error usage: more than 16 million pixels, impossible settings; failed: the folder holds other things or cannot be
///         written; not_found, bad_file
RL_API StagesResult write_stages(const PictureRequest& request, Context& context, StagesForm form = StagesForm::folder);

}  // namespace rakelight
