// SPDX-License-Identifier: Apache-2.0
// The stages of the soft engine's pipeline for a model, as pictures, tables and an HTML page.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <rakelight/base/export.h>
#include <rakelight/render/picture.h>
#include <rakelight/tools/report_row.h>

namespace rakelight {

/// The written files.
struct StagesResult {
    std::string file{}, folder{};      ///< names of the model file, and of the written folder or page
    std::vector<std::string> files{};  ///< names in the folder, index.html first; empty: `folder` is a single page
};

/// The form of the output.
enum class StagesForm : std::uint8_t {
    folder,
    single_file  ///< `request.output` names a self-contained page
};

/// Writes a folder with index.html (readable without scripts), and a JSON table and PNG pictures for each stage.
/// - Stages of geometry: model, world, camera and clip space, clipped polygons, normalized device coordinates, screen.
/// - Stages of pixels: culled faces, coverage, depth, visibility, normals, the terms of each light, the picture.
///
/// `request.output` names the folder. All files appear at once or not at all. An existing folder is replaced if it is
/// empty or has only earlier output of this function.
/// @throws Error usage: more than 16 million pixels, impossible settings; failed: the folder has other contents or
///         cannot be written; not_found, bad_file
RL_API StagesResult write_stages(const PictureRequest& request, Context& context, StagesForm form = StagesForm::folder);

/// A row of `stages --json`.
struct StagesRow : ReportRow {
    StagesResult result{};  ///< at least `file` and `folder`
};

/// {"schema": "rakelight.stages/1", "rows": [...]}
RL_API std::string to_json(std::span<const StagesRow> rows);

}  // namespace rakelight
