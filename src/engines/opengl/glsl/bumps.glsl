// SPDX-License-Identifier: Apache-2.0
// The normals that are lit: interpolated ones, bent by normal maps and by the slopes of heights; where the ray hits a
// relief, and the shadows that heights throw on each other; lighting in tangent space. As cpu_shading/kernels/normals.h,
// relief.h and tangent_space.h.
struct Bumps {
    Frame frame;
#if RL_RELIEF != RL_RELIEF_NONE
    Maps maps;
    float level;  // the height that lies in the polygon
    float lod;
    ReliefPoint point;
#endif
};

Frame frame_at(Point p)
{
#if RL_HAS_BUMPS
    Frame f = bump_frame(p.normal, p.side, p.tangent, p.w, RL_ORTHOGONALIZE, RL_NORMALIZE_FRAMES);
#if RL_HAS_BITANGENTS
    set_bitangent(f, p.bitangent, RL_NORMALIZE_FRAMES);
#endif
    return f;
#else
    return even_frame(p.normal, p.side);
#endif
}

#if RL_RELIEF != RL_RELIEF_NONE
// m_relief: depth, level; what one width along tangent and bitangent is in the mesh's coordinates and in the map's.
Relief relief()
{
    Relief r;
    r.technique = RL_RELIEF;
    r.fewest_layers = RL_FEWEST_LAYERS;
    r.most_layers = RL_MOST_LAYERS;
    r.bisections = RL_BISECTIONS;
    r.depth = m_relief.x;
    r.to_uv_u = m_relief_to_uv.xy;
    r.to_uv_v = m_relief_to_uv.zw;
    r.to_map_u = m_relief_to_map.xy;
    r.to_map_v = m_relief_to_map.zw;
    return r;
}

// Moves the texture coordinates to where the ray hits the relief.
void enter_relief(inout Point p, inout Bumps b)
{
    TexCoords c = height_coords(p);
    HeightSense sense = height_sense(b.frame.side, m_relief.y, RL_HOLDS_DEPTH);
    b.maps = plain_maps();
    b.maps.height_scale = sense.scale;
    b.maps.height_offset = sense.offset;
    b.level = sense.level;
    b.lod = level_of_detail(vec2(textureSize(rl_heights, 0)), c);
    vec3 v = to_viewer(p.position, rl_view_direction, RL_PARALLEL);
    b.point = relief_point(b.maps, relief(), c.uv, b.level, seen_in_frame(b.frame, v), b.lod);
#if RL_RELIEF != RL_RELIEF_HEIGHT
    TexCoords from = p.texcoords[RL_HEIGHT_SET];
    TexCoords other = p.texcoords[1 - RL_HEIGHT_SET];
    p.texcoords[1 - RL_HEIGHT_SET].uv = other.uv + same_move(from.dx, from.dy, other.dx, other.dy, b.point.move);
    p.texcoords[RL_HEIGHT_SET].uv = from.uv + b.point.move;
#endif
}

HeightLevels height_levels()
{
    HeightLevels levels;
    levels.texel = vec2(1.0) / vec2(textureSize(rl_heights, 0));
    levels.last = m_height_levels - 1.0;
    levels.mip = RL_HEIGHT_MIPS;
    return levels;
}

// In (tangent, bitangent, normal on the seen side), not unit.
vec3 slope_vector(Point p, Bumps b)
{
#if RL_ANISOTROPY > 1
    TexCoords c = height_coords(p);
    Probes probes = slope_probes(height_levels(), c.dx, c.dy, vec2(textureSize(rl_heights, 0)), b.lod, RL_ANISOTROPY);
    return relief_normal(relief(), filtered_slope(b.maps, height_levels(), b.point.uv, probes));
#else
    return relief_normal(relief(), slope_at(b.maps, height_levels(), b.point.uv, b.lod));
#endif
}
#endif

// The normal map's vector in (tangent, bitangent, normal), not unit.
vec3 mapped_vector(Point p)
{
#if RL_USES_NORMAL_MAP
    return decode_mapped(normal_texel(p).xyz, RL_NORMALS_ARE_SCALED != 0 ? m_normal_scale : 1.0, RL_CENTERED_NORMALS, RL_GREEN_DOWN);
#else
    return vec3(0.0, 0.0, 1.0);
#endif
}

