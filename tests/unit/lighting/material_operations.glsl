// SPDX-License-Identifier: Apache-2.0
// operations.glsl goes on: materials with every layer, light from all around, all models, environment, shadow maps.

// Every layer, or none.
RL_FN MaterialTraits traits_with(int form, int all)
{
    MaterialTraits traits;
    traits.ward_form = form;
    traits.is_anisotropic = all;
    traits.has_scattering = all;
    traits.has_sheen = all;
    traits.has_coat = all;
    traits.has_two_normals = all;
    traits.has_transmission = all;
    traits.has_iridescence = all;
    return traits;
}

// A surface with every layer, whose directions are n, v and the tangent p.
RL_FN MaterialSurface any_material(vec3 n, vec3 v, vec3 ka, vec3 kd, vec3 ks, vec3 p, int model)
{
    MaterialSurface s;
    s.base = any_base(n, v, ka, kd, ks, 1.0f, any_reflection(model, RL_TEXTBOOK));
    set_metallic_lobe(s, any_metal(ka, kd, ks), kd, model);
    s.roughness = 0.2f + 0.8f * ka.y;
    set_even_widths(s);
    apply_anisotropy(s, ka.z, vec4(1.0f, 0.5f, 1.0f, 1.0f));
    set_sheen(s, ks, 0.3f + 0.7f * ka.x, vec4(0.5f), vec4(1.0f));
    set_coat(s, ka.x, 0.3f + 0.7f * kd.x, vec4(1.0f), vec4(1.0f));
    set_oren_nayar(s, ka.x, kd);
    set_normals(s, n, n, RL_BUMP_BOTH);
    set_lobe_axes(s, p, 1.0f);
    s.coat_n = n;
    set_pbr_albedos(s, test_maps(), 0.7f, 1, traits_with(RL_WARD_BOUNDED, 1));
    return s;
}

RL_FN vec3 equal_lobe(vec3 n, vec3 v, vec3 p, vec3 ka)
{
    MaterialSurface s;
    s.base.n = n;
    s.alpha_x = 0.1f + ka.x;
    s.alpha_y = 0.1f;
    set_lobe_axes(s, p, 1.0f);
    return vec3(table_cosine(s, v, traits_with(RL_WARD_BOUNDED, 1)), equal_roughness(s.alpha_x, s.alpha_y), 0.0f);
}

RL_FN vec3 around_pbr(vec3 n, vec3 v, vec3 ka, vec3 kd, vec3 ks, vec3 p)
{
    MaterialSurface s = any_material(n, v, ka, kd, ks, p, RL_PBR);
    return s.around_diffuse + s.around_specular + s.around_sheen + s.scattering + vec3(s.around_coat, s.albedo, s.albedo_mean);
}

RL_FN vec3 around_power(vec3 n, vec3 v, vec3 ka, vec3 kd, vec3 ks, real e)
{
    MaterialSurface s;
    s.base = any_base(n, v, ka, kd, ks, e, any_reflection(RL_PHONG, RL_TEXTBOOK));
    set_around(s, 0.7f, any_reflection(RL_PHONG, RL_TEXTBOOK));
    return s.around_diffuse + s.around_specular + vec3(s.roughness);
}

RL_FN vec3 around_metal(vec3 n, vec3 v, vec3 ka, vec3 kd, vec3 ks, real e)
{
    MaterialSurface s;
    s.base = any_base(n, v, ka, kd, ks, e, any_reflection(RL_PHONG, RL_NORMALIZED));
    set_around(s, 0.7f, any_reflection(RL_PHONG, RL_NORMALIZED));
    set_split_sum(s, test_maps(), vec3(1.0f), 0.7f);
    return s.around_diffuse + s.around_specular;
}

RL_FN vec3 albedos_to_light(vec3 n, vec3 l, vec3 v, vec3 ka, vec3 kd, vec3 ks, vec3 p)
{
    MaterialSurface s = any_material(n, v, ka, kd, ks, p, RL_PBR);
    LightAlbedo albedo = light_albedo(s, test_maps(), l, traits_with(RL_WARD_BOUNDED, 1), RL_PBR);
    return vec3(albedo.lobe, albedo.sheen, 0.0f);
}

