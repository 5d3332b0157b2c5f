// SPDX-License-Identifier: Apache-2.0
// Where the ray of a pixel hits a relief. A relief's heights are in 0..1, and the polygon is at `level` between them.
// `along` is the change of texture coordinates from height 0 to 1 on the way to the eye or the light, so the ray
// passes the height h at uv + along * (h - level). Maps are read at one level of detail, `lod`: that of the pixel.
// Sources: Kaneko et al. 2001, "Detailed Shape Representation with Parallax Mapping" (plain); Welsh 2004, "Parallax
// Mapping with Offset Limiting"; McGuire & McGuire 2005, "Steep Parallax Mapping"; Tatarchuk 2006, "Dynamic Parallax
// Occlusion Mapping", with the bisections of Policarpo et al. 2005, "Real-Time Relief Mapping on Arbitrary Polygonal
// Surfaces".

#define RL_GRAZING 0.02f  // lowest cosine that an offset is divided by: 88.9 degrees

// Of a unit direction d in (tangent, bitangent, normal): lengths along tangent and bitangent for one along the normal.
RL_FN vec2 relief_run(vec3 d)
{
    real rise = max(d.z, RL_GRAZING);
    return vec2(d.x / rise, d.y / rise);
}

// The same without the division: never longer, and bounded at grazing angles (offset limiting).
RL_FN vec2 relief_run_limited(vec3 d)
{
    return vec2(d.x, d.y);
}

// Layers for a ray: `fewest` seen from above, `most` at a grazing angle.
RL_FN real relief_layers(real cosine, int fewest, int most)
{
    real share = clamp(cosine, 0.0f, 1.0f);
    return floor(real(float(most)) + (real(float(fewest)) - real(float(most))) * share + 0.5f);
}

// Height of the point that plain parallax takes: the one under the pixel, even if it is hidden.
RL_MAP_FN real parallax_height(RL_IN(Maps) maps, vec2 uv, real lod)
{
    return sample_height(maps, uv, lod);
}

// Two heights of a ray between which it enters the relief, and how high the relief stands over the ray there: a gap < 0
// before, >= 0 after. Both the same where the ray starts inside.
struct ReliefHit {
    real before;
    real gap_before;
    real height;
    real gap;
};

// Steep parallax: the ray goes down layer by layer and stops at the first that lies in the relief. layers <= most.
RL_MAP_FN ReliefHit first_layer(RL_IN(Maps) maps, vec2 uv, vec2 along, real level, real layers, int most, real lod)
{
    real thickness = reciprocal(layers);
    ReliefHit hit;
    hit.before = 1.0f;
    hit.gap_before = 0.0f;
    hit.height = 1.0f;
    hit.gap = 0.0f;
    mask is_above = layers > 0.0f;
    for (int i = 0; i <= most + 1; ++i) {
        real height = max(1.0f - real(float(i)) * thickness, 0.0f);
        real gap = sample_height(maps, uv + along * (height - level), lod) - height;
        hit.before = select(is_above, hit.height, hit.before);
        hit.gap_before = select(is_above, hit.gap, hit.gap_before);
        hit.height = select(is_above, height, hit.height);
        hit.gap = select(is_above, gap, hit.gap);
        is_above = is_above && gap < 0.0f && height > 0.0f;
        if (no_lane(is_above)) {
            return hit;
        }
    }
    return hit;
}

// Parallax occlusion: the crossing between the two heights, by bisections and at last along the line between them.
RL_MAP_FN real refined_height(RL_IN(Maps) maps, vec2 uv, vec2 along, real level, RL_IN(ReliefHit) hit, int bisections, real lod)
{
    real above = hit.before;
    real gap_above = hit.gap_before;
    real below = hit.height;
    real gap_below = hit.gap;
    for (int i = 0; i < bisections; ++i) {
        real middle = 0.5f * (above + below);
        real gap = sample_height(maps, uv + along * (middle - level), lod) - middle;
        mask is_inside = gap >= 0.0f;
        below = select(is_inside, middle, below);
        gap_below = select(is_inside, gap, gap_below);
        above = select(is_inside, above, middle);
        gap_above = select(is_inside, gap_above, gap);
    }
    real share = clamp(-gap_above / max(gap_below - gap_above, 1e-9f), 0.0f, 1.0f);
    return above + (below - above) * share;
}

// 1 where no height stands between the relief's point at uv, `height` and the light, else 0; uv is the point's own. `cosine`: of the
// light to the polygon's normal; what is lit from under the polygon lies in its shadow.
RL_MAP_FN real relief_light(RL_IN(Maps) maps, vec2 uv, real height, vec2 along, real cosine, real layers, int most, real lod)
{
    real room = 1.0f - height;
    real step_share = reciprocal(layers);
    mask is_hidden = layers <= 0.0f || cosine <= 0.0f;
    for (int i = 0; i < most; ++i) {
        real share = (real(float(i)) + 0.5f) * step_share;
        real up = room * share;
        real there = sample_height(maps, uv + along * up, lod);
        is_hidden = is_hidden || (share < 1.0f && there > height + up);
        if (all_lanes(is_hidden)) {
            return 0.0f;
        }
    }
    return select(is_hidden, 0.0f, 1.0f);
}