// The normal that the maps give, on the side that is lit.
vec3 normal_of_maps(Point p, Bumps b)
{
#if RL_RELIEF == RL_RELIEF_HEIGHT || (RL_RELIEF != RL_RELIEF_NONE && !RL_USES_NORMAL_MAP)
    return sloped_normal(b.frame, slope_vector(p, b));
#elif RL_USES_NORMAL_MAP
    return mapped_normal(b.frame, mapped_vector(p), int(RL_TANGENT_SPACE == RL_SPACE_WORLD));
#else
    return b.frame.normal * b.frame.side;
#endif
}

#if RL_HAS_BUMPS && RL_TANGENT_SPACE != RL_SPACE_WORLD
#if RL_HAS_CORNER_FRAMES
vec3 through_corner(int k, vec3 d)
{
    vec3 n = safe_normalize(v_corner_normal[k]);
    vec3 t = map_tangent(n, v_corner_tangent[k], RL_ORTHOGONALIZE);
    vec3 b = cross(n, t) * RL_GIVEN(v_tangent.w);
#if RL_HAS_BITANGENTS
    b = safe_normalize_or(v_corner_bitangent[k], b);
#endif
    return to_tangent_space(n, t, b, int(RL_TANGENT_SPACE == RL_SPACE_TRANSPOSED), d);
}
#endif

// A direction of the world as the tangent space has it. to: the vectors from the three vertices, where it goes through them.
vec3 in_tangent_space(Frame f, vec3 world, vec3 to[3])
{
#if RL_HAS_CORNER_FRAMES
    vec3 b = RL_GIVEN(v_barycentric);
    vec3 d = through_corner(0, to[0]) * b.x + through_corner(1, to[1]) * b.y + through_corner(2, to[2]) * b.z;
#else
    vec3 d = to_tangent_space(f.map_normal, f.map_tangent, f.map_bitangent, 0, world);
#endif
    return tangent_space_direction(f, d, world);
}
#endif

vec3 viewer_at(Frame f, vec3 position)
{
    vec3 v = to_viewer(position, rl_view_direction, RL_PARALLEL_VIEWER);
#if RL_HAS_BUMPS && RL_TANGENT_SPACE != RL_SPACE_WORLD
    vec3 to[3];
#if RL_HAS_CORNER_FRAMES
    for (int k = 0; k < 3; ++k) {
        to[k] = vertex_to_viewer(v_corner_position[k], rl_view_direction, RL_PARALLEL_VIEWER);
    }
#endif
    return in_tangent_space(f, v, to);
#else
    return v;
#endif
}

vec3 light_direction_at(Frame f, int i, vec3 l)
{
#if RL_HAS_BUMPS && RL_TANGENT_SPACE != RL_SPACE_WORLD
    vec4 place = light_texel(i, 0);
    int kind = light_kind(i) & 3;
    if (kind == RL_AMBIENT_LIGHT) {
        return l;
    }
    vec3 to[3];
#if RL_HAS_CORNER_FRAMES
    for (int k = 0; k < 3; ++k) {
        to[k] = vertex_to_light(v_corner_position[k], place.xyz, light_texel(i, 1).xyz, int(kind == RL_DIRECTIONAL_LIGHT));
    }
#endif
    return in_tangent_space(f, l, to);
#else
    return l;
#endif
}

// 0..1: how much of light i passes the relief.
float relief_shadow_of(Bumps b, int i, vec3 l)
{
#if RL_RELIEF != RL_RELIEF_NONE && RL_SELF_SHADOW
    if (light_texel(i, 6).x != 0.0) {
        return relief_shadow(b.maps, relief(), b.point, seen_in_frame(b.frame, l), b.lod);
    }
#endif
    return 1.0;
}

// Alpha, < 0 where the relief ends at its texture's edge.
float alpha_in_silhouette(Bumps b, float alpha)
{
#if RL_RELIEF != RL_RELIEF_NONE && RL_LIMIT_SILHOUETTE
    return silhouette_alpha(alpha, b.point.is_outside, RL_IS_OPAQUE);
#else
    return alpha;
#endif
}
