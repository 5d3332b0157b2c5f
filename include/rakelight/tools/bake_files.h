// SPDX-License-Identifier: Apache-2.0
// Baking with files: writes maps as pictures, and the matching model.
#pragma once
#include <span>
#include <string>
#include <vector>

#include <rakelight/bake/bake.h>
#include <rakelight/base/export.h>
#include <rakelight/tools/report_row.h>
#include <rakelight/world/load.h>

namespace rakelight {

/// Options of bake_files().
struct BakeRequest {
    std::string high{}, low{};  ///< inputs of load()
    std::string output{};       ///< name of the PNG or EXR pictures; {map} becomes the name of the map
    std::string model{};        ///< output model, .glb or .gltf; empty: no model is written
    int bits = 0;               ///< PNG: 8 or 16 bits; 0: 16 bits for heights, 8 bits for all other maps
    BakeOptions options{};
    LoadOptions load{};
};

/// A written picture.
struct BakedFile {
    BakeMap map = BakeMap::normal;
    std::string file{};  ///< path
};

/// Result of bake_files().
struct BakeFilesResult {
    std::string high{}, low{};  ///< as they were named
    std::vector<BakedFile> files{};
    std::string model{};        ///< the written model, or empty
    int width = 0, height = 0;  ///< [px]
    BakeReport report{};
};

/// Bakes the maps and writes them as pictures. The file BakeRequest::model gets LOW with the texture coordinates,
/// normals and tangents that fit the maps. In its materials, the baked 8-bit maps of normals (tangent space) and
/// occlusion replace the original maps. Outputs appear complete or not at all.
/// @throws Error usage: a format that cannot hold a map, one name for several maps; failed: an output cannot be
///         written; and as load() and bake_maps()
RL_API BakeFilesResult bake_files(const BakeRequest& request, Context& context);

/// One line: the written files and the cage distance.
RL_API std::string summary(const BakeFilesResult& result);

/// A row of `bake --json`.
struct BakeRow : ReportRow {
    BakeFilesResult result{};  ///< at least `high` and `low`
};

/// {"schema": "rakelight.bake/1", "rows": [...]}
RL_API std::string to_json(std::span<const BakeRow> rows);

}  // namespace rakelight
