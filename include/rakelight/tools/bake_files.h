// SPDX-License-Identifier: Apache-2.0
// Baking from model file to model file: maps as pictures, and the model that they fit.
#pragma once
#include <string>
#include <vector>

#include <rakelight/bake.h>
#include <rakelight/export.h>
#include <rakelight/load.h>

namespace rakelight {

/// What bake_files() bakes.
struct BakeRequest {
    std::string high{}, low{};  ///< what load() takes
    std::string output{};       ///< name of the pictures; {map} stands for the map's. PNG or EXR
    std::string model{};        ///< .glb or .gltf; empty: none is written
    int bits = 0;               ///< PNG: 8 or 16; 0: 16 for heights, else 8
    BakeOptions options{};
    LoadOptions load{};
};

/// A picture that was written.
struct BakedFile {
    BakeMap map = BakeMap::normal;
    std::string file{};  ///< that was written
};

/// What bake_files() wrote.
struct BakeFilesResult {
    std::string high{}, low{};  ///< as they were named
    std::vector<BakedFile> files{};
    std::string model{};        ///< that was written, or empty
    int width = 0, height = 0;  ///< [px]
    BakeReport report{};
};

/// Bakes, and writes the pictures; to `model` LOW with the coordinates, normals and tangents that the maps fit, and with the maps
/// of normals (tangent space) and occlusion in its materials, 8 bits, in place of those it had. Outputs appear whole.
/// @throws Error usage: no picture that can hold a map, one name for several maps; what load() and bake_maps() throw;
///         failed: cannot write
RL_API BakeFilesResult bake_files(const BakeRequest& request, Context& context);

/// For people: what was written, and how far the cage stands off.
RL_API std::string summary(const BakeFilesResult& result);

}  // namespace rakelight
