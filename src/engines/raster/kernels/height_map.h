// SPDX-License-Identifier: Apache-2.0
// The height map of a job as the lighting text reads it (lighting/height_bump.glsl, parallax.glsl). Per instruction
// set.
#pragma once
#include "engines/raster/kernels/surface.h"

namespace rakelight::raster::RL_ISA {

/// Heights as they stand out on the side that is seen: from behind, and in maps of depths, what is high is low.
struct HeightMap {
    const TextureView* view;
    real offset, scale;  ///< height = offset + scale * texel
};

/// Where and how finely a pixel reads its height map; the map's own coordinates.
struct HeightPlace {
    HeightMap map;
    vec2 uv;
    real lod, level;  ///< level: the height that lies in the polygon
};

/// Always filtered linearly: a relief has no steps that its map's texels do not have.
inline real sample_height(const HeightMap& map, vec2 uv, real lod) {
    TexCoords at;
    at.uv = uv;
    return map.offset + map.scale * sample(*map.view, footprint_of(*map.view, at, lod, true)).x;
}

/// @param side  +1 on the front, -1 from behind
inline HeightPlace height_place(const ShadeJob& job, const TexCoords& raw, real side) {
    const ReliefView& relief = job.full->relief;
    const TextureSlot& slot = job.material->height_map;
    TexCoords room;
    const TexCoords& c = transformed(slot, raw, room);
    const real lod = level_of_detail(*slot.view, c);
    const mask is_turned = side * real(relief.holds_depth != 0 ? -1.0f : 1.0f) < real(0.0f);
    const real level = real(relief.level);
    return {{slot.view, select(is_turned, real(1.0f), real(0.0f)), select(is_turned, real(-1.0f), real(1.0f))},
            c.uv,
            lod,
            select(side < real(0.0f), real(1.0f) - level, level)};
}

/// Lengths along tangent and bitangent, in widths of the texture -> the map's coordinates, and the mesh's.
inline vec2 to_map(const ReliefView& r, vec2 d) {
    return vec2(real(r.to_map[0][0]) * d.x + real(r.to_map[0][1]) * d.y,
                real(r.to_map[1][0]) * d.x + real(r.to_map[1][1]) * d.y);
}
inline vec2 to_uv(const ReliefView& r, vec2 d) { return vec2(real(r.to_uv[0]) * d.x, real(r.to_uv[1]) * d.y); }

/// Normal of the relief in (tangent, bitangent, normal on the seen side), not unit.
inline vec3 relief_normal(const ReliefView& r, const HeightPlace& place) {
    const TextureView& t = *place.map.view;
    const real texel = exp2(clamp(place.lod, real(0.0f), real(float(t.levels - 1))));
    const vec2 slope = lit::height_slope(place.map, place.uv, texel * real(1.0f / float(t.width[0])),
                                         texel * real(1.0f / float(t.height[0])), place.lod);
    const real depth = real(r.depth);
    return lit::bumped_normal(depth * (slope.x * real(r.to_map[0][0]) + slope.y * real(r.to_map[1][0])),
                              depth * (slope.x * real(r.to_map[0][1]) + slope.y * real(r.to_map[1][1])));
}

}  // namespace rakelight::raster::RL_ISA
