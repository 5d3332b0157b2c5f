// SPDX-License-Identifier: Apache-2.0
// Where the light comes from that a whole surface reflects to v: one lobe is drawn, and a direction by the sampler beside the lobe's
// model. The density is that of all lobes together (Veach 1997, "Robust Monte Carlo Methods for Light Transport Simulation", section
// 9.2.4, the one-sample model), the weight of a direction BRDF times cosine over surface_pdf(). Normalized forms only.

// Probabilities of the lobes, together 1, or all 0 where nothing is reflected. Each is over 0 wherever its lobe is.
struct LobeShares {
    real diffuse;
    real specular;
    real scattering;  // between the facets
    real sheen;
    real coat;
};

// Finite and not below 0.
RL_FN real share_of(vec3 reflectance)
{
    return clamp(greatest(reflectance), 0.0f, 1e6f);
}

RL_FN LobeShares no_shares()
{
    LobeShares shares;
    shares.diffuse = 0.0f;
    shares.specular = 0.0f;
    shares.scattering = 0.0f;
    shares.sheen = 0.0f;
    shares.coat = 0.0f;
    return shares;
}

// All but the coat's, of what the coat leaves: the layers of add_layers(), by their albedos towards v.
RL_FN LobeShares shares_under_coat(RL_IN(MaterialSurface) s, RL_IN(MaterialTraits) traits)
{
    LobeShares shares = no_shares();
    real weight = max(schlick_weight(dot(s.base.n, s.base.v)), 0.01f);  // of light that meets the facets aslant a black mirror shows some
    shares.diffuse = share_of(s.base.diffuse) * clamp(fresnel_rest(s, 1.0f / 21.0f), 0.0f, 1.0f);  // Schlick's weight on average
    shares.specular = share_of(schlick(s.base.specular, s.f90, weight)) * clamp(s.albedo, 0.1f, 1.0f);
    if (traits.has_scattering != 0) {
        shares.scattering = share_of(s.scattering) * clamp(1.0f - s.albedo, 0.0f, 1.0f);
    }
    if (traits.has_sheen != 0) {
        real rest = sheen_rest(s.sheen, s.sheen_albedo, s.sheen_albedo);
        shares.diffuse = shares.diffuse * rest;
        shares.specular = shares.specular * rest;
        shares.scattering = shares.scattering * rest;
        shares.sheen = share_of(s.sheen) * max(s.sheen_albedo, 1e-3f);
    }
    return shares;
}

RL_FN LobeShares pbr_shares(RL_IN(MaterialSurface) s, RL_IN(MaterialTraits) traits)
{
    LobeShares shares = shares_under_coat(s, traits);
    if (traits.has_coat != 0) {
        real coat = clamp(s.coat_reflectance, 0.0f, 1.0f);
        shares.diffuse = shares.diffuse * (1.0f - coat);
        shares.specular = shares.specular * (1.0f - coat);
        shares.scattering = shares.scattering * (1.0f - coat);
        shares.sheen = shares.sheen * (1.0f - coat);
        shares.coat = select(dot(s.coat_n, s.base.v) > 0.0f, coat, 0.0f);
    }
    return shares;
}

// Lobes of facets show nothing to a v below their normal's horizon.
RL_FN LobeShares lobe_shares(RL_IN(MaterialSurface) s, RL_IN(MaterialTraits) traits, RL_IN(Reflection) r)
{
    LobeShares shares = no_shares();
    shares.diffuse = share_of(s.base.diffuse);
    if (r.model == RL_PHONG || r.model == RL_BLINN_PHONG || r.model == RL_WARD) {
        shares.specular = share_of(s.base.specular);
    }
    if (r.model == RL_PBR) {
        shares = pbr_shares(s, traits);
    }
    if (r.model == RL_WARD || r.model == RL_PBR) {
        mask is_seen = dot(s.base.n, s.base.v) > 0.0f;
        shares.specular = select(is_seen, shares.specular, 0.0f);
        shares.scattering = select(is_seen, shares.scattering, 0.0f);
        shares.sheen = select(is_seen, shares.sheen, 0.0f);
    }
    real sum = shares.diffuse + shares.specular + shares.scattering + shares.sheen + shares.coat;
    real scale = select(sum > 1e-20f, 1.0f / max(sum, 1e-20f), 0.0f);
    shares.diffuse = shares.diffuse * scale;
    shares.specular = shares.specular * scale;
    shares.scattering = shares.scattering * scale;
    shares.sheen = shares.sheen * scale;
    shares.coat = shares.coat * scale;
    return shares;
}

