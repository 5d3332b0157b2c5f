// SPDX-License-Identifier: Apache-2.0
// Entry points of the lighting text that take structs, maps or change what they get, as functions of plain vectors: the rows of
// lighting_operations.inc. In the subset, so that C++ and a GPU evaluate the same.

struct Maps {
    real height_scale;
    real height_offset;
};

RL_FN Maps test_maps()
{
    Maps maps;
    maps.height_scale = 0.9f;
    maps.height_offset = 0.05f;
    return maps;
}

// A bowl, 0..1.
RL_FN real sample_height(RL_IN(Maps) maps, vec2 uv, real level)
{
    vec2 from = uv - vec2(0.4f, 0.6f);
    return maps.height_offset + maps.height_scale / (1.0f + dot(from, from) * (4.0f - level * 0.1f));
}

RL_FN vec3 sample_environment(RL_IN(Maps) maps, vec2 uv, real level)
{
    return vec3(uv.x, uv.y, maps.height_offset) * (2.0f - level * 0.2f);
}

RL_FN vec3 sample_sky(RL_IN(Maps) maps, vec2 uv, real level)
{
    return vec3(uv.x, uv.y, maps.height_scale + level * 0.01f);
}

RL_FN vec3 sample_behind(RL_IN(Maps) maps, vec2 uv, real level)
{
    return vec3(uv.x, uv.y, maps.height_scale + level * 0.1f);
}

// A surface that leans, before and behind the items. Parallel maps (test_maps(1)) hold minus a distance.
RL_FN real fetch_nearness(RL_IN(Maps) maps, real column, real row)
{
    return maps.height_offset + column * 0.003f + row * 0.001f;
}

RL_FN vec2 fetch_slopes(RL_IN(Maps) maps, real column, real row)
{
    return vec2(column * 0.01f, -row * 0.01f) * maps.height_scale;
}

// real sample_albedo(maps, table, x, y): of read_albedos.h and albedo_tables.glsl.

RL_FN vec3 arriving(RL_IN(LightSample) light)
{
    return light.l + (light.ambient + light.diffuse + light.specular) * light.attenuation;
}

// Its cone, exponent and range are the caller's.
RL_FN ClassicalLight any_classical(int type, vec3 l, vec3 ka, vec3 kd, vec3 ks)
{
    ClassicalLight light;
    light.type = type;
    light.position = l * 3.0f;
    light.direction = -l;
    light.ambient = ka;
    light.diffuse = kd;
    light.specular = ks;
    light.constant_term = 1.0f;
    light.linear_term = ka.x;
    light.quadratic_term = ka.y;
    return light;
}

RL_FN vec3 sampled_classical(vec3 l, vec3 ka, vec3 kd, vec3 ks, vec3 p)
{
    ClassicalLight light = any_classical(RL_SPOT_LIGHT, l, ka, kd, ks);
    light.cos_cutoff = -0.5f;
    light.exponent = ka.z;
    light.has_range = 1;
    light.inverse_range = 0.1f;
    return arriving(sample_classical(light, p));
}

RL_FN vec3 sampled_photometric(vec3 n, vec3 l, vec3 kd, vec3 p, real s)
{
    PhotometricLight light;
    light.type = RL_SPOT_LIGHT;
    light.position = l * 5.0f;
    light.direction = n;
    light.intensity = kd;
    light.inverse_range = 0.1f;
    light.cone_scale = 1.0f;
    light.cone_offset = s;
    return arriving(sample_photometric(light, p));
}

RL_FN Frame any_frame(vec3 n, vec3 p, real s)
{
    return bump_frame(n * 1.5f, select(s < 0.0f, real(-1.0f), real(1.0f)), p, 1.0f, 0, 1);
}

// Maps act along p made unit, whatever its angle to the others.
RL_FN vec3 mapped_along(vec3 n, vec3 v, vec3 l, vec3 p, real s, int normalize_both)
{
    Frame f = any_frame(n, v, s);
    set_bitangent(f, p, normalize_both);
    return mapped_normal(f, l, 1);
}

RL_FN Relief any_relief(int technique, vec3 ka, vec3 kd)
{
    Relief r;
    r.technique = technique;
    r.fewest_layers = 4;
    r.most_layers = 12;
    r.bisections = 6;
    r.depth = 0.1f * kd.x;
    r.to_uv_u = vec2(1.0f + ka.x, kd.x);
    r.to_uv_v = vec2(kd.x, -1.0f - ka.y);
    r.to_map_u = vec2(1.0f + ka.x, ka.z);
    r.to_map_v = vec2(ka.z, 1.0f + ka.y);
    return r;
}

RL_FN vec3 sense_of(real s, real level, int holds_depth)
{
    HeightSense sense = height_sense(select(s < 0.0f, real(-1.0f), real(1.0f)), level, holds_depth);
    return vec3(sense.scale, sense.offset, sense.level);
}

