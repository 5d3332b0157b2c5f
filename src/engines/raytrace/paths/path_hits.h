// SPDX-License-Identifier: Apache-2.0
// The surfaces that the paths of a wave hit: their light, the emitters that they sample, and where the paths continue.
#pragma once
#include "engines/raytrace/paths/path_tile.h"

namespace rakelight::raytrace {

/// Fours of random numbers (PathNumbers::of()): of the pixel, then of each surface that a path meets.
inline constexpr std::uint32_t group_of_pixel = 0;
enum PathGroup : std::uint32_t { group_lobes, group_emitter, group_lights, groups_of_surface };
inline std::uint32_t group_of(std::uint32_t met, PathGroup which) { return 1 + met * groups_of_surface + which; }

/// @param is_direct  straight from a light to the first surface, or to the eye
inline void add_light(vec3 light, bool is_direct, const RenderSettings& settings, PathSample& to) {
    const auto most = float(settings.paths.clamp);
    const float greatest = std::max({light.x, light.y, light.z});
    if (!is_direct && most > 0 && greatest > most) light = light * (most / greatest);
    to.color = to.color + light;
    if (is_direct) to.direct = to.direct + light;
}

/// What of the light counts that a ray hits by chance: the balance heuristic.
/// @param density  [1/sr] with which that light would have been chosen
inline float share_by_chance(const PathPicture& picture, const PathState& state, float density) {
    if (!(state.pdf > 0) || !(density > 0)) return 1;
    if (picture.trace.settings.paths.light_sampling == LightSampling::lights) return 0;
    return state.pdf / (state.pdf + density);
}

/// Follows the rays of s.wave to the surfaces where they stay; what continues is in s.next and s.next_states.
void walk_wave(const PathPicture& picture, int depth, std::uint32_t sample, const Context& context, PathScratch& s);

/// Whether some of the emitter's light arrives; then the weight has what is left of it.
bool reaches_emitter(const PathPicture& picture, const Context& context, EmitterRay& ray, PathScratch& s);

}  // namespace rakelight::raytrace
