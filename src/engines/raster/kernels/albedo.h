// SPDX-License-Identifier: Apache-2.0
// Reads the tables of directional albedos (lighting/albedo_tables.h), bilinearly. Per instruction set.
#pragma once
#include "engines/raster/kernels/light_kernel.h"

namespace rakelight::raster::RL_ISA {

/// Four neighbors of a table and the shares of the later ones.
struct TablePlace {
    integer first;
    real right, down;
};

/// @param x, y  0..1 across all columns and rows
inline TablePlace table_place(real x, real y, int32_t rows) {
    constexpr int32_t columns = lighting::albedo_columns;
    const real column = clamp(x, real(0.0f), real(1.0f)) * real(float(columns - 1));
    const real row = clamp(y, real(0.0f), real(1.0f)) * real(float(rows - 1));
    const integer c = min(to_int(column), integer(columns - 2)), r = min(to_int(row), integer(rows - 2));
    return {r * integer(columns) + c, column - to_real(c), row - to_real(r)};
}

inline real look_up_table(const float* table, const TablePlace& p) {
    constexpr int32_t columns = lighting::albedo_columns;
    const real upper = mix(gather(table, p.first), gather(table + 1, p.first), p.right);
    const real lower = mix(gather(table + columns, p.first), gather(table + columns + 1, p.first), p.right);
    return mix(upper, lower, p.down);
}

/// Of the GGX lobe with F = 1. roughness: alpha = roughness^2.
inline real lobe_albedo(const lighting::AlbedoTables& t, real n_dot_v, real roughness) {
    const real one(1.0f), alpha = max(roughness * roughness, real(1e-3f));
    const real width = alpha / (clamp(n_dot_v, real(0.0f), one) + alpha);
    const TablePlace place = table_place(safe_sqrt((one - width) * (one + alpha)), roughness, lighting::albedo_rows);
    return one - width * width * look_up_table(t.lobe_loss, place);
}

/// Where Schlick's weight has its share.
inline TablePlace grazing_place(real n_dot_v, real roughness) {
    return table_place(safe_sqrt(n_dot_v), roughness, lighting::albedo_rows);
}

/// A lobe of unequal alphas sends out as much as one of equal alphas whose slopes have the same mean square, seen where
/// its masking (Heitz 2014, eq. 86) is the same. Against quadrature 0.008 off on average, 0.041 at most (roughness 0.1
/// to 0.9, anisotropy 0.2 to 1, 0 to 85 degrees).
inline real equal_roughness(real alpha_x, real alpha_y) {
    return sqrt(sqrt(real(0.5f) * (alpha_x * alpha_x + alpha_y * alpha_y)));
}

/// Cosine of the direction there, from those to the normal and to the lobe's axes.
inline real equal_cosine(real n, real t, real b, real alpha_x, real alpha_y) {
    const real along_t = alpha_x * t, along_b = alpha_y * b;
    const real across = (along_t * along_t + along_b * along_b) * real(2.0f);
    const real squares = alpha_x * alpha_x + alpha_y * alpha_y;
    return n * sqrt(squares / max(n * n * squares + across, real(1e-30f)));
}

/// E_mean.
inline real lobe_mean(const lighting::AlbedoTables& t, real roughness) {
    const real alpha = max(roughness * roughness, real(1e-3f));
    const real row = clamp(roughness, real(0.0f), real(1.0f)) * real(float(lighting::albedo_rows - 1));
    const integer r = min(to_int(row), integer(lighting::albedo_rows - 2));
    return real(1.0f) - alpha * alpha * mix(gather(t.loss, r), gather(t.loss + 1, r), row - to_real(r));
}

/// @param alpha  of the sheen
inline real sheen_albedo(const lighting::AlbedoTables& t, real n_dot_v, real alpha) {
    const real c = clamp(n_dot_v, real(0.0f), real(1.0f));
    return look_up_table(t.sheen, table_place(sqrt(c), sqrt(alpha), lighting::sheen_rows));
}

}  // namespace rakelight::raster::RL_ISA
