// SPDX-License-Identifier: Apache-2.0
// The surface as the equations see it: classical models need a Surface, those with more parameters a MaterialSurface.
// Models and forms are the same for all lanes ("uniform").
#define RL_LAMBERT 0
#define RL_PHONG 1
#define RL_BLINN_PHONG 2
#define RL_OREN_NAYAR 3
#define RL_WARD 4
#define RL_PBR 5
#define RL_OREN_NAYAR_FULL 6

// Models without a highlight.
#define RL_IS_MATTE(model) ((model) == RL_LAMBERT || (model) == RL_OREN_NAYAR || (model) == RL_OREN_NAYAR_FULL)

#define RL_TEXTBOOK 0
#define RL_NORMALIZED 1

struct Surface {
    vec3 n;         // unit, on the viewer's side
    vec3 v;         // unit, to the viewer
    vec3 ambient;   // k_a
    vec3 diffuse;   // k_d
    vec3 specular;  // k_s
    real exponent;  // >= 1
    real lobe_scale;  // of the specular term: see lobe_scale()
};

// How the terms are formed; the same for all lanes.
struct Reflection {
    int model;    // RL_LAMBERT ... RL_OREN_NAYAR_FULL; the sum of light_sum.glsl: RL_LAMBERT (no specular term), RL_PHONG, RL_BLINN_PHONG
    int form;     // RL_TEXTBOOK: k_s times the lobe, no cosine; RL_NORMALIZED: BRDF times pi n.l
    int horizon;  // 1: no specular where n.l <= 0; 0: the textbook's print. The normalized form has the cosine anyway
    int whole_exponent;  // that of all surfaces if it is a whole number from 1 on, else 0
};

// What one light adds, term by term (their sum is the radiance).
struct LightTerms {
    vec3 ambient;
    vec3 diffuse;
    vec3 specular;
};

struct MaterialSurface {
    Surface base;     // n: the normal of the specular term. Ward: specular is rho_s; pbr: f0
    vec3 diffuse_n;   // unit, the normal of the diffuse term: bumps may act on one of them alone
    vec3 tangent;     // unit, across base.n: the axes of Ward's and GGX's lobe
    vec3 bitangent;
    real oren_nayar_a;
    real oren_nayar_b;
    real oren_nayar_bounce;
    vec3 facet_color;     // of the full model: the albedo that interreflection is multiplied by
    real alpha_x;     // widths of Ward's and GGX's lobe, > 0
    real alpha_y;
    vec3 f90;
    real dielectric_f0;   // greatest component of what does not come from a metal: the diffuse term gets the rest
    real dielectric_f90;
    vec3 scattering;      // color of the light between the facets
    real albedo;          // of D V with F = 1, towards v, and its mean
    real albedo_mean;
    vec3 sheen;
    real sheen_alpha;
    real sheen_albedo;    // of sheen_brdf, towards v
    vec3 coat_n;
    real coat_alpha;
    real coat_reflectance;  // 0..1, towards v
    vec3 through;           // 0..1: of the light from behind, towards v
    vec3 around_diffuse;    // reflectance of even light from the environment, times occlusion, layer by layer: for the environment
    vec3 around_specular;   // about the mirror direction of base.n, as wide as `roughness`
    vec3 around_sheen;      // wide
    real around_coat;       // about the mirror direction of coat_n
    real roughness;         // of around_specular, alpha = roughness^2; coat_alpha is that of around_coat
    real table_roughness;   // at which the tables of the lobe's albedos are read
};

// What a material has; the same for all lanes.
struct MaterialTraits {
    int ward_form;        // RL_WARD_1992, RL_WARD_DUER, RL_WARD_BOUNDED
    int is_anisotropic;   // pbr: the tangents are used
    int has_scattering;
    int has_sheen;
    int has_coat;
    int has_two_normals;  // bumps act on one of the terms alone: diffuse_n is not base.n
    int has_transmission;
    int has_iridescence;
};

// Albedos towards the light, of tables: of D V with F = 1, and of sheen_brdf.
struct LightAlbedo {
    real lobe;
    real sheen;
};

// Albedos towards v: of D V with F = 1, its part by Schlick's weight, and of D V with the coat's alpha.
struct ViewAlbedo {
    real lobe;
    real grazing;
    real coat;
};
