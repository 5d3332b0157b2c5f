// SPDX-License-Identifier: Apache-2.0
// Reads the tables of directional albedos (albedo_tables.h), bilinearly: sample_albedo() of the includer's Maps.
// albedo_tables.glsl is its GLSL brother. Per instruction set.
#pragma once
#include "lighting/albedo_tables.h"
#include "lighting/lighting.h"

namespace rakelight::lighting::RL_ISA {

/// Two neighbors of a row, mixed.
inline real mixed_neighbors(const float* table, integer first, real right) {
    integer a, b;
    gather_pairs(reinterpret_cast<const uint32_t*>(table), first, a, b);
    return mix(real_from_bits(a), real_from_bits(b), right);
}

/// Four neighbors of a table. @param x, y  0..1 across all columns and rows
inline real table_value(const float* table, real x, real y, int32_t rows) {
    const real column = clamp(x, real(0.0f), real(1.0f)) * real(float(albedo_columns - 1));
    const real row = clamp(y, real(0.0f), real(1.0f)) * real(float(rows - 1));
    const integer c = min(to_int(column), integer(albedo_columns - 2)), r = min(to_int(row), integer(rows - 2));
    const integer first = r * integer(albedo_columns) + c;
    const real right = column - to_real(c), down = row - to_real(r);
    return mix(mixed_neighbors(table, first, right), mixed_neighbors(table + albedo_columns, first, right), down);
}

/// Of a table of one row.
inline real row_value(const float* table, real x, int32_t columns) {
    const real column = clamp(x, real(0.0f), real(1.0f)) * real(float(columns - 1));
    const integer c = min(to_int(column), integer(columns - 2));
    return mixed_neighbors(table, c, column - to_real(c));
}

/// @param table  RL_ALBEDO_...
inline real read_albedo(const AlbedoTables& t, int table, real x, real y) {
    if (table == RL_ALBEDO_MEAN_LOSS) return row_value(t.loss, x, albedo_rows);
    if (table == RL_ALBEDO_SHEEN) return table_value(t.sheen, x, y, sheen_rows);
    return table_value(table == RL_ALBEDO_GRAZING ? t.grazing : t.lobe_loss, x, y, albedo_rows);
}

}  // namespace rakelight::lighting::RL_ISA
