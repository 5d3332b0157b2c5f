// SPDX-License-Identifier: Apache-2.0
// What is seen through a transmissive surface: the picture of the opaque surfaces behind it, read where the refracted ray leaves the
// body, the smaller versions of it for rough surfaces. One layer: other transmissive surfaces are not in that picture.
// Sources: KHR_materials_transmission, KHR_materials_volume (refraction by a thickness, Beer-Lambert), KHR_materials_dispersion.

// The picture; the same for all lanes. Rows: a point about the eye -> u w, v w, w.
struct BehindView {
    vec4 to_u;
    vec4 to_v;
    vec4 to_w;
    real last_level;  // its mean
};

// What light goes through.
struct Body {
    real thickness;    // [m] along the refracted ray
    vec3 eta;          // 1 / index of refraction for red, green, blue
    vec3 attenuation;  // [1/m]
    real blur;         // 0..1, of the roughness
    int bends;         // 0: a thin wall
    int parts;         // 0: all of eta is one number
};

// What the diffuse term gives away. transmission 0..1, texel of its map. Under pbr, before what depends on directions.
RL_FN void set_transmission(RL_INOUT(MaterialSurface) s, real transmission, vec4 texel)
{
    real part = clamp(transmission * texel.x, 0.0f, 1.0f);
    s.through = s.base.diffuse * part;
    s.base.diffuse = s.base.diffuse * (1.0f - part);
    s.base.ambient = s.base.ambient * (1.0f - part);
}

RL_FN real row_at(vec4 row, vec3 p)
{
    return row.x * p.x + row.y * p.y + row.z * p.z + row.w;
}

// u, v of a point about the eye, kept on the picture.
RL_FN vec2 place_behind(RL_IN(BehindView) view, vec3 p)
{
    real w = max(row_at(view.to_w, p), 1e-20f);
    return vec2(clamp(row_at(view.to_u, p) / w, 0.0f, 1.0f), clamp(row_at(view.to_v, p) / w, 0.0f, 1.0f));
}

RL_MAP_FN vec3 behind_at(RL_IN(Maps) maps, RL_IN(BehindView) view, RL_IN(Body) body, RL_IN(MaterialSurface) s, vec3 position, real eta)
{
    real level = view.last_level * clamp(s.roughness * body.blur, 0.0f, 1.0f);
    vec3 place = position;
    if (body.bends != 0) {
        place = position + refracted(s.base.n, s.base.v, eta) * body.thickness;
    }
    return sample_behind(maps, place_behind(view, place), level);
}

RL_FN vec3 absorbed_by(RL_IN(Body) body)
{
    vec3 depth = body.attenuation * body.thickness;
    return vec3(exp(-depth.x), exp(-depth.y), exp(-depth.z));
}

// Radiance that arrives from behind, without the surface's own color; position about the eye.
RL_MAP_FN vec3 light_from_behind(RL_IN(Maps) maps, RL_IN(BehindView) view, RL_IN(Body) body, RL_IN(MaterialSurface) s, vec3 position)
{
    vec3 light = behind_at(maps, view, body, s, position, body.eta.x);
    if (body.parts != 0) {
        vec3 green = behind_at(maps, view, body, s, position, body.eta.y);
        vec3 blue = behind_at(maps, view, body, s, position, body.eta.z);
        light = vec3(light.x, green.y, blue.z);
    }
    return light * absorbed_by(body);
}

// The term of the sum; in the diffuse term's place.
RL_MAP_FN LightTerms terms_from_behind(RL_IN(Maps) maps, RL_IN(BehindView) view, RL_IN(Body) body, RL_IN(MaterialSurface) s, vec3 position)
{
    LightTerms terms = no_terms();
    terms.diffuse = s.through * light_from_behind(maps, view, body, s, position);
    return terms;
}
