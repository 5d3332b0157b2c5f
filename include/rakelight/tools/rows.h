// SPDX-License-Identifier: Apache-2.0
// The JSON reports of the program: the rows of `render`, and by their headers those of all other verbs.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include <rakelight/base/export.h>
#include <rakelight/render/picture.h>
#include <rakelight/tools/bake_files.h>
#include <rakelight/tools/check_scene.h>
#include <rakelight/tools/compare.h>
#include <rakelight/tools/convert_file.h>
#include <rakelight/tools/explain.h>
#include <rakelight/tools/inspect.h>
#include <rakelight/tools/reference_result.h>
#include <rakelight/tools/report_row.h>
#include <rakelight/tools/smooth_file.h>

namespace rakelight {

/// The position of a picture in a sequence.
struct FrameRow {
    std::int64_t frame = 0;   ///< number of the picture
    double time_s = 0;        ///< [s] time of the clip
    bool is_skipped = false;  ///< the file existed, so the row has only names
};

/// A row of `render --json`.
struct PictureRow : ReportRow {
    PictureResult result{};                      ///< at least `file` and `output`
    std::optional<ReferenceResult> reference{};  ///< if the picture was compared with a reference
    std::optional<FrameRow> frame{};             ///< if the picture belongs to a sequence
    std::size_t movie_pictures = 0;              ///< number of pictures of a movie; 0: the output is a picture
};

/// {"schema": "rakelight.render/1", "rows": [...]}
RL_API std::string to_json(std::span<const PictureRow> rows);

}  // namespace rakelight
