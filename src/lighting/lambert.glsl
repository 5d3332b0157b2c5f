// SPDX-License-Identifier: Apache-2.0
// Source: Lambert 1760, "Photometria": radiance of a diffuse surface does not depend on the direction it is seen from.
// Directions in all files here: unit, pointing away from the surface (n normal, l to the light, v to the viewer).
#define RL_INVERSE_PI 0.318309886f

// [1/sr] per unit of albedo. Times irradiance and n.l it gives radiance.
RL_FN real lambert_brdf() { return RL_INVERSE_PI; }

// The cosine of the sum over lights: max(0, n.l); 0 below the horizon and for NaN.
RL_FN real lambert_cosine(real n_dot_l) { return max(n_dot_l, 0.0f); }
