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

/// The level that slopes of a pixel, or of one probe of it, are read at; not below the largest picture.
inline real slope_level(const TextureView& t, real lod) {
    return clamp(lod + real(RL_SLOPE_DETAIL), real(0.0f), real(float(t.levels - 1)));
}

/// Texels of the largest picture that heights of a slope lie apart: one of the level that sample() reads for `level`.
inline real slope_width(const TextureView& t, real level) {
    if (t.mip == 0 || t.levels == 1) return real(1.0f);
    return exp2(t.mip == 1 ? to_real(to_int(level + real(0.5f))) : level);
}

/// Change of height per unit of u and of v at one place.
inline vec2 slope_at(const HeightMap& map, vec2 uv, real lod) {
    const TextureView& t = *map.view;
    const real level = slope_level(t, lod), texel = slope_width(t, level);
    return lit::height_slope(map, uv, texel * real(1.0f / float(t.width[0])), texel * real(1.0f / float(t.height[0])),
                             level);
}

/// Where slopes are read: as texel() would read a normal map there, along the longer side of the footprint.
inline Probes slope_probes(const HeightPlace& place, const TexCoords& c, int32_t most) {
    const TextureView& t = *place.map.view;
    Probes p = probes_of(t, c, t.mip == 0 || t.levels == 1 ? 1 : most);
    p.lod = select(p.is_stretched, p.lod, place.lod);
    return p;
}

/// The mean slope of what the pixel covers. `c`: the map's own coordinates, for their change from pixel to pixel.
inline vec2 filtered_slope(const HeightPlace& place, const TexCoords& c, int32_t most) {
    if (most <= 1) return slope_at(place.map, place.uv, place.lod);
    const Probes p = slope_probes(place, c, most);
    vec2 sum(real(0.0f), real(0.0f));
    for (int32_t i = 0; any_lane(real(float(i)) < p.count); ++i) {
        const vec2 slope = slope_at(place.map, p.place(place.uv, i), p.lod);
        const mask is_probe = real(float(i)) < p.count;
        sum.x = sum.x + select(is_probe, slope.x, real(0.0f));
        sum.y = sum.y + select(is_probe, slope.y, real(0.0f));
    }
    return sum * p.inverse;
}

/// Normal of a relief of that slope in (tangent, bitangent, normal on the seen side), not unit.
inline vec3 relief_normal(const ReliefView& r, vec2 slope) {
    const real depth = real(r.depth);
    return lit::bumped_normal(depth * (slope.x * real(r.to_map[0][0]) + slope.y * real(r.to_map[1][0])),
                              depth * (slope.x * real(r.to_map[0][1]) + slope.y * real(r.to_map[1][1])));
}

}  // namespace rakelight::raster::RL_ISA
