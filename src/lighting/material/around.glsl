// SPDX-License-Identifier: Apache-2.0
// What a surface reflects of light from the environment: ambient light, and the environment.
// Source of the split sum: Karis 2013, "Real Shading in Unreal Engine 4".

// Cosine at which the tables of the lobe's albedos are read for a direction of light, or that to the viewer.
RL_FN real table_cosine(RL_IN(MaterialSurface) s, vec3 d, RL_IN(MaterialTraits) traits)
{
    real cosine = dot(s.base.n, d);
    if (traits.is_anisotropic == 0) {
        return cosine;
    }
    real even_cosine = equal_cosine(cosine, dot(s.tangent, d), dot(s.bitangent, d), s.alpha_x, s.alpha_y);
    return select(s.alpha_x > s.alpha_y, even_cosine, cosine);
}

// Even light from the environment under pbr: what each layer reflects of it, from `occlusion` and the parts that depend on v.
RL_FN void set_pbr_around(RL_INOUT(MaterialSurface) s, RL_IN(ViewAlbedo) albedo, real occlusion)
{
    real steep = albedo.lobe - albedo.grazing;
    vec3 specular = s.base.specular * steep + s.f90 * albedo.grazing + s.scattering * (1.0f - albedo.lobe);
    real lost = s.dielectric_f0 * steep + s.dielectric_f90 * albedo.grazing;
    real under_sheen = sheen_rest(s.sheen, s.sheen_albedo, s.sheen_albedo);
    real under_coat = (1.0f - s.coat_reflectance) * occlusion;
    s.around_diffuse = s.base.ambient * ((1.0f - lost) * under_sheen * under_coat);
    s.around_specular = specular * (under_sheen * under_coat);
    s.around_sheen = s.sheen * (s.sheen_albedo * under_coat);
    s.around_coat = s.coat_reflectance * albedo.coat * occlusion;
    s.base.ambient = s.around_diffuse + s.around_specular + s.around_sheen + vec3(s.around_coat);
}

// [nm] KHR_materials_iridescence: green leads from one to the other.
RL_FN real film_thickness(real least, real greatest_thickness, vec4 texel)
{
    return mix(least, greatest_thickness, texel.y);
}

// A film over the surface, by the f0 whose Schlick term is the film's reflectance towards v. So all that follows takes
// it as it takes any other. The arguments strength, thickness [nm] and index are those of the film. To be called once n
// and v are known.
RL_FN void set_iridescence(RL_INOUT(MaterialSurface) s, real strength, real thickness, real index)
{
    real cosine = dot(s.base.n, s.base.v);
    real weight = min(schlick_weight(cosine), 0.99f);
    vec3 film = film_reflectance(s.base.specular, max(index, 1.0f), thickness * 1e-3f, cosine);
    vec3 f0 = (film - s.f90 * weight) / (1.0f - weight);
    f0 = min(max(f0, vec3(0.0f)), vec3(1.0f));
    real part = select(thickness > 0.0f, clamp(strength, 0.0f, 1.0f), 0.0f);
    s.base.specular = mix(s.base.specular, f0, part);
    s.dielectric_f0 = mix(s.dielectric_f0, greatest(f0), part);
}