RL_FN vec3 terms_at_corner(vec3 ka, vec3 kd, vec3 ks)
{
    LightTerms received;
    received.ambient = kd;
    received.diffuse = ks;
    received.specular = ka;
    vec3 up = vec3(0.0f, 0.0f, 1.0f);
    return radiance_of_terms(corner_terms(any_base(up, up, ka, kd, ks, 1.0f, any_reflection(RL_LAMBERT, RL_TEXTBOOK)), received));
}

RL_FN vec3 point_of(vec3 n, vec3 v, vec3 ka, real e)
{
    Surface base = unit_surface(n, v, e, any_reflection(RL_PHONG, RL_TEXTBOOK));
    MaterialSurface s = unit_material(base, test_maps(), ka.x, vec2(ka.y, ka.z));
    return s.tangent + s.bitangent + vec3(s.albedo, s.albedo_mean, s.alpha_x);
}

RL_FN vec3 power_terms(vec3 n, vec3 l, vec3 v, vec3 ka, vec3 kd, vec3 ks, real e, int model, int form)
{
    Reflection r = any_reflection(model, form);
    LightSample light = make_sample(l, 0.7f, ka, ks, kd);
    return add_light(ka, any_base(n, v, ka, kd, ks, e, r), light, r);
}

RL_FN vec3 power_terms_of(vec3 n, vec3 l, vec3 v, vec3 ka, vec3 kd, vec3 ks, real e, int model, int form, int horizon, int whole_exponent)
{
    Reflection r = any_reflection(model, form);
    r.horizon = horizon;
    r.whole_exponent = whole_exponent;
    LightSample light = make_sample(l, 0.7f, ka, ks, kd);
    LightTerms terms = light_terms(any_base(n, v, ka, kd, ks, e, r), light, r);
    // without the step at the horizon, which a rounding moves
    return terms.ambient + terms.diffuse + terms.specular * lambert_cosine(dot(n, l));
}

// pbr without layers and with one width.
RL_FN vec3 even_terms(vec3 n, vec3 l, vec3 v, vec3 ka, vec3 kd, vec3 ks, vec3 p)
{
    MaterialSurface s = any_material(n, v, ka, kd, ks, p, RL_PBR);
    s.alpha_x = s.alpha_y;
    LightSample light = make_sample(l, 0.7f, ka, ks, kd);
    LightAlbedo albedo = light_albedo(s, test_maps(), l, traits_with(RL_WARD_1992, 0), RL_PBR);
    return radiance_of_terms(surface_terms(s, light, 1.0f, albedo, traits_with(RL_WARD_1992, 0), any_reflection(RL_PBR, RL_TEXTBOOK)));
}

RL_FN vec3 around_model(vec3 n, vec3 v, vec3 ka, vec3 kd, vec3 ks, int model)
{
    MaterialSurface s;
    s.base = any_base(n, v, ka, kd, ks, 1.0f, any_reflection(model, RL_TEXTBOOK));
    s.roughness = 0.5f;
    set_around(s, 0.7f, any_reflection(model, RL_TEXTBOOK));
    return s.around_diffuse + s.around_specular + vec3(s.roughness);
}

RL_FN vec3 model_terms(vec3 n, vec3 l, vec3 v, vec3 ka, vec3 kd, vec3 ks, vec3 p, int model)
{
    MaterialSurface s = any_material(n, v, ka, kd, ks, p, model);
    LightSample light = make_sample(l, 0.7f, ka, ks, kd);
    LightAlbedo albedo = light_albedo(s, test_maps(), l, traits_with(RL_WARD_BOUNDED, 1), model);
    return radiance_of_terms(surface_terms(s, light, 0.5f, albedo, traits_with(RL_WARD_BOUNDED, 1), any_reflection(model, RL_TEXTBOOK)));
}

RL_FN Environment any_environment(vec3 ka, vec3 kd, vec3 ks, real s)
{
    Environment e;
    e.to_x = vec3(0.6f, 0.0f, -0.8f);
    e.to_y = vec3(0.0f, 1.0f, 0.0f);
    e.to_z = vec3(0.8f, 0.0f, 0.6f);
    e.intensity = 1.5f;
    e.last_level = 6.0f;
    e.irradiance.constant_part = vec3(1.0f);
    e.irradiance.by_y = ka;
    e.irradiance.by_z = kd;
    e.irradiance.by_x = ks;
    e.irradiance.by_xy = ka * s;
    e.irradiance.by_yz = kd * s;
    e.irradiance.by_zz = ks * s;
    e.irradiance.by_xz = ka - kd;
    e.irradiance.by_xx_yy = kd - ks;
    return e;
}

