// SPDX-License-Identifier: Apache-2.0
// The result of explain(), and the names that its text and its JSON share.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include <rakelight/tools/explain.h>

#include "engines/raster/inspect/inspection.h"
#include "render/remarks/shader_terms.h"
#include "shading/text_numbers.h"
#include "tools/report_json.h"

namespace rakelight {

/// What the default look chose because it was not given.
struct LookChoice {
    std::string topic, value;  ///< "light", "the built-in studio ..."
};

struct ExplainedPixel {
    std::string file;
    std::shared_ptr<const raster::Inspection> engine;  ///< the scene, for names
    std::vector<LookChoice> look;                      ///< in the order of docs/default-look.md; empty: a plain picture
    raster::PixelExplanation pixel;
    std::optional<raster::PixelExplanation> nearest;  ///< if no surface is visible: the nearest pixel where one is
    std::optional<ShadedPixel> shaded;                ///< by shaders of the user's; `pixel` then has their color
    ToneSettings tone;
    vec4 displayed;  ///< linear, with exposure and tone curve, as it is encoded
    std::vector<std::uint8_t> codes;
};

/// Names of a covering triangle's parts; empty where the file gives none.
struct TriangleNames {
    std::string object, mesh, material;
    std::uint32_t node = no_index, mesh_index = no_index, material_index = no_index;  ///< into the scene's arrays
};
TriangleNames names_of(const ExplainedPixel& e, const raster::CoveringTriangle& triangle);

/// The nearest surface visible at a pixel; null: none.
const raster::CoveringTriangle* visible_triangle(const raster::PixelExplanation& pixel);
/// What is visible at the pixel, or that nothing is and where the nearest surface is; lines.
std::string visible_text(const ExplainedPixel& e);
/// The same as fields of the pixel's row.
void add_visible(Json& row, const ExplainedPixel& e);

/// What the look changed in a request, compared with the request before. @param engine opened on it
std::vector<LookChoice> look_choices(const PictureRequest& asked, const PictureRequest& looked,
                                     const raster::Inspection& engine);
/// The choices, and how the look's exposure acts; lines. Empty: there are none.
std::string look_text(const ExplainedPixel& e);
/// From light to codes where there is an exposure or a tone curve; lines, or nothing.
std::string code_text(const ExplainedPixel& e);

/// "0 (directional, sun)"
std::string name_of_light(const ExplainedPixel& e, std::size_t light);
/// Which term contributes most to the pixel; for a dark one the factors that make it dark. A line.
std::string conclusion_text(const ExplainedPixel& e);

/// "visible", "blended", "hidden", "masked_out", "culled_back", "culled_front"
const char* word_for(raster::Fate fate);

/// Pictures of several samples: a letter a sample, V visible, B blended, M masked out, H hidden, C culled, - not
/// covered.
std::string letters_of_samples(const ExplainedPixel& e, const raster::CoveringTriangle& triangle);
/// The same: for which samples a layer was shaded, and where; a line.
std::string shaded_at_text(const raster::ShadedLayer& layer);
/// The same: each sample, and the mean.
std::string samples_text(const ExplainedPixel& e);
Json samples_json(const ExplainedPixel& e);

/// The maps in the order of TextureRoleNumber: "base_color", "normal", ...
const char* name_of_map(int map);
/// The picture that a map of a layer's material reads, or empty.
std::string picture_of_map(const ExplainedPixel& e, const raster::ShadedLayer& layer, int map);

/// The maps that a layer read, as text; empty where it has none.
std::string maps_text(const ExplainedPixel& e, const raster::ShadedLayer& layer);

/// What shaders of the user's make of the pixel; lines.
std::string shaded_text(const ShadedPixel& shaded);
Json shaded_json(const ShadedPixel& shaded);

/// "classical", "metallic_roughness" or "unlit"
const char* material_model(const ExplainedPixel& e, const raster::ShadedLayer& layer);
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
/// "lambert", "phong" or "blinn_phong"
const char* reflection_model(const raster::ShadedLayer& layer);

/// What the textbook's depth (0 on the near plane, 1 on the far one) changes by for 1 of the depth key.
double standard_depth_per_key(const ExplainedPixel& e);

/// [m] in the world of a point relative to the eye.
dvec3 world_position(const ExplainedPixel& e, const float (&relative)[3]);

}  // namespace rakelight
