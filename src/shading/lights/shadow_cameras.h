// SPDX-License-Identifier: Apache-2.0
// What each light sees: the cameras of its shadow maps (Williams 1978, "Casting Curved Shadows on Curved Surfaces").
#pragma once
#include <span>
#include <vector>

#include <rakelight/engines/engine.h>

#include "shading/draw_list.h"
#include "shading/lights/lights.h"
#include "shading/lights/shadow_factors.h"
#include "shading/picture_camera.h"

namespace rakelight::shading {

/// Axes of a map: x to the right, y up, z the way it looks.
struct MapAxes {
    dvec3 x, y, z;
};

/// What one map sees.
struct MapCamera {
    Camera camera;
    MapAxes axes;
    dvec3 eye;
};

/// A directional light has one parallel map about all that is drawn; a spot of at most 60 degrees about its axis one in
/// perspective; other spots and point lights six; ambient lights none.
std::uint64_t shadow_map_count(const Light& light);
/// Whether a picture has any. A scene so large that the numbers of maps would leave the range of floats has none: a warning.
bool has_shadow_maps(const DrawList& list, const RenderSettings& settings, Report& report);
/// A picture's settings as far as a map needs them. @param size  [texels] a side
RenderSettings map_settings(int size);

/// [bytes] of a map: its nearness as a float, its slopes as two codes of 16 bits.
inline constexpr std::uint64_t shadow_texel_bytes = 8;
/// Whether the shadow maps of these lights go into memory; nothing without shadows.
/// @throws Error usage: they need more than half of what MemoryBudget grants, or more than the scene leaves of it
void check_shadow_memory(std::span<const Light> lights, const RenderSettings& settings, const MemoryBudget& memory);

/// [shadow_map_count()] in the order of ShadowFactors::faces.
std::vector<MapCamera> shadow_cameras(const DrawList& list, const Light& light, const RenderSettings& settings);

/// @param first  camera of the light's first map
/// @param view   of its last one
/// @param faces  shadow_map_count()
/// @param eye    that positions are about
ShadowFactors shadow_factors(const MapCamera& first, const PictureCamera& view, std::size_t faces,
                             const RenderSettings& settings, dvec3 eye);

}  // namespace rakelight::shading