RL_FN vec3 shown_environment(vec3 n, vec3 v, vec3 ka, vec3 kd, vec3 ks, vec3 p, real s)
{
    MaterialSurface surface = any_material(n, v, ka, kd, ks, p, RL_PBR);
    return radiance_of_terms(environment_terms(test_maps(), any_environment(ka, kd, ks, s), surface, traits_with(RL_WARD_BOUNDED, 1), RL_PBR));
}

RL_FN real shadowed(vec3 n, vec3 p, int is_cube, int is_parallel)
{
    ShadowMap s;
    s.size = 64;
    s.is_cube = is_cube;
    s.is_parallel = is_parallel;
    s.radius = 1;
    s.right = vec3(1.0f, 0.0f, 0.0f);
    s.up = vec3(0.0f, 0.8f, 0.6f);
    s.ahead = vec3(0.0f, -0.6f, 0.8f);
    s.origin = vec3(0.1f, 0.2f, 5.0f);
    s.texels = 16.0f;
    set_reach(s, 1.0f);
    Maps maps = test_maps();
    if (is_parallel != 0) {
        maps.height_offset = -5.1f;
    }
    return shadow_factor(maps, s, p, n);
}

RL_FN vec3 environment_of_phong(vec3 n, vec3 v, vec3 ka, vec3 kd, vec3 ks, real e, real s)
{
    Reflection r = any_reflection(RL_PHONG, RL_NORMALIZED);
    MaterialSurface surface;
    surface.base = any_base(n, v, ka, kd, ks, e, r);
    surface.diffuse_n = n;
    set_around(surface, 0.7f, r);
    return radiance_of_terms(environment_terms(test_maps(), any_environment(ka, kd, ks, s), surface, traits_with(RL_WARD_1992, 0), RL_PHONG));
}

RL_FN LightTerms any_terms(vec3 ka, vec3 kd, vec3 ks)
{
    LightTerms terms;
    terms.ambient = ka;
    terms.diffuse = kd;
    terms.specular = ks;
    return terms;
}

// Each term by a weight of its own, so that none can stand for another.
RL_FN vec3 weighed_terms(RL_IN(LightTerms) t)
{
    return t.ambient + 2.0f * t.diffuse + 4.0f * t.specular;
}

RL_FN vec3 shown_base_color(vec3 kd, vec3 ks, int model)
{
    MaterialSurface s;
    s.base.diffuse = ks;
    show_base_color(s, kd, model);
    return s.base.diffuse;
}

RL_FN vec3 dielectric_of_point(vec3 ks, real strength)
{
    MaterialSurface s;
    set_point_dielectric(s, ks, strength);
    return vec3(s.dielectric_f0, s.dielectric_f90, fresnel_rest(s, 0.25f));
}

RL_FN vec3 reach_of(vec3 ka, int radius)
{
    ShadowMap s;
    s.texels = 1.0f + ka.x;
    s.radius = radius;
    set_reach(s, ka.y);
    return vec3(s.texel, s.push, s.reach);
}

// As any_material(), of a normalized model.
RL_FN MaterialSurface any_path_surface(vec3 n, vec3 v, vec3 ka, vec3 kd, vec3 ks, vec3 p, real e, int model)
{
    MaterialSurface s = any_material(n, v, ka, kd, ks, p, model);
    s.base = any_base(n, v, ka, kd, ks, e, any_reflection(model, RL_NORMALIZED));
    return s;
}

// The sum is 1: diffuse and coat are told by the others.
RL_FN vec3 shares_of(vec3 n, vec3 v, vec3 ka, vec3 kd, vec3 ks, vec3 p, int model)
{
    LobeShares shares = lobe_shares(any_path_surface(n, v, ka, kd, ks, p, 10.0f, model), traits_with(RL_WARD_BOUNDED, 1), any_reflection(model, RL_NORMALIZED));
    return vec3(shares.specular, shares.scattering + 2.0f * shares.sheen, shares.coat + 2.0f * shares.diffuse);
}