RL_FN vec3 framed(vec3 n, vec3 p, real s, int orthogonalize, int normalize_both)
{
    Frame f = bump_frame(n * 1.5f, s, p, 1.0f, orthogonalize, normalize_both);
    return f.map_normal + 2.0f * f.map_tangent + 3.0f * f.tangent;
}

RL_FN vec3 relief_scales(RL_IN(Relief) r, real s, real t)
{
    vec2 to_map = relief_to_map(r, vec2(s, t));
    return vec3(to_map.x, to_map.y, relief_to_uv(r, vec2(s, t)).y);
}

RL_FN vec3 moved(vec3 ka, vec3 kd, vec3 ks)
{
    vec2 move = same_move(vec2(1.0f + ka.x, ka.y), vec2(-ka.z, 1.0f + kd.x), vec2(kd.y, kd.z), vec2(ks.x, ks.y), vec2(ks.z, 0.5f));
    return vec3(move.x, move.y, 0.0f);
}

RL_FN vec3 met(int technique, vec3 ka, vec3 kd, vec3 v)
{
    vec3 eye = vec3(v.x, v.y, 0.3f + abs(v.z));
    ReliefPoint point = relief_point(test_maps(), any_relief(technique, ka, kd), vec2(kd.y, kd.z), 0.9f, eye, 1.0f);
    return vec3(point.uv.x, point.uv.y, point.height) + vec3(point.move.x, point.move.y, 0.0f);
}

RL_FN real shaded_relief(vec3 ka, vec3 kd, vec3 l)
{
    ReliefPoint point = relief_point(test_maps(), any_relief(RL_RELIEF_PARALLAX, ka, kd), vec2(kd.y, kd.z), 0.9f, vec3(0.0f, 0.0f, 1.0f), 1.0f);
    return relief_shadow(test_maps(), any_relief(RL_RELIEF_PARALLAX, ka, kd), point, l, 1.0f);
}

RL_FN vec3 probed(vec3 ka, vec3 kd, vec3 ks)
{
    Probes p = probes_of(vec2(ka.x, ka.y) * 0.01f, vec2(kd.x, kd.y) * 0.1f, vec2(512.0f, 256.0f), 16);
    vec2 place = probe_place(p, vec2(ks.x, ks.y), 1);
    return vec3(place.x, place.y, p.inverse + p.lod);
}

RL_FN vec3 sloped(vec3 ka, vec3 kd, vec3 ks)
{
    HeightLevels levels;
    levels.texel = vec2(0.01f, 0.02f);
    levels.last = 8.0f;
    levels.mip = 2;
    Probes p;
    p.is_stretched = ka.x >= 0.0f;
    p.count = 3.0f;
    p.inverse = 1.0f / p.count;
    p.lod = 2.0f * ka.y;
    p.axis = vec2(kd.x, kd.y) * 0.1f;
    vec2 slope = filtered_slope(test_maps(), levels, vec2(ks.x, ks.y), p);
    return vec3(slope.x, slope.y, slope_width(levels, slope_level(levels, p.lod)));
}

RL_FN Surface any_base(vec3 n, vec3 v, vec3 ka, vec3 kd, vec3 ks, real exponent, RL_IN(Reflection) r)
{
    Surface s = unit_surface(n, v, exponent, r);
    s.ambient = ka;
    s.diffuse = kd;
    s.specular = ks;
    return s;
}

// The rest of a light is as sampled_classical() has it.
RL_FN vec3 sampled_as(int type, vec3 l, vec3 ka, vec3 kd, vec3 ks, vec3 p)
{
    ClassicalLight light = any_classical(type, l, ka, kd, ks);
    light.cos_cutoff = 0.0f;
    light.exponent = 1.0f;
    light.has_range = 0;
    light.inverse_range = 0.0f;
    return arriving(sample_classical(light, p));
}

RL_FN Reflection any_reflection(int model, int form)
{
    Reflection r;
    r.model = model;
    r.form = form;
    r.horizon = 0;
    r.whole_exponent = 0;
    return r;
}

RL_FN MetallicRoughness any_metal(vec3 ka, vec3 kd, vec3 ks)
{
    MetallicRoughness at;
    at.metallic = ka.x;
    at.roughness = ka.y;
    apply_metallic_roughness(at, vec4(1.0f, kd.y, kd.z, 1.0f));
    apply_specular(at, ks, 0.8f, vec4(kd.x, kd.y, kd.z, 1.0f), vec4(1.0f, 1.0f, 1.0f, ka.z));
    return at;
}

RL_FN vec3 reflected_metal(vec3 ka, vec3 kd, vec3 ks)
{
    Surface s;
    set_metallic_reflectance(s, any_metal(ka, kd, ks), kd);
    return s.diffuse + s.specular + s.ambient;
}

