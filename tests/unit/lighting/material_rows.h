// SPDX-License-Identifier: Apache-2.0
// The value table of the models of materials (material_values.py), and what each of their BRDFs is held to.
#pragma once
#include <gtest/gtest.h>

#include "unit/lighting/furnace.h"

namespace rakelight::lighting_test {

struct MaterialRow {
    float l[3], v[3], ax, ay, sigma, oren_nayar, ward_1992, ward_duer, ward_bounded, ggx, ggx_anisotropic, sheen;
};

inline const std::vector<MaterialRow>& material_rows() {
    static const std::vector<MaterialRow> all = {
#define RL_MATERIAL(lx, ly, lz, vx, vy, vz, ...) MaterialRow{{lx, ly, lz}, {vx, vy, vz}, __VA_ARGS__},
#include "unit/lighting/material_values.inc"
#undef RL_MATERIAL
    };
    return all;
}

inline Item item_of(const MaterialRow& row) {
    Item item;
    item.l = {row.l[0], row.l[1], row.l[2]}, item.v = {row.v[0], row.v[1], row.v[2]};
    item.p = {1, 0, 0};
    item.ka = {row.ax, row.ay, 0};
    item.s = row.sigma, item.e = row.ax, item.t = row.ay;
    return item;
}

inline Items items_of_material_rows() {
    Items items;
    for (const MaterialRow& row : material_rows()) items.push(item_of(row));
    return items;
}

inline void expect_values_of_the_table(const char* operation, float MaterialRow::*expected) {
    ASSERT_GE(material_rows().size(), 100u);
    Items items = items_of_material_rows();
    const Results r = run(scalar::kernel, operation, items);
    for (std::size_t i = 0; i < material_rows().size(); ++i) {
        // directions are rounded to float; narrow lobes are steep there
        const double value = double(material_rows()[i].*expected);
        EXPECT_NEAR(r[0][i], value, 2e-6 + 6e-5 * value) << operation << " row " << i;
    }
}

inline void expect_reciprocal(const char* operation) {
    Items there = items_of_material_rows(), back;
    for (const MaterialRow& row : material_rows()) {
        Item item = item_of(row);
        std::swap(item.l, item.v);
        back.push(item);
    }
    const Results a = run(scalar::kernel, operation, there), b = run(scalar::kernel, operation, back);
    for (std::size_t i = 0; i < there.size(); ++i)
        EXPECT_NEAR(a[0][i], b[0][i], 1e-6 + 2e-5 * double(a[0][i])) << operation << " " << i;
}

/// A turn about the normal of both directions, and so of what is anisotropic.
inline vec3 turned(vec3 d, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {float(c * double(d.x) - s * double(d.y)), float(s * double(d.x) + c * double(d.y)), d.z};
}

/// With equal widths it does not matter how the tangent lies.
inline void expect_equal_widths_to_be_isotropic(const char* operation) {
    Random random;
    Items straight, oblique;
    for (const MaterialRow& row : material_rows()) {
        Item item = item_of(row);
        item.ka.y = item.ka.x;
        straight.push(item);
        const double angle = double(random.within(-3, 3));
        item.l = turned(item.l, angle), item.v = turned(item.v, angle);
        oblique.push(item);
    }
    const Results a = run(scalar::kernel, operation, straight), b = run(scalar::kernel, operation, oblique);
    for (std::size_t i = 0; i < straight.size(); ++i)
        EXPECT_NEAR(a[0][i], b[0][i], 2e-6 + 1e-4 * double(a[0][i])) << operation << " " << i;
}

/// Greater off the mirror along a wide tangent than across it.
inline void expect_a_wide_tangent_to_stretch(const char* operation) {
    Items items;
    for (const vec3 v : {vec3{0.3f, 0, 0.953939f}, vec3{0, 0.3f, 0.953939f}}) {
        Item item;
        item.v = v, item.p = {1, 0, 0}, item.ka = {0.4f, 0.1f, 0};
        items.push(item);
    }
    const Results r = run(scalar::kernel, operation, items);
    EXPECT_GT(r[0][0], 3 * r[0][1]) << operation;
}

}  // namespace rakelight::lighting_test
