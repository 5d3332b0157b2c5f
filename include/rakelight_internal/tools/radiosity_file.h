// SPDX-License-Identifier: Apache-2.0
// Writes a radiosity solution as a glTF file for any viewer.
#pragma once
#include <optional>
#include <span>
#include <string>

#include <rakelight/bake/lightmap.h>
#include <rakelight/base/export.h>
#include <rakelight/radiosity/radiosity.h>
#include <rakelight/render/picture.h>
#include <rakelight/tools/report_row.h>

namespace rakelight {

/// Result of radiosity_file().
struct RadiosityFile {
    std::string file{}, output{};  ///< as they were named
    RadiosityReport report{};
    std::optional<LightmapReport> lightmap{};
};

/// Loads a model or world as render_picture() does, lights it by with_radiosity() and writes glTF 2.0 (.glb or .gltf).
/// The file has unlit materials (KHR_materials_unlit) and vertex colors (COLOR_0) in float, which may exceed 1. With
/// `lightmap` it has the original triangles, and a lightmap as emission texture instead of vertex colors:
/// with_lightmap().
/// @param request uses input, output, lights, normals, the time of a clip and settings.radiosity
/// @param lightmap absent: vertex colors
/// @throws Error usage: another ending of the output; as load(), with_radiosity() and save()
RL_API RadiosityFile radiosity_file(const PictureRequest& request, const std::optional<LightmapOptions>& lightmap,
                                    Context& context);

/// "room.glb: 19876 elements, 840 patches, 929 shots in 8.1 s; lightmap of 96 charts, 612.4 pixels a meter"
RL_API std::string summary(const RadiosityFile& result);

/// A row of `radiosity --json`.
struct RadiosityRow : ReportRow {
    RadiosityFile result{};  ///< at least `file` and `output`
};
/// {"schema": "rakelight.radiosity/1", "rows": [...]}
RL_API std::string to_json(std::span<const RadiosityRow> rows);

}  // namespace rakelight
