// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set: runs the lighting text over arrays, as an engine's kernel would.
#include "lighting_kernel.h"
#include "lighting/lighting.h"
#include "lighting/read_albedos.h"

namespace rakelight::lighting_test::RL_ISA {

RL_USE_WIDE;
using namespace rakelight::lighting::RL_ISA;
using rakelight::lighting::LightParameters;

// clang-format off
#include "operations.glsl"
#include "material_operations.glsl"
// clang-format on

inline real sample_albedo(const Maps&, int table, real x, real y) {
    return read_albedo(lighting::albedo_tables(), table, x, y);
}

static vec3 load3(const Inputs& in, int column, int at) {
    return vec3(load(in.column[column] + at), load(in.column[column + 1] + at), load(in.column[column + 2] + at));
}
static void store3(float* const* out, int at, vec3 x) {
    store(out[0] + at, x.x);
    store(out[1] + at, x.y);
    store(out[2] + at, x.z);
}

// Loads one step's items; not every function uses all of them.
#define RL_LOOP(step)                                                                                \
    for (int at = 0; at < in.count; at += lanes) {                                                   \
        [[maybe_unused]] vec3 n = load3(in, 0, at), l = load3(in, 3, at), v = load3(in, 6, at);      \
        [[maybe_unused]] vec3 ka = load3(in, 9, at), kd = load3(in, 12, at), ks = load3(in, 15, at); \
        [[maybe_unused]] vec3 p = load3(in, 18, at);                                                 \
        [[maybe_unused]] real e = load(in.column[21] + at), s = load(in.column[22] + at),            \
                              t = load(in.column[23] + at);                                          \
        step;                                                                                        \
    }

#define RL_REAL(name, result, absolute, relative) \
    static void run_##name(const Inputs& in, float* const* out) { RL_LOOP(store(out[0] + at, result)) }
#define RL_VEC3(name, result, absolute, relative) \
    static void run_##name(const Inputs& in, float* const* out) { RL_LOOP(store3(out, at, result)) }
#include "lighting_operations.inc"
#undef RL_REAL
#undef RL_VEC3

#define RL_REAL(name, result, absolute, relative) \
    {#name, 1, run_##name, #result, absolute, []([[maybe_unused]] float e) { return relative; }},
#define RL_VEC3(name, result, absolute, relative) \
    {#name, 3, run_##name, #result, absolute, []([[maybe_unused]] float e) { return relative; }},
static const Operation operations[] = {
#include "lighting_operations.inc"
};

static Reflection reflection_of(Choice choice) {
    Reflection reflection;
    reflection.model = choice.model;
    reflection.form = choice.form;
    reflection.horizon = choice.horizon;
    reflection.whole_exponent = choice.whole_exponent;
    return reflection;
}

static Surface surface_of(vec3 n, vec3 v, vec3 ka, vec3 kd, vec3 ks, real e, Choice choice) {
    Surface surface;
    surface.n = n;
    surface.v = v;
    surface.ambient = ka;
    surface.diffuse = kd;
    surface.specular = ks;
    surface.exponent = e;
    surface.lobe_scale = lobe_scale(e, reflection_of(choice));
    return surface;
}

static void terms_of_step(const Surface& surface, vec3 l, vec3 p, const LightParameters* light, Choice choice,
                          float* const* out, int at) {
    LightSample met;
    met.l = l;
    met.attenuation = 1.0f;
    met.ambient = met.diffuse = met.specular = vec3(1.0f);
    if (light != nullptr) met = sample_light(*light, p);
    const LightTerms terms = light_terms(surface, met, reflection_of(choice));
    store3(out, at, terms.ambient);
    store3(out + 3, at, terms.diffuse);
    store3(out + 6, at, terms.specular);
}

static void terms(const Inputs& in, const LightParameters* light, Choice choice, float* const* out) {
    RL_LOOP(terms_of_step(surface_of(n, v, ka, kd, ks, e, choice), l, p, light, choice, out, at))
}

static MaterialSurface material_of(vec3 n, vec3 v, vec3 ka, vec3 kd, vec3 ks, vec3 p, real e, real t) {
    MaterialSurface s;
    s.base = surface_of(n, v, ka, kd, ks, 1.0f, {});
    s.diffuse_n = s.coat_n = n;
    s.tangent = orthogonal_tangent(n, p);
    s.bitangent = cross(n, s.tangent);
    set_oren_nayar(s, e, kd);
    s.alpha_x = clamp(e, 1e-3f, 1.0f), s.alpha_y = clamp(t, 1e-3f, 1.0f);
    s.f90 = vec3(1.0f);
    s.dielectric_f0 = 0.04f, s.dielectric_f90 = 1.0f;
    s.scattering = ks, s.albedo = ka.y, s.albedo_mean = ka.z;
    s.sheen = ks, s.sheen_alpha = s.alpha_y, s.sheen_albedo = ka.x;
    s.coat_alpha = s.alpha_y, s.coat_reflectance = coat_reflectance(ka.x, dot(n, v));
    return s;
}

static void material_of_step(const MaterialSurface& s, vec3 l, vec3 ka, MaterialChoice choice, float* const* out,
                             int at) {
    const MaterialTraits traits = {choice.ward_form, choice.is_anisotropic, choice.has_scattering, choice.has_sheen,
                                   choice.has_coat};
    const vec3 one = vec3(1.0f);
    LightAlbedo albedo;
    albedo.lobe = ka.x, albedo.sheen = ka.y;
    const LightTerms terms = surface_terms(s, make_sample(l, 1.0f, one, one, one), 1.0f, albedo, traits,
                                           reflection_of({choice.model, 0, 1}));
    store3(out, at, terms.ambient);
    store3(out + 3, at, terms.diffuse);
    store3(out + 6, at, terms.specular);
}

static void material(const Inputs& in, MaterialChoice choice, float* const* out) {
    RL_LOOP(material_of_step(material_of(n, v, ka, kd, ks, p, e, t), l, ka, choice, out, at))
}

static void sum(const Inputs& in, const LightParameters* lights, int light_count, Choice choice, float* const* out) {
    RL_LOOP(vec3 total = vec3(0.0f);
            for (int i = 0; i < light_count; ++i) total = add_light(total, surface_of(n, v, ka, kd, ks, e, choice),
                                                                    sample_light(lights[i], p), reflection_of(choice));
            store3(out, at, total))
}

struct TestMap {
    int field;
};

static real sample_height(const TestMap& map, vec2 uv, real) {
    if (map.field == field_constant) return real(0.4f);
    if (map.field == field_ramp) return real(0.2f) + real(0.6f) * uv.x;
    if (map.field == field_step) return select(uv.x < real(0.5f), real(0.2f), real(0.8f));
    const vec2 from = uv - vec2(real(0.5f), real(0.5f));
    const real up = safe_sqrt(real(0.25f) - (from.x * from.x + from.y * from.y)) - real(0.3f);
    return real(0.25f) + real(3.0f) * max(up, real(0.0f));
}

static Relief relief_of(const ReliefCase& c) {
    static constexpr int techniques[] = {RL_RELIEF_PARALLAX, RL_RELIEF_LIMITED, RL_RELIEF_STEEP, RL_RELIEF_OCCLUSION};
    Relief r;
    r.technique = techniques[c.march];
    r.fewest_layers = c.min_steps, r.most_layers = c.max_steps, r.bisections = c.refinements;
    r.depth = real(c.depth);
    r.to_uv_u = vec2(real(1.0f), real(0.0f));
    r.to_uv_v = vec2(real(0.0f), real(1.0f));
    r.to_map_u = vec2(real(1.0f), real(0.0f));
    r.to_map_v = vec2(real(0.0f), real(1.0f));
    return r;
}

static void relief_of_step(vec3 p, vec3 v, vec3 l, const ReliefCase& c, float* const* out, int at) {
    const TestMap map = {c.field};
    const ReliefPoint point = relief_point(map, relief_of(c), vec2(p.x, p.y), real(c.level), v, real(0.0f));
    const real ground = max(point.height, sample_height(map, point.uv, real(0.0f)));
    store(out[0] + at, point.uv.x);
    store(out[1] + at, point.uv.y);
    store(out[2] + at, point.height);
    store(out[3] + at, relief_light(map, point.uv, ground, relief_run(l) * real(c.depth), l.z,
                                    relief_layers(l.z, c.min_steps, c.max_steps), c.max_steps, real(0.0f)));
}

static void relief(const Inputs& in, ReliefCase c, float* const* out) { RL_LOOP(relief_of_step(p, v, l, c, out, at)) }

static MaterialSurface surface_of(const PathSurface& c, vec3 n, vec3 v, vec3 diffuse_n, vec3 coat_n, vec3 p,
                                  const MaterialTraits& traits) {
    MaterialSurface s;
    s.base = surface_of(n, v, vec3(0.0f), broadcast3(c.kd), broadcast3(c.ks), c.exponent,
                        {c.model, RL_NORMALIZED, 1, c.whole_exponent});
    s.diffuse_n = c.has_two_normals != 0 ? diffuse_n : n;
    set_lobe_axes(s, p, 1.0f);
    set_oren_nayar(s, c.sigma, s.base.diffuse);
    s.alpha_x = c.alpha_x, s.alpha_y = c.alpha_y;
    s.table_roughness = sqrt(s.alpha_x);
    if (c.is_anisotropic != 0) s.table_roughness = equal_roughness(s.alpha_x, s.alpha_y);
    s.f90 = vec3(c.f90);
    s.dielectric_f0 = c.dielectric_f0, s.dielectric_f90 = c.f90;
    s.sheen = broadcast3(c.sheen), s.sheen_alpha = c.sheen_alpha;
    s.coat_n = coat_n, s.coat_alpha = c.coat_alpha, s.coat_reflectance = c.coat;
    set_pbr_albedos(s, test_maps(), 1.0f, 0, traits);
    return s;
}

static void paths_of_step(const MaterialSurface& s, const MaterialTraits& traits, const Reflection& r, vec3 l,
                          real choice, vec2 u, float* const* out, int at) {
    const LobeShares shares = lobe_shares(s, traits, r);
    const vec3 sampled = sample_surface(s, shares, traits, r, choice, u);
    store3(out, at, sampled);
    store(out[3] + at, surface_pdf(s, shares, sampled, traits, r));
    store3(out + 4, at, reflected_share(s, sampled, light_albedo(s, test_maps(), sampled, traits, r.model), traits, r));
    store(out[7] + at, surface_pdf(s, shares, l, traits, r));
    store3(out + 8, at, reflected_share(s, l, light_albedo(s, test_maps(), l, traits, r.model), traits, r));
    store3(out + 11, at, vec3(shares.diffuse, shares.specular, shares.scattering));
    store(out[14] + at, shares.sheen);
    store(out[15] + at, shares.coat);
}

static void paths(const Inputs& in, const PathSurface& c, float* const* out) {
    const MaterialTraits traits = {c.ward_form, c.is_anisotropic, c.has_scattering,
                                   c.has_sheen, c.has_coat,       c.has_two_normals};
    const Reflection r = reflection_of({c.model, RL_NORMALIZED, 1, c.whole_exponent});
    RL_LOOP(paths_of_step(surface_of(c, n, v, ka, kd, p, traits), traits, r, l, fract(e), vec2(fract(s), fract(t)), out,
                          at))
}

const Kernel kernel = {lanes,  operations, int(sizeof operations / sizeof operations[0]), terms, material, sum,
                       relief, paths};

}  // namespace rakelight::lighting_test::RL_ISA