RL_FN vec3 sample_specular(RL_IN(MaterialSurface) s, RL_IN(MaterialTraits) traits, RL_IN(Reflection) r, vec2 u)
{
    if (r.model == RL_PHONG) {
        return sample_phong(s.base.n, s.base.v, s.base.exponent, u);
    }
    if (r.model == RL_BLINN_PHONG) {
        return sample_blinn_phong(s.base.n, s.base.v, s.base.exponent, u);
    }
    if (r.model == RL_WARD) {
        return sample_ward(s.base.n, s.tangent, s.bitangent, s.base.v, s.alpha_x, s.alpha_y, u);
    }
    if (traits.is_anisotropic != 0) {
        return sample_ggx(s.base.n, s.tangent, s.bitangent, s.base.v, s.alpha_x, s.alpha_y, u);
    }
    return sample_ggx_isotropic(s.base.n, s.base.v, s.alpha_x, u);
}

// [1/sr] of sample_specular(). The powers are those of light_sum.glsl.
RL_FN real specular_pdf(RL_IN(MaterialSurface) s, vec3 l, RL_IN(MaterialTraits) traits, RL_IN(Reflection) r)
{
    if (r.model == RL_PHONG || r.model == RL_BLINN_PHONG) {
        real cosine = lobe_cosine(s.base, l, r);
        if (r.model == RL_PHONG) {
            return phong_pdf(lobe(cosine, s.base.exponent, r), s.base.exponent);
        }
        return blinn_phong_pdf(lobe(abs(cosine), s.base.exponent, r), s.base.exponent, l, s.base.v);
    }
    if (r.model == RL_WARD) {
        return ward_pdf(s.base.n, s.tangent, s.bitangent, l, s.base.v, s.alpha_x, s.alpha_y);
    }
    if (traits.is_anisotropic != 0) {
        return ggx_anisotropic_pdf(s.base.n, s.tangent, s.bitangent, l, s.base.v, s.alpha_x, s.alpha_y);
    }
    return ggx_pdf(s.base.n, l, s.base.v, s.alpha_x);
}

// Unit direction to where light comes from; below the horizon, at times, where the BRDF is 0. Of any lobe where all shares
// are 0. `choice` and u: random numbers, even in 0..1 without 1, independent of each other.
RL_FN vec3 sample_surface(RL_IN(MaterialSurface) s, RL_IN(LobeShares) shares, RL_IN(MaterialTraits) traits, RL_IN(Reflection) r, real choice, vec2 u)
{
    vec3 l = sample_cosine(diffuse_normal(s, traits), u);
    real edge = shares.diffuse;  // lobe after lobe, on a line from 0 to 1
    if (!RL_IS_MATTE(r.model)) {
        mask is_drawn = choice >= edge && shares.specular > 0.0f;
        if (!RL_CAN_SKIP(is_drawn)) {
            l = select(is_drawn, sample_specular(s, traits, r, u), l);
        }
        edge = edge + shares.specular;
    }
    if (r.model == RL_PBR && traits.has_scattering != 0) {
        mask is_drawn = choice >= edge && shares.scattering > 0.0f;
        l = select(is_drawn, sample_cosine(s.base.n, u), l);
        edge = edge + shares.scattering;
    }
    if (r.model == RL_PBR && traits.has_sheen != 0) {
        mask is_drawn = choice >= edge && shares.sheen > 0.0f;
        l = select(is_drawn, sample_sheen(s.base.n, u), l);
        edge = edge + shares.sheen;
    }
    if (r.model == RL_PBR && traits.has_coat != 0) {
        mask is_drawn = choice >= edge && shares.coat > 0.0f;
        if (!RL_CAN_SKIP(is_drawn)) {
            l = select(is_drawn, sample_ggx_isotropic(s.coat_n, s.base.v, s.coat_alpha, u), l);
        }
    }
    return l;
}

// [1/sr] of sample_surface(), for any unit l.
RL_FN real surface_pdf(RL_IN(MaterialSurface) s, RL_IN(LobeShares) shares, vec3 l, RL_IN(MaterialTraits) traits, RL_IN(Reflection) r)
{
    real pdf = shares.diffuse * cosine_pdf(diffuse_normal(s, traits), l);
    if (!RL_IS_MATTE(r.model) && !RL_CAN_SKIP(shares.specular > 0.0f)) {
        pdf = pdf + shares.specular * specular_pdf(s, l, traits, r);
    }
    if (r.model == RL_PBR && traits.has_scattering != 0) {
        pdf = pdf + shares.scattering * cosine_pdf(s.base.n, l);
    }
    if (r.model == RL_PBR && traits.has_sheen != 0) {
        pdf = pdf + shares.sheen * sheen_pdf(s.base.n, l);
    }
    if (r.model == RL_PBR && traits.has_coat != 0 && !RL_CAN_SKIP(shares.coat > 0.0f)) {
        pdf = pdf + shares.coat * ggx_pdf(s.coat_n, l, s.base.v, s.coat_alpha);
    }
    return pdf;
}
