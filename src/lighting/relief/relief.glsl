// SPDX-License-Identifier: Apache-2.0
// A relief at a pixel: where its ray arrives, the slope there, and the shadow of the heights on themselves.
#define RL_RELIEF_NONE 0
#define RL_RELIEF_HEIGHT 1    // only the normal is bent
#define RL_RELIEF_PARALLAX 2
#define RL_RELIEF_LIMITED 3
#define RL_RELIEF_STEEP 4
#define RL_RELIEF_OCCLUSION 5

// How a height map acts; the same for all lanes.
struct Relief {
    int technique;
    int fewest_layers;
    int most_layers;
    int bisections;
    real depth;        // [widths of the texture] from height 0 to 1
    vec2 to_uv_u;      // change of u for one width along the tangent and along the bitangent; then of v
    vec2 to_uv_v;
    vec2 to_map_u;     // the same of the map's own u, behind the transform of its slot; then of its v
    vec2 to_map_v;
};

// Heights as they stand out on the side that is seen: from behind, and in maps of depths, what is high is low.
struct HeightSense {
    real scale;   // height = offset + scale * texel
    real offset;
    real level;   // the height that lies in the polygon
};

// side: +1 on the front, -1 from behind.
RL_FN HeightSense height_sense(real side, real level, int holds_depth)
{
    real sense = side;
    if (holds_depth != 0) {
        sense = -side;
    }
    HeightSense out_sense;
    out_sense.scale = select(sense < 0.0f, -1.0f, 1.0f);
    out_sense.offset = select(sense < 0.0f, 1.0f, 0.0f);
    out_sense.level = select(side < 0.0f, 1.0f - level, level);
    return out_sense;
}

// Lengths along tangent and bitangent, in widths of the texture -> the map's coordinates, and the mesh's.
RL_FN vec2 relief_to_map(RL_IN(Relief) r, vec2 d)
{
    return vec2(r.to_map_u.x * d.x + r.to_map_u.y * d.y, r.to_map_v.x * d.x + r.to_map_v.y * d.y);
}

RL_FN vec2 relief_to_uv(RL_IN(Relief) r, vec2 d)
{
    return vec2(r.to_uv_u.x * d.x + r.to_uv_u.y * d.y, r.to_uv_v.x * d.x + r.to_uv_v.y * d.y);
}

// Texture coordinates of another set (from pixel to pixel to_dx, to_dy) move as far on the screen as those of the map's set.
RL_FN vec2 same_move(vec2 from_dx, vec2 from_dy, vec2 to_dx, vec2 to_dy, vec2 move)
{
    real area = from_dx.x * from_dy.y - from_dx.y * from_dy.x;
    mask has_area = abs(area) > 1e-30f;
    real per_area = select(has_area, 1.0f / select(has_area, area, 1.0f), 0.0f);
    real x = (move.x * from_dy.y - move.y * from_dy.x) * per_area;
    real y = (from_dx.x * move.y - from_dx.y * move.x) * per_area;
    return to_dx * x + to_dy * y;
}

// Where the ray hits the relief.
struct ReliefPoint {
    vec2 uv;          // the map's own
    vec2 move;        // of the mesh's coordinates
    real height;
    mask is_outside;  // of the texture's 0..1
};

// The height at which the ray along `along` (change of uv from height 0 to 1) is met.
RL_MAP_FN real met_height(RL_IN(Maps) maps, RL_IN(Relief) r, vec2 uv, vec2 along, real level, real cosine, real lod)
{
    if (r.technique != RL_RELIEF_STEEP && r.technique != RL_RELIEF_OCCLUSION) {
        return parallax_height(maps, uv, lod);
    }
    real layers = relief_layers(cosine, r.fewest_layers, r.most_layers);
    ReliefHit hit = first_layer(maps, uv, along, level, layers, r.most_layers, lod);
    if (r.technique == RL_RELIEF_STEEP) {
        return hit.height;
    }
    return refined_height(maps, uv, along, level, hit, r.bisections, lod);
}

RL_FN vec2 relief_run_by(int technique, vec3 d)
{
    if (technique == RL_RELIEF_LIMITED) {
        return relief_run_limited(d);
    }
    return relief_run(d);
}

