// SPDX-License-Identifier: Apache-2.0
// Writes a model file in another format, with its normals as they are.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include <rakelight/base/export.h>
#include <rakelight/tools/report_row.h>
#include <rakelight/world/load.h>

namespace rakelight {

/// Result of convert_file().
struct ConvertedFile {
    std::string file{}, output{};       ///< as they were named
    bool is_copy = false;               ///< the formats are the same: the file was copied, with the files that it names
    std::uint64_t meshes = 0;           ///< number of triangle meshes
    std::uint64_t without_normals = 0;  ///< how many of them have no normals, in the output too
};

/// Reads `input` (a model, a world or a built-in shape) and writes `output`. Nothing is computed: positions, normals and
/// tangents stay as they are, and meshes without normals stay without. From glTF to GLB and back all data of the file is
/// kept. Other conversions write materials, textures, skins and clips as far as the format can express them, and the
/// report lists the rest. In OBJ and PLY all instances are in world space, and skinned models in bind pose.
///
/// `output` may be `input`. If it is in another folder, files that it refers to are copied to that folder, without
/// replacing existing files. All files of the output appear, or none.
/// @throws Error usage: no such output can be written; not_found; bad_file; failed: the output cannot be written
RL_API ConvertedFile convert_file(const std::string& input, const std::string& output, const LoadOptions& options,
                                  Context& context);

/// One line: what was written.
RL_API std::string summary(const ConvertedFile& result);

/// A row of `convert --json`.
struct ConvertedFileRow : ReportRow {
    ConvertedFile result{};  ///< at least `file` and `output`
};

/// {"schema": "rakelight.convert/1", "rows": [...]}
RL_API std::string to_json(std::span<const ConvertedFileRow> rows);

}  // namespace rakelight
