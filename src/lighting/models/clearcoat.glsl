// SPDX-License-Identifier: Apache-2.0
// Source: KHR_materials_clearcoat: a GGX lobe of index of refraction 1.5 over the material, which gets what the coat lets through.
// Its sampler is sample_ggx_isotropic() about the coat's normal.

// 0..1: share of the light that the coat reflects, seen from v; n_dot_v of the coat's own normal.
RL_FN real coat_reflectance(real coat, real n_dot_v)
{
    return coat * (0.04f + 0.96f * schlick_weight(abs(n_dot_v)));
}
