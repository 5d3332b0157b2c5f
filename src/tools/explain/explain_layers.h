// SPDX-License-Identifier: Apache-2.0
// Explained pixels: the models of a shaded layer, and its maps with the probes and the texels that their values came from.
#pragma once
#include <string>

#include "shading/text_numbers.h"
#include "tools/explain/explain.h"

namespace rakelight {

/// "classical", "metallic_roughness" or "unlit"
const char* material_model(const ExplainedPixel& e, const raster::ShadedLayer& layer);
/// "lambert", "phong" or "blinn_phong"
const char* reflection_model(const raster::ShadedLayer& layer);
/// Bumps affect one of the two terms: the other has a separate normal.
bool has_own_diffuse_normal(const raster::ShadedLayer& layer);
/// Ward's and GGX: a lobe with widths.
inline bool has_microfacets(int reflection_model) {
    return reflection_model == shading::reflects_ward || reflection_model == shading::reflects_pbr;
}
/// More than Lambert, Phong and Blinn-Phong.
inline bool is_beyond_classical(int reflection_model) {
    return has_microfacets(reflection_model) || shading::is_oren_nayar(reflection_model);
}

/// The maps in the order of TextureRoleNumber: "base_color", "normal", ...
const char* name_of_map(int map);
/// The picture that a map of a layer's material reads, or empty.
std::string picture_of_map(const ExplainedPixel& e, const raster::ShadedLayer& layer, int map);
/// The maps that a layer read, as text; empty where it has none.
std::string maps_text(const ExplainedPixel& e, const raster::ShadedLayer& layer);

}  // namespace rakelight