RL_FN LobeShares equal_shares()
{
    LobeShares shares;
    shares.diffuse = 0.2f;
    shares.specular = 0.2f;
    shares.scattering = 0.2f;
    shares.sheen = 0.2f;
    shares.coat = 0.2f;
    return shares;
}

// lobe: 0 diffuse ... 4 coat, which a random number could draw in one place and not in the other.
RL_FN vec3 sampled_lobe(vec3 n, vec3 v, vec3 ka, vec3 kd, vec3 ks, vec3 p, real e, vec2 u, int model, real lobe)
{
    MaterialSurface s = any_path_surface(n, v, ka, kd, ks, p, e, model);
    return sample_surface(s, equal_shares(), traits_with(RL_WARD_BOUNDED, 1), any_reflection(model, RL_NORMALIZED), 0.2f * lobe + 0.1f, u);
}

RL_FN real density_of(vec3 n, vec3 l, vec3 v, vec3 ka, vec3 kd, vec3 ks, vec3 p, real e, int model)
{
    MaterialSurface s = any_path_surface(n, v, ka, kd, ks, p, e, model);
    return surface_pdf(s, equal_shares(), l, traits_with(RL_WARD_BOUNDED, 1), any_reflection(model, RL_NORMALIZED));
}

// BRDF times cosine: the share of the radiance from l that goes to v, for a unit solid angle. `albedo`: light_albedo() of l.
RL_FN vec3 reflected_share(RL_IN(MaterialSurface) s, vec3 l, RL_IN(LightAlbedo) albedo, RL_IN(MaterialTraits) traits, RL_IN(Reflection) r)
{
    vec3 unit_irradiance = vec3(RL_INVERSE_PI);
    LightTerms terms = surface_terms(s, make_sample(l, 1.0f, vec3(0.0f), unit_irradiance, unit_irradiance), 1.0f, albedo, traits, r);
    return terms.diffuse + terms.specular;
}

RL_FN vec3 share_from(vec3 n, vec3 l, vec3 v, vec3 ka, vec3 kd, vec3 ks, vec3 p, real e, int model)
{
    MaterialSurface s = any_path_surface(n, v, ka, kd, ks, p, e, model);
    LightAlbedo albedo = light_albedo(s, test_maps(), l, traits_with(RL_WARD_BOUNDED, 1), model);
    return reflected_share(s, l, albedo, traits_with(RL_WARD_BOUNDED, 1), any_reflection(model, RL_NORMALIZED));
}

// Under a film, seen with the terms that follow from f0.
RL_FN MaterialSurface under_film(vec3 n, vec3 v, vec3 ka, vec3 kd)
{
    MaterialSurface s;
    s.base.n = n;
    s.base.v = v;
    s.base.specular = kd;
    s.f90 = vec3(1.0f);
    s.dielectric_f0 = greatest(kd);
    set_iridescence(s, ka.x, film_thickness(0.0f, 900.0f, vec4(0.0f, ka.y, 0.0f, 1.0f)), 1.0f + ka.z);
    return s;
}

RL_FN Body any_body(vec3 ka, vec3 kd, int bends, int parts)
{
    Body body;
    body.thickness = ka.x;
    body.eta = vec3(0.7f, 0.68f, 0.66f);
    body.attenuation = kd;
    body.blur = ka.y;
    body.bends = bends;
    body.parts = parts;
    return body;
}

RL_FN vec3 from_behind(vec3 n, vec3 v, vec3 ka, vec3 kd, vec3 p, int bends, int parts)
{
    MaterialSurface s;
    s.base.n = n;
    s.base.v = v;
    s.roughness = ka.z;
    s.base.diffuse = kd;
    s.base.ambient = kd;
    set_transmission(s, ka.y, vec4(ka.x, 1.0f, 1.0f, 1.0f));
    BehindView view;
    view.to_u = vec4(0.4f, 0.0f, -0.5f, 0.0f);
    view.to_v = vec4(0.0f, -0.4f, -0.5f, 0.0f);
    view.to_w = vec4(0.0f, 0.0f, -1.0f, 0.0f);
    view.last_level = 9.0f;
    return terms_from_behind(test_maps(), view, any_body(ka, kd, bends, parts), s, vec3(p.x, p.y, -2.0f - abs(p.z))).diffuse + s.base.diffuse + s.base.ambient;
}
