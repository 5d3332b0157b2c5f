// SPDX-License-Identifier: Apache-2.0
// The tables of directional albedos between their columns and rows, as the engine reads them; in double.
#pragma once
#include <algorithm>
#include <cmath>

#include "lighting/albedo_tables.h"

namespace rakelight::lighting_test {

inline double from_table(const float* table, double place, double roughness) {
    const double x = std::sqrt(place) * (lighting::albedo_columns - 1);
    const double y = roughness * (lighting::albedo_rows - 1);
    const int c = std::min(int(x), lighting::albedo_columns - 2), r = std::min(int(y), lighting::albedo_rows - 2);
    const auto at = [&](int row, int column) { return double(table[row * lighting::albedo_columns + column]); };
    const double p = x - c, q = y - r;
    return (at(r, c) * (1 - p) + at(r, c + 1) * p) * (1 - q) + (at(r + 1, c) * (1 - p) + at(r + 1, c + 1) * p) * q;
}

inline double lobe_from_table(double n_dot_l, double roughness) {
    const double alpha = std::max(roughness * roughness, 1e-3), width = alpha / (n_dot_l + alpha);
    return 1 - width * width * from_table(lighting::albedo_tables().lobe_loss, (1 - width) * (1 + alpha), roughness);
}

inline double loss_from_table(double roughness) {
    const double y = roughness * (lighting::albedo_rows - 1);
    const int r = std::min(int(y), lighting::albedo_rows - 2);
    const float* const loss = lighting::albedo_tables().loss;
    return std::pow(roughness, 4) * (double(loss[r]) * (1 - (y - r)) + double(loss[r + 1]) * (y - r));
}

}  // namespace rakelight::lighting_test
