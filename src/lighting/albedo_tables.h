// SPDX-License-Identifier: Apache-2.0
// Directional albedos of the lobes of ggx.glsl and sheen.glsl: the share of a beam from one direction that leaves in
// all. Numbers of tools/make/make_albedo_tables.py; read by kernels of every instruction set. Source: Kulla & Conty 2017,
// "Revisiting Physically Based Shading at Imageworks"; Karis 2013, "Real Shading in Unreal Engine 4" (the split by
// Schlick's weight).
#pragma once

namespace rakelight::lighting {

inline constexpr int albedo_columns = 32;  ///< lobe: n.v (1 + alpha) / (n.v + alpha) = (column / 31)^2; others: n.v is
inline constexpr int albedo_rows = 32;     ///< row r: roughness r / 31, alpha = max(roughness^2, 1e-3)
inline constexpr int sheen_rows = 16;      ///< row r: sheen roughness r / 15, alpha = max(roughness^2, 5e-3)

/// Row after row. GGX with Schlick's Fresnel reflects lobe (f0 (1 - grazing) + f90 grazing) of light from the environment.
struct AlbedoTables {
    /// [albedo_rows][albedo_columns] (1 - lobe) / w^2, w = alpha / (n.v + alpha), lobe the albedo of D V with F = 1
    const float* lobe_loss;
    const float* grazing;  ///< likewise the share that D V (1 - v.h)^5 has of it
    const float* loss;   ///< [albedo_rows] (1 - E_mean) / alpha^2, E_mean twice the integral of lobe(c) c over c = 0..1
    const float* sheen;  ///< [sheen_rows][albedo_columns] of sheen_brdf
};

AlbedoTables albedo_tables();

}  // namespace rakelight::lighting
