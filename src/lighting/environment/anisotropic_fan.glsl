// SPDX-License-Identifier: Apache-2.0
// The environment in a surface that is rougher along t than across it: facets tilted along t alone, each as rough as the surface is
// across, which is what the prefiltered environment holds. Source: Heitz 2018, "Sampling the GGX Distribution of Visible Normals",
// for a width of 0 across t. (KHR_materials_anisotropy, section "Image-based lighting", not normative, has one bent normal and
// asks for further samples along t. These are such, and the normal is not bent: their mean is that of the lobe,
// tests/unit/lighting/models/anisotropic_fan_test.cpp.)

struct FacetRay {
    vec3 l;       // unit, where the facet mirrors v
    real weight;  // >= 0: share of the light from l that other facets let through; 0 below the horizon
};

// Width of the slopes that are left for the facets to have: GGX's alphas, wide >= narrow.
RL_FN real fan_width(real wide, real narrow)
{
    return safe_sqrt(wide * wide - narrow * narrow);
}

// The facet at `place`, 0..1, of all that v sees, evenly by the area that it sees of them; n, t unit and perpendicular.
// In the space stretched by the width the facets' normals are spread over a half circle, seen from v's stretched direction.
RL_FN FacetRay facet_ray(vec3 n, vec3 t, vec3 v, real width, real place)
{
    real v_n = max(dot(v, n), 1e-3f);
    real v_t = width * dot(v, t);
    real stretch_v = sqrt(v_t * v_t + v_n * v_n);
    real cosine = v_n / stretch_v;
    real sine = abs(v_t) / stretch_v;
    real across = place * (1.0f + cosine) - 1.0f;  // of the normal, off v's direction
    real along = safe_sqrt(1.0f - across * across);
    real side = select(v_t < 0.0f, -width, width);
    vec3 m = safe_normalize_or(t * (side * (sine * along + cosine * across)) + n * (cosine * along - sine * across), n);
    real v_dot_m = dot(v, m);
    FacetRay ray;
    ray.l = m * (v_dot_m + v_dot_m) - v;
    real l_n = max(dot(ray.l, n), 0.0f);
    real l_t = width * dot(ray.l, t);
    real stretch_l = sqrt(l_t * l_t + l_n * l_n);
    ray.weight = l_n * (stretch_v + v_n) / max(l_n * stretch_v + v_n * stretch_l, 1e-9f);
    return ray;
}
