// SPDX-License-Identifier: Apache-2.0
// Texture coordinates for all that a scene draws, on one map: charts (charts.h) packed on shelves (shelf_packing.h).
#pragma once
#include <cstdint>

#include <rakelight/context.h>
#include <rakelight/scene.h>

namespace rakelight::bake {

struct MadeCoordinates {
    Scene scene;
    std::uint32_t meshes = 0;  ///< placements that got coordinates
    double scale = 0;          ///< [px/m]
};

/// Set 0 of every drawn triangle mesh; other sets, and tangents, go. Each placement gets a mesh of its own; vertices on the
/// borders of charts are split.
/// @param scene  valid, posed
/// @throws Error usage: the charts do not fit; bad_file: over the memory budget
MadeCoordinates make_coordinates(Scene scene, int width, int height, int margin, Context& context);

}  // namespace rakelight::bake