// Albedos of pbr's layers towards the viewer, once all directions are known. The tables are read only for what is there: layers,
// light between the facets, light from the environment.
RL_MAP_FN void set_pbr_albedos(RL_INOUT(MaterialSurface) s, RL_IN(Maps) maps, real occlusion, int has_light_around, RL_IN(MaterialTraits) traits)
{
    real n_dot_v = dot(s.base.n, s.base.v);
    s.scattering = vec3(0.0f);
    s.sheen_albedo = 0.0f;
    s.albedo = 1.0f;
    s.albedo_mean = 1.0f;
    if (traits.has_sheen != 0) {
        s.sheen_albedo = sheen_albedo(maps, n_dot_v, s.sheen_alpha);
    }
    if (traits.has_coat != 0) {
        s.coat_reflectance = coat_reflectance(s.coat_reflectance, dot(s.coat_n, s.base.v));
    }
    if (has_light_around == 0 && traits.has_scattering == 0 && traits.has_transmission == 0) {
        return;
    }
    ViewAlbedo albedo;
    albedo.lobe = lobe_albedo(maps, table_cosine(s, s.base.v, traits), s.table_roughness);
    s.albedo = select(n_dot_v > 0.0f, albedo.lobe, 1.0f);  // nothing comes from under the horizon
    s.albedo_mean = lobe_mean(maps, s.table_roughness);
    if (traits.has_scattering != 0) {
        s.scattering = scattering_color(s.base.specular, s.f90, s.albedo_mean);
    }
    if (has_light_around == 0 && traits.has_transmission == 0) {
        return;
    }
    albedo.grazing = albedo.lobe * grazing_share(maps, n_dot_v, s.table_roughness);
    albedo.coat = 0.0f;
    if (traits.has_transmission != 0) {
        real lost = s.dielectric_f0 * (albedo.lobe - albedo.grazing) + s.dielectric_f90 * albedo.grazing;
        s.through = s.through * ((1.0f - lost) * sheen_rest(s.sheen, s.sheen_albedo, s.sheen_albedo) * (1.0f - s.coat_reflectance));
    }
    if (has_light_around == 0) {
        return;
    }
    if (traits.has_coat != 0) {
        albedo.coat = lobe_albedo(maps, dot(s.coat_n, s.base.v), sqrt(s.coat_alpha));
    }
    set_pbr_around(s, albedo, occlusion);
}

// What a coat leaves of the emission below it; after set_pbr_albedos().
RL_FN vec3 emission_under_coat(RL_IN(MaterialSurface) s, vec3 emission)
{
    return emission * (1.0f - s.coat_reflectance);
}

// What models other than pbr reflect of the environment: k_d, and k_s, of a textbook lobe by the mapping of classical_f0().
RL_FN void set_around(RL_INOUT(MaterialSurface) s, real occlusion, RL_IN(Reflection) r)
{
    s.coat_n = s.base.n;
    s.coat_alpha = 1.0f;
    s.around_coat = 0.0f;
    s.around_specular = vec3(0.0f);
    s.around_sheen = vec3(0.0f);
    s.around_diffuse = s.base.diffuse * occlusion;
    if (RL_IS_MATTE(r.model)) {
        s.roughness = 1.0f;
        return;
    }
    s.around_specular = s.base.specular * occlusion;
    if (r.model == RL_WARD) {
        return;
    }
    real alpha_squared = alpha_squared_of_exponent(s.base.exponent);
    s.roughness = sqrt(sqrt(alpha_squared));
    if (r.form == RL_TEXTBOOK) {
        s.around_specular = s.base.specular * min(1.0f, 4.0f * alpha_squared) * occlusion;
    }
}

// The same of metallic-roughness materials under Phong and Blinn-Phong: they mirror by the split sum, and are diffuse with what is
// left. After set_around().
RL_MAP_FN void set_split_sum(RL_INOUT(MaterialSurface) s, RL_IN(Maps) maps, vec3 f90, real occlusion)
{
    real n_dot_v = dot(s.base.n, s.base.v);
    real whole = lobe_albedo(maps, n_dot_v, s.roughness);
    real grazing = whole * grazing_share(maps, n_dot_v, s.roughness);
    vec3 albedo = s.base.specular * (whole - grazing) + f90 * grazing;
    s.around_diffuse = s.around_diffuse * (vec3(1.0f) - albedo);
    s.around_specular = albedo * occlusion;
}

// Albedos of the tables towards a light.
RL_MAP_FN LightAlbedo light_albedo(RL_IN(MaterialSurface) s, RL_IN(Maps) maps, vec3 l, RL_IN(MaterialTraits) traits, int model)
{
    LightAlbedo albedo;
    albedo.lobe = 0.0f;
    albedo.sheen = 0.0f;
    if (model != RL_PBR) {
        return albedo;
    }
    if (traits.has_scattering != 0) {
        albedo.lobe = lobe_albedo(maps, table_cosine(s, l, traits), s.table_roughness);
    }
    if (traits.has_sheen != 0) {
        albedo.sheen = sheen_albedo(maps, dot(s.base.n, l), s.sheen_alpha);
    }
    return albedo;
}
