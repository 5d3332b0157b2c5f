// SPDX-License-Identifier: Apache-2.0
// Conversions between the two parameter sets of a material, and what a material asks for.
#pragma once
#include <rakelight/scene/scene.h>

namespace rakelight {

/// Conversions between the two parameter sets of a material. Losses: see material_conversion.cpp.
Material classical_from_metallic_roughness(const Material& m);
Material metallic_roughness_from_classical(const Material& m);

/// Roughness of the GGX, Beckmann or Ward lobe that matches a Blinn-Phong exponent >= 0: alpha^2 = 2 / (n + 2) (Karis
/// 2013, "Specular BRDF Reference").
double roughness_of_exponent(double exponent);

/// Reflectance at normal incidence from the index of refraction: ((ior - 1) / (ior + 1))^2 (KHR_materials_ior; 0 is its
/// case for specular-glossiness and gives 1).
float ior_f0(float ior);

/// The specular form of a material: its own, else the picture's. Never automatic: normalized for (converted)
/// metallic-roughness parameters, else textbook.
SpecularForm specular_form_of(const Material& m, SpecularForm wanted);

/// Whether a material needs tangents: bump or normal map, or anisotropy.
bool needs_tangents(const Material& material);

/// The bump technique of a material: its own, else the picture's, else by its maps. Never automatic.
Bump bump_of(const Material& material, Bump wanted);
/// Whether a technique (not automatic) reads height maps.
bool reads_heights(Bump bump);

}  // namespace rakelight
