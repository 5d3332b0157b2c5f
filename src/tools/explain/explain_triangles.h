// SPDX-License-Identifier: Apache-2.0
// Explained pixels: the triangles that cover a pixel and its samples, and the object that it shows; where it shows none,
// the nearest pixel that does.
#pragma once
#include <string>

#include "tools/explain/explain.h"
#include "tools/report_json.h"

namespace rakelight {

/// Names of a covering triangle's parts; empty where the file gives none.
struct TriangleNames {
    std::string object, mesh, material;
    std::uint32_t node = no_index, mesh_index = no_index, material_index = no_index;  ///< into the scene's arrays
};
TriangleNames names_of(const ExplainedPixel& e, const raster::CoveringTriangle& triangle);

/// The name, "number 3" where it has none, or "(none)".
std::string name_or_number(const std::string& name, std::uint32_t index);

/// "visible", "blended", "hidden", "masked_out", "culled_back", "culled_front"
const char* word_for(raster::Fate fate);

/// The triangles that cover the pixel, if any does, and their depths by steps from pixel to pixel; tables.
std::string triangles_text(const ExplainedPixel& e);
/// What is visible at the pixel, or that nothing is and where the nearest surface is; lines.
std::string visible_text(const ExplainedPixel& e);
/// The same as fields of the pixel's row.
void add_visible(Json& row, const ExplainedPixel& e);

/// Pictures of several samples: for which a layer was shaded, and where; a line.
std::string shaded_at_text(const raster::ShadedLayer& layer);
/// The same: each sample, and the mean.
std::string samples_text(const ExplainedPixel& e);
Json samples_json(const ExplainedPixel& e);

}  // namespace rakelight