// v: to the viewer, in (tangent, bitangent, normal on the seen side).
RL_MAP_FN ReliefPoint relief_point(RL_IN(Maps) maps, RL_IN(Relief) r, vec2 uv, real level, vec3 v, real lod)
{
    ReliefPoint point;
    point.uv = uv;
    point.move = vec2(0.0f);
    point.height = level;
    point.is_outside = level < -1.0f;
    if (r.technique == RL_RELIEF_HEIGHT) {
        return point;
    }
    vec2 run = relief_run_by(r.technique, v) * r.depth;
    vec2 along = relief_to_map(r, run);
    point.height = met_height(maps, r, uv, along, level, v.z, lod);
    real way = point.height - level;
    point.move = relief_to_uv(r, run) * way;
    point.uv = uv + along * way;
    point.is_outside = point.uv.x < 0.0f || point.uv.x > 1.0f || point.uv.y < 0.0f || point.uv.y > 1.0f;
    return point;
}

// Alpha, < 0 where the relief ends at its texture's edge; there opaque materials are masked, too.
RL_FN real silhouette_alpha(real alpha, mask is_outside, int is_opaque)
{
    if (is_opaque != 0) {
        return select(is_outside, -1.0f, 1.0f);
    }
    return select(is_outside, -1.0f, alpha);
}

// 0..1: how much of a light passes the heights; l to the light, as v above.
RL_MAP_FN real relief_shadow(RL_IN(Maps) maps, RL_IN(Relief) r, RL_IN(ReliefPoint) point, vec3 l, real lod)
{
    vec2 along = relief_to_map(r, relief_run(l) * r.depth);
    real ground = max(point.height, sample_height(maps, point.uv, lod));
    real layers = real(float(r.most_layers));  // few would show as teeth at the shadows' borders
    return relief_light(maps, point.uv, ground, along, l.z, layers, r.most_layers, lod);
}

// The levels of a height map.
struct HeightLevels {
    vec2 texel;  // its width and height at the largest level
    real last;
    int mip;     // 0: the largest level alone, 1: the nearest one, 2: mixed
};

// The level that slopes of a pixel, or of one probe of it, are read at; not below the largest picture.
RL_FN real slope_level(RL_IN(HeightLevels) levels, real lod)
{
    return clamp(lod + RL_SLOPE_DETAIL, 0.0f, levels.last);
}

// Texels of the largest level that heights of a slope lie apart: one of the level that is read.
RL_FN real slope_width(RL_IN(HeightLevels) levels, real level)
{
    if (levels.mip == 0) {
        return 1.0f;
    }
    if (levels.mip == 1) {
        return exp2(floor(level + 0.5f));
    }
    return exp2(level);
}

// Where slopes are read: as a normal map would be there, along the longer side of the footprint. lod: of a square one.
RL_FN Probes slope_probes(RL_IN(HeightLevels) levels, vec2 dx, vec2 dy, vec2 size, real lod, int most)
{
    int count = most;
    if (levels.mip == 0) {
        count = 1;
    }
    Probes p = probes_of(dx, dy, size, count);
    p.lod = select(p.is_stretched, p.lod, lod);
    return p;
}

// Change of height per unit of u and of v at one place.
RL_MAP_FN vec2 slope_at(RL_IN(Maps) maps, RL_IN(HeightLevels) levels, vec2 uv, real lod)
{
    real level = slope_level(levels, lod);
    real width = slope_width(levels, level);
    return height_slope(maps, uv, width * levels.texel.x, width * levels.texel.y, level);
}

// The mean slope of what the pixel covers, by its probes.
RL_MAP_FN vec2 filtered_slope(RL_IN(Maps) maps, RL_IN(HeightLevels) levels, vec2 uv, RL_IN(Probes) probes)
{
    vec2 sum = vec2(0.0f);
    for (int i = 0; any_lane(real(float(i)) < probes.count); ++i) {
        vec2 slope = slope_at(maps, levels, probe_place(probes, uv, i), probes.lod);
        sum = sum + select(real(float(i)) < probes.count, slope, vec2(0.0f));
    }
    return sum * probes.inverse;
}

// Normal of a relief of that slope in (tangent, bitangent, normal on the seen side), not unit.
RL_FN vec3 relief_normal(RL_IN(Relief) r, vec2 slope)
{
    return bumped_normal(r.depth * (slope.x * r.to_map_u.x + slope.y * r.to_map_v.x),
                         r.depth * (slope.x * r.to_map_u.y + slope.y * r.to_map_v.y));
}
