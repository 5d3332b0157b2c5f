// SPDX-License-Identifier: Apache-2.0
// Films over surfaces against Belcour & Barla 2017 as KHR_materials_iridescence approximates it: a value table, limits, energy.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "unit/lighting/material_rows.h"

namespace rakelight::lighting_test {
namespace {

struct FilmRow {
    float f0[3], index, thickness, cosine, reflectance[3];
};
const FilmRow film_rows[] = {
#define RL_FILM(fr, fg, fb, index, thickness, cosine, r, g, b) \
    {{float(fr), float(fg), float(fb)}, float(index), float(thickness), float(cosine), {float(r), float(g), float(b)}},
#include "unit/lighting/models/iridescence_values.inc"
#undef RL_FILM
};

Item item_of(const FilmRow& row) {
    Item item;
    item.kd = {row.f0[0], row.f0[1], row.f0[2]};
    item.ka = {row.index - 1, row.thickness, 0};
    item.s = row.cosine;
    return item;
}

TEST(Iridescence, GivesTheValuesOfTheTable) {
    Items items;
    for (const FilmRow& row : film_rows) items.push(item_of(row));
    ASSERT_GE(items.size(), 100u);
    const Results r = run(scalar::kernel, "film_reflectance", items);
    for (std::size_t i = 0; i < std::size(film_rows); ++i)
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(r[c][i], film_rows[i].reflectance[c], 5e-5) << i << ' ' << c;
}

TEST(Iridescence, ItsColorChangesWithTheAngleAndTheThickness) {
    Items items;
    for (const float thickness : {0.3f, 0.4f})
        for (const float cosine : {1.0f, 0.6f})
            items.push(item_of({{0.04f, 0.04f, 0.04f}, 1.4f, thickness, cosine, {}}));
    const Results r = run(scalar::kernel, "film_reflectance", items);
    const auto red_over_blue = [&r](std::size_t i) { return double(r[0][i]) / std::max(double(r[2][i]), 1e-6); };
    EXPECT_GT(std::abs(std::log(red_over_blue(0) / red_over_blue(1))), 0.3);
    EXPECT_GT(std::abs(std::log(red_over_blue(0) / red_over_blue(2))), 0.3);
}

/// The f0 whose Schlick term is the film's reflectance towards the viewer, where there is one in 0..1.
TEST(Iridescence, TheTermTowardsTheViewerIsTheFilms) {
    Items items, films;
    for (const double angle : {0.0, 20.0, 40.0, 60.0}) {
        Item item;
        item.v = to_float(beam(angle));
        item.kd = {0.5f, 0.3f, 0.2f};
        item.ka = {1, 0.5f, 0.33f};  // all of a film of 450 nm
        items.push(item);
        Item film = item_of({{0.5f, 0.3f, 0.2f}, 1.33f, 0.45f, float(std::cos(radians(angle))), {}});
        films.push(film);
    }
    const Results f0 = run(scalar::kernel, "film_f0", items), seen = run(scalar::kernel, "film_reflectance", films);
    int exact = 0;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const double weight = std::pow(1 - std::cos(radians(20.0 * double(i))), 5), f = double(f0[c][i]);
            if (f <= 0 || f >= 1) continue;
            EXPECT_NEAR(f + (1 - f) * weight, double(seen[c][i]), 1e-4) << i << ' ' << c;
            ++exact;
        }
    EXPECT_GE(exact, 8);
}

TEST(Iridescence, NoFilmIsWhereItsStrengthOrThicknessIsZero) {
    Items items;
    for (const vec3 ka : {vec3{0, 0.5f, 0.3f}, vec3{1, 0, 0.3f}}) {
        Item item;
        item.kd = {0.5f, 0.3f, 0.2f}, item.ka = ka;
        items.push(item);
    }
    const Results r = run(scalar::kernel, "film_f0", items);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_FLOAT_EQ(r[0][i], 0.5f);
        EXPECT_FLOAT_EQ(r[2][i], 0.2f);
    }
}

/// The diffuse term gets what the greatest component leaves; so base and film send out no more than comes, whatever the film.
TEST(Iridescence, WhatItReflectsAndLeavesIsNeverMoreThanComes) {
    Items items;
    for (const double angle : furnace_degrees)
        for (int k = 0; k < 24; ++k) {
            Item item;
            item.v = to_float(beam(angle)), item.kd = {0.04f, 0.04f, 0.04f};
            item.ka = {1, float(k) / 23, float(k % 5) * 0.25f};
            items.push(item);
        }
    const Results f0 = run(scalar::kernel, "film_f0", items), rest = run(scalar::kernel, "film_of_dielectrics", items);
    bool is_colored = false;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const float greatest = std::max({f0[0][i], f0[1][i], f0[2][i]}),
                    least = std::min({f0[0][i], f0[1][i], f0[2][i]});
        EXPECT_EQ(rest[0][i], greatest) << i;
        EXPECT_LE(greatest, 1) << i;
        EXPECT_GE(least, 0) << i;
        is_colored = is_colored || greatest > 2 * least;
    }
    EXPECT_TRUE(is_colored);
}

}  // namespace
}  // namespace rakelight::lighting_test
