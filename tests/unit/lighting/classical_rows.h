// SPDX-License-Identifier: Apache-2.0
// The value table of Lambert, Phong and Blinn-Phong (lighting_values.py), and what both lobes are held to.
#pragma once
#include <gtest/gtest.h>

#include "unit/lighting/furnace.h"

namespace rakelight::lighting_test {

struct ClassicalRow {
    float n[3], l[3], v[3], e, diffuse, specular[2][3];  ///< [Phong, Blinn-Phong][textbook, no horizon, normalized]
};

inline const std::vector<ClassicalRow>& classical_rows() {
    static const std::vector<ClassicalRow> all = {
#define RL_TERMS(nx, ny, nz, lx, ly, lz, vx, vy, vz, e, diffuse, p0, p1, p2, b0, b1, b2) \
    ClassicalRow{{nx, ny, nz}, {lx, ly, lz}, {vx, vy, vz}, e, diffuse, {{p0, p1, p2}, {b0, b1, b2}}},
#define RL_ATTENUATION(c, l, q, d, expected)
#define RL_RANGE(d, r, expected)
#define RL_CONE(angle, inner, outer, expected)
#include "unit/lighting/lighting_values.inc"
#undef RL_TERMS
#undef RL_ATTENUATION
#undef RL_RANGE
#undef RL_CONE
    };
    return all;
}

inline vec3 vector(const float (&a)[3]) { return {a[0], a[1], a[2]}; }

/// @param exponent  of all items, or 0: the rows' own
inline Items items_of_classical_rows(float exponent = 0) {
    Items items;
    for (const ClassicalRow& row : classical_rows()) {
        Item item;
        item.n = vector(row.n), item.l = vector(row.l), item.v = vector(row.v);
        item.e = exponent > 0 ? exponent : row.e;
        items.push(item);
    }
    return items;
}

/// @param model  phong or blinn_phong
inline void expect_values_of_the_table(int model) {
    ASSERT_GE(classical_rows().size(), 100u);
    Items items = items_of_classical_rows();
    const Choice columns[] = {{model, textbook, 1}, {model, textbook, 0}, {model, normalized, 1}};
    for (std::size_t c = 0; c < 3; ++c) {
        const Results results = terms(scalar::kernel, items, columns[c]);
        for (std::size_t i = 0; i < classical_rows().size(); ++i) {
            const ClassicalRow& row = classical_rows()[i];
            const float expected = row.specular[model - 1][c];
            // directions are rounded to float: with exponent e the lobe moves by about e 2^-24 of itself
            EXPECT_NEAR(results[6][i], expected, 1e-6 + expected * (1e-6 + double(row.e) * 3e-7))
                << "column " << c << " row " << i;
        }
    }
}

inline void expect_whole_exponents_to_agree(int model) {
    Items items = items_of_classical_rows(48);
    for (int form : {textbook, normalized}) {
        const Results any = terms(scalar::kernel, items, {model, form, 1}),
                      whole = terms(scalar::kernel, items, {model, form, 1, 48});
        for (std::size_t i = 0; i < items.size(); ++i)
            EXPECT_NEAR(whole[6][i], any[6][i], 1e-30 + 9e-6 * double(any[6][i])) << "item " << i;
    }
}

/// All at normal incidence and never more than all.
inline void expect_energy_of_the_normalized_form(int model) {
    const Outgoing out = whole_hemisphere(), even = even_hemisphere();
    for (const float e : {1.0f, 4.0f, 20.0f, 100.0f}) {
        Item like;
        like.e = e;
        EXPECT_NEAR(albedo({model, normalized, 1}, beam(0), even, like), 1, 3e-3) << "exponent " << e;
        for (const double angle : furnace_degrees)
            EXPECT_LE(albedo({model, normalized, 1}, beam(angle), out, like), 1.003)
                << "exponent " << e << " at " << angle;
    }
}

inline void expect_normalized_form_is_reciprocal(int model) {
    Random random;
    Items there, back;
    std::vector<float> n_dot_l, n_dot_v;
    for (int i = 0; i < 5000; ++i) {
        Item item;
        item.l = random.direction(), item.v = random.direction(), item.e = random.within(1, 60);
        if (item.l.z < 0.02f || item.v.z < 0.02f) continue;
        there.push(item);
        n_dot_l.push_back(item.l.z), n_dot_v.push_back(item.v.z);
        std::swap(item.l, item.v);
        back.push(item);
    }
    ASSERT_GT(n_dot_l.size(), 1000u);
    const Results a = terms(scalar::kernel, there, {model, normalized, 1}),
                  b = terms(scalar::kernel, back, {model, normalized, 1});
    for (std::size_t i = 0; i < n_dot_l.size(); ++i) {
        const double f_there = double(a[6][i]) / double(n_dot_l[i]), f_back = double(b[6][i]) / double(n_dot_v[i]);
        ASSERT_NEAR(f_there, f_back, 1e-6 + 2e-5 * f_there) << i;
    }
}

}  // namespace rakelight::lighting_test
