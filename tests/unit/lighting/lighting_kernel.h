// SPDX-License-Identifier: Apache-2.0
// What one flavour of the test kernel offers. `count` is a multiple of 16.
#pragma once
#include <stdint.h>

#include "lighting/light_parameters.h"
#include "relief_fields.h"

namespace rakelight::lighting_test {

/// Structure of arrays: n, l, v, ka, kd, ks, p (three floats each), then e, s, t.
struct Inputs {
    const float* column[24];
    int count;
};

struct Operation {
    const char* name;
    int width;  ///< 1 or 3 columns
    void (*run)(const Inputs& in, float* const* out);
    const char* text;  ///< the expression, which is GLSL, too
    float absolute;    ///< by how much a GPU may be off
    float (*relative)(float e);
};

struct Choice {
    int model, form, horizon, whole_exponent = 0;
};

/// Of surface_terms(): model RL_OREN_NAYAR, RL_WARD or RL_PBR, and what the material has.
struct MaterialChoice {
    int model, ward_form = 2, is_anisotropic = 0, has_scattering = 0, has_sheen = 0, has_coat = 0;
};

/// A surface that paths meet, normalized form; the same for all items. Metals: kd 0, ks the base color.
struct PathSurface {
    const char* name = "";
    int model = 0, ward_form = 2, is_anisotropic = 0, has_scattering = 0, has_sheen = 0, has_coat = 0,
        has_two_normals = 0;
    float kd[3] = {0, 0, 0}, ks[3] = {0, 0, 0};  ///< ks: f0 of pbr, rho_s of Ward
    float exponent = 1;
    int whole_exponent = 0;
    float alpha_x = 1, alpha_y = 1, sigma = 0;
    float dielectric_f0 = 0.04f, f90 = 1;
    float sheen[3] = {0, 0, 0}, sheen_alpha = 1, coat = 0, coat_alpha = 1;
};

struct Kernel {
    int lanes;
    const Operation* operations;
    int operation_count;
    /// light_terms at n, v with ka, kd, ks, e: ambient, diffuse, specular in out[0..8]. With a light: sampled at p;
    /// without: one from direction l with all colors 1.
    void (*terms)(const Inputs& in, const lighting::LightParameters* light, Choice choice, float* const* out);
    /// surface_terms at n, v with k_a = ka, k_d = kd, k_s or f0 = ks, sigma or alpha_x = e, alpha_y = t, tangent p; the
    /// other numbers from ka and ks. All light's colors are 1: ambient, diffuse, specular in out[0..8].
    void (*material)(const Inputs& in, MaterialChoice choice, float* const* out);
    /// add_light over all lights, from 0: out[0..2].
    void (*sum)(const Inputs& in, const lighting::LightParameters* lights, int light_count, Choice choice,
                float* const* out);
    /// A ray at p.x, p.y towards v into a relief of one width, and from where it is met towards l: the place u, v, its
    /// height, and 1 where it is lit, in out[0..3].
    void (*relief)(const Inputs& in, ReliefCase relief, float* const* out);
    /// The surface with normals n, ka (diffuse), kd (coat) and tangent p, seen from v. Of the direction that sample_surface()
    /// makes of e, (s, t) modulo 1: out[0..2] itself, [3] surface_pdf, [4..6] reflected_share; of l: [7] and [8..10]; lobe_shares in
    /// [11..15].
    void (*paths)(const Inputs& in, const PathSurface& surface, float* const* out);
};

namespace scalar {
extern const Kernel kernel;
}
namespace sse2 {
extern const Kernel kernel;
}
namespace avx2 {
extern const Kernel kernel;
}
namespace avx512 {
extern const Kernel kernel;
}

}  // namespace rakelight::lighting_test
