// SPDX-License-Identifier: Apache-2.0
// Computes texture coordinates for a whole scene on one map: charts (charts.h) packed on shelves (shelf_packing.h).
#pragma once
#include <cstdint>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

namespace rakelight::bake {

struct MadeCoordinates {
    Scene scene;
    std::uint32_t meshes = 0;  ///< instances that got coordinates
    double scale = 0;          ///< [px/m]
};

struct CoordinateOptions {
    int width = 1024, height = 1024, margin = 8;  ///< [px]
    std::uint32_t set = 0;                        ///< target set; higher sets are removed
    bool only_lit = false;                        ///< unlit materials get none
    const char* size_setting = "size";            ///< for errors
};

/// For every drawn triangle mesh. Missing lower sets get the same coordinates, and tangents are removed. Each instance
/// gets its own mesh; vertices at chart borders are split.
/// @param scene  valid, posed
/// @throws Error usage: the charts do not fit; bad_file: over the memory budget
MadeCoordinates make_coordinates(Scene scene, const CoordinateOptions& options, Context& context);

}  // namespace rakelight::bake