RL_FN vec3 dielectric_of_metal(vec3 ka, vec3 kd, vec3 ks)
{
    MetallicRoughness at = any_metal(ka, kd, ks);
    return at.dielectric_f0 + metallic_f90(at) + vec3(at.metallic, at.roughness, 0.0f);
}

RL_FN vec3 reflected_classical(vec3 ka, vec3 kd, vec3 ks)
{
    Surface s;
    set_classical_reflectance(s, ka, ks, 10.0f, kd, vec4(kd.x, kd.y, kd.z, 1.0f));
    return s.ambient + s.specular + vec3(s.exponent);
}

RL_FN vec3 occluded(vec3 ka, vec3 kd, vec3 ks)
{
    Surface s;
    s.ambient = kd;
    apply_occlusion(s, ka.x, vec4(ks.x, 0.0f, 0.0f, 1.0f));
    return s.ambient;
}

RL_FN vec3 glow(vec3 ka, vec3 kd)
{
    MaterialSurface s;
    s.coat_reflectance = ka.x;
    return emission_under_coat(s, kd);
}

RL_FN vec3 lobe_of_classical(vec3 ks, real roughness)
{
    MaterialSurface s;
    s.base.specular = ks;
    set_classical_lobe(s, roughness, RL_TEXTBOOK);
    return s.base.specular + s.f90 + vec3(s.dielectric_f0, s.dielectric_f90, s.roughness);
}

RL_FN vec3 lobe_of_metal(vec3 ka, vec3 kd, vec3 ks)
{
    MaterialSurface s;
    set_metallic_lobe(s, any_metal(ka, kd, ks), kd, RL_PBR);
    set_even_widths(s);
    return s.base.specular + s.base.ambient + s.f90 + vec3(s.dielectric_f0, s.alpha_x, s.table_roughness);
}

RL_FN vec3 widths_of_ward(vec3 ka)
{
    MaterialSurface s;
    set_ward_widths(s, vec2(ka.x, ka.y));
    return vec3(s.alpha_x, s.alpha_y, s.roughness);
}

RL_FN vec3 widths_of_anisotropy(vec3 ka)
{
    MaterialSurface s;
    s.roughness = ka.x;
    set_even_widths(s);
    apply_anisotropy(s, ka.y, vec4(1.0f, 0.5f, ka.z, 1.0f));
    return vec3(s.alpha_x, s.roughness, s.table_roughness);
}

RL_FN vec3 sheen_of(vec3 ka, vec3 kd)
{
    MaterialSurface s;
    set_no_layers(s);
    set_sheen(s, ka, kd.x, vec4(kd.x, kd.y, kd.z, 1.0f), vec4(1.0f, 1.0f, 1.0f, ka.x));
    return s.sheen + vec3(s.sheen_alpha, s.coat_alpha, s.coat_reflectance);
}

RL_FN vec3 coat_of(vec3 ka, vec3 kd)
{
    MaterialSurface s;
    set_no_layers(s);
    set_coat(s, ka.x, ka.y, vec4(kd.x, 1.0f, 1.0f, 1.0f), vec4(1.0f, kd.y, 1.0f, 1.0f));
    return s.sheen + vec3(s.sheen_alpha, s.coat_alpha, s.coat_reflectance);
}

RL_FN vec3 slopes_of(real roughness)
{
    MaterialSurface s;
    set_oren_nayar(s, sigma_of_roughness(roughness), vec3(1.0f));
    return vec3(s.oren_nayar_a, s.oren_nayar_b, s.oren_nayar_bounce);
}

RL_FN vec3 normals_of(vec3 n, vec3 l, int terms)
{
    MaterialSurface s;
    set_normals(s, n, l, terms);
    return s.base.n + 2.0f * s.diffuse_n;
}

RL_FN vec3 axes_of(vec3 n, vec3 p, vec3 ka)
{
    MaterialSurface s;
    s.base.n = n;
    set_lobe_axes(s, p, -1.0f);
    turn_lobe_axes(s, vec2(0.6f, 0.8f), vec4(0.5f + 0.5f * ka.x, 0.5f + 0.5f * ka.y, 1.0f, 1.0f));
    return s.tangent + 2.0f * s.bitangent;
}

RL_FN HeightLevels levels_of_probes(int mip)
{
    HeightLevels levels;
    levels.texel = vec2(1.0f / 512.0f, 1.0f / 256.0f);
    levels.last = 9.0f;
    levels.mip = mip;
    return levels;
}

RL_FN vec3 probes_of_slopes(vec3 ka, vec3 kd, real t, int mip)
{
    Probes p = slope_probes(levels_of_probes(mip), vec2(ka.x, ka.y) * 0.01f, vec2(kd.x, kd.y) * 0.1f, vec2(512.0f, 256.0f), t, 16);
    return vec3(p.count, p.lod, p.axis.x);
}
