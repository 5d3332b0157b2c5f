// SPDX-License-Identifier: Apache-2.0
// Joins separately rendered windows of one picture.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/base/export.h>
#include <rakelight/tools/report_row.h>

namespace rakelight {

/// The file of a window.
struct WindowPart {
    /// PNG, EXR or HDR
    std::string file{};
    int x = -1, y = -1;  ///< [px] position of the window's top left pixel in the whole picture; -1: from the file
};

/// Options of join_windows().
struct JoinRequest {
    std::vector<WindowPart> parts{};
    std::string output{};       ///< the file to write
    int width = 0, height = 0;  ///< [px] of the whole picture; 0: from the parts
};

/// Result of join_windows().
struct JoinResult {
    std::string output{};       ///< the written file
    int width = 0, height = 0;  ///< [px]
    std::size_t parts = 0;      ///< number of parts
};

/// Joins the parts to the whole picture and writes it: PNG (8 or 16 bits per component), EXR (any channels) or HDR.
/// Parts and output must have the same format. Pixel values are copied. If parts overlap, their common pixels must be
/// equal. If render_picture() wrote the parts, the output equals the file of the whole picture, byte for byte. The
/// function works row by row, with memory for a few rows of each part. The output appears complete or not at all.
/// @throws Error usage: no parts, unknown position of a part, another format of the output; not_found; bad_file: parts
///         of different formats or pictures, a part outside of the picture, pixels that no part covers, overlapping
///         parts that differ, a broken part; failed: the output cannot be written, cancelled
RL_API JoinResult join_windows(const JoinRequest& request, Context& context);

/// A row of `join-windows --json`.
struct JoinRow : ReportRow {
    JoinResult result{};  ///< at least `output`
};

/// {"schema": "rakelight.join-windows/1", "rows": [...]}
RL_API std::string to_json(std::span<const JoinRow> rows);

}  // namespace rakelight
