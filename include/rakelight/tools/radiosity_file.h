// SPDX-License-Identifier: Apache-2.0
// A scene with its light as the colors of its surfaces, as a file that any viewer of glTF shows.
#pragma once
#include <optional>
#include <span>
#include <string>

#include <rakelight/export.h>
#include <rakelight/lightmap.h>
#include <rakelight/picture.h>
#include <rakelight/radiosity.h>
#include <rakelight/tools/rows.h>

namespace rakelight {

/// What radiosity_file() wrote.
struct RadiosityFile {
    std::string file{}, output{};  ///< as they were named
    RadiosityReport report{};
    std::optional<LightmapReport> lightmap{};
};

/// Loads a model or world as a picture of it would, lights it by with_radiosity() and writes glTF 2.0 (.glb or .gltf):
/// unlit materials (KHR_materials_unlit) and COLOR_0 in float, which may exceed 1; or its own triangles with a lightmap as
/// the emission texture: with_lightmap().
/// @param request  input, output, lights, normals, the moment of a clip and settings.radiosity count
/// @param lightmap  none: colors of vertices
/// @throws Error usage: the output has another ending; what loading, with_radiosity() and writing throw
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
