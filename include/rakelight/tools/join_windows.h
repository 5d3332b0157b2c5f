// SPDX-License-Identifier: Apache-2.0
// Windows of one picture, rendered apart, put together to the whole.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include <rakelight/context.h>
#include <rakelight/export.h>

namespace rakelight {

/// The file of a window.
struct WindowPart {
    /// PNG, EXR or HDR
    std::string file{};
    int x = -1, y = -1;  ///< [px] of its top left pixel in the whole picture; -1: the file says it
};

/// What join_windows() joins.
struct JoinRequest {
    std::vector<WindowPart> parts{};
    std::string output{};       ///< to be written
    int width = 0, height = 0;  ///< [px] of the whole picture; 0: the parts say it
};

/// What join_windows() wrote.
struct JoinResult {
    std::string output{};       ///< that was written
    int width = 0, height = 0;  ///< [px]
    std::size_t parts = 0;      ///< how many
};

/// Writes the picture of which the parts are windows: PNG (8 or 16 bits a component), EXR (any channels) or HDR, all of one
/// kind, the output of the same. The numbers are those of the parts; what they cover several times has to be equal. Of
/// parts that render_picture() wrote, the file has the bytes of the whole picture written at once.
/// The pixels go row by row: memory is asked for a few rows of each part that a row meets. The output appears whole or not
/// at all.
/// @throws Error usage: no parts, a part or all do not say where they lie, the output is of another format; not_found;
///         bad_file: parts of different kinds or pictures, a part that reaches out of the picture, pixels that no part
///         covers, parts that differ where they overlap, a broken part; failed: the output cannot be written, cancelled
RL_API JoinResult join_windows(const JoinRequest& request, Context& context);

}  // namespace rakelight
