// SPDX-License-Identifier: Apache-2.0
// Samplers against their densities (chi-square over the sphere), densities against 1, weights against the BRDF: the mean is the
// albedo by quadrature, and what is said to be bounded is.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "unit/lighting/sphere_bins.h"

namespace rakelight::lighting_test {
namespace {

constexpr int draws = 100000;
constexpr double views[] = {0, 30, 60, 80, 88, 96};  // the last: behind the bumped normal

std::string described(const PathCase& c, double degrees_off) {
    return std::string(c.surface.name) + " seen at " + std::to_string(degrees_off) + " degrees";
}

/// Sum of the lobes' probabilities.
double drawn_share(const Results& r) {
    double sum = 0;
    for (std::size_t c = lobe_share; c < lobe_share + 5; ++c) sum += double(r[c][0]);
    return sum;
}

/// body(path case, what is seen, `draws` items that see it).
template <class Body>
void for_all_views(Body body) {
    for (const double degrees_off : views) {
        const Item seen = seen_at(degrees_off);
        Items items = random_draws(seen, draws);
        for (const PathCase& c : path_cases()) {
            SCOPED_TRACE(described(c, degrees_off));
            body(c, seen, items);
        }
    }
}

TEST(Samplers, CosAndSineOfTurnsAreExactToFloat) {
    Items items;
    for (int i = 0; i < 40000; ++i) {
        Item item;
        item.s = float(i) / 40000;
        items.push(item);
    }
    const Results r = run(scalar::kernel, "cos_sin_of_turns", items);
    for (std::size_t i = 0; i < items.size(); ++i) {
        const double angle = 2 * pi_d * double(float(i) / 40000);
        ASSERT_NEAR(r[0][i], std::cos(angle), 1e-7) << i;
        ASSERT_NEAR(r[1][i], std::sin(angle), 1e-7) << i;
    }
}

TEST(Samplers, OneMinusExpDoesNotCancel) {
    Items items;
    for (int i = 0; i < 20000; ++i) {
        Item item;
        item.s = 1, item.t = 1, item.e = float(std::exp(-16 + i * 1e-3));
        items.push(item);
    }
    const Inputs in = items.inputs();
    const Results r = run(scalar::kernel, "one_minus_exp", items);
    for (std::size_t i = 0; i < items.size(); ++i)
        ASSERT_NEAR(r[0][i] / -std::expm1(-double(in.column[21][i])), 1, 2e-6) << in.column[21][i];
}

TEST(Samplers, NarrowLobesOfPowersKeepTheirShape) {
    Random random;
    Items items;
    for (int i = 0; i < 10000; ++i) {
        Item item;
        item.e = 1e6f, item.s = random.unit(), item.t = random.unit();
        items.push(item);
    }
    const Inputs in = items.inputs();
    const Results r = run(scalar::kernel, "sample_phong", items);  // n = v = +z
    for (std::size_t i = 0; i < items.size(); ++i) {
        const double u = double(in.column[22][i]);
        if (u < 1e-3) continue;  // 1 - u has few bits of it
        const double x = double(r[0][i]), y = double(r[1][i]), expected = -std::expm1(2 * std::log1p(-u) / (1e6 + 1));
        ASSERT_NEAR((x * x + y * y) / expected, 1, 1e-4) << u;
    }
}

TEST(Samplers, HistogramsAreThoseOfTheDensities) {
    const double chance = 1e-3 / double(path_cases().size() * std::size(views));
    for_all_views([chance](const PathCase& c, const Item& seen, Items& items) {
        const Results drawn = paths(fastest_kernel(), items, c.surface);
        if (drawn_share(drawn) == 0) return;
        const SphereBins bins(seen, c.division, c.width);
        std::vector<int> counts(bins.count());
        for (std::size_t i = 0; i < items.size(); ++i) ++counts[bins.bin_of(drawn.vector(sampled_l, i))];
        constexpr int finer = 12;
        const Outgoing points = bins.points(finer);
        Items from = items_from(seen, points);
        const Results there = paths(fastest_kernel(), from, c.surface);
        std::vector<double> probabilities(bins.count());
        double whole = 0;
        for (std::size_t i = 0; i < points.v.size(); ++i) {
            const double probability = double(there[pdf_of_l][i]) * points.solid_angle[i];
            probabilities[i / (finer * finer)] += probability;
            whole += probability;
        }
        EXPECT_NEAR(whole, 1, 3e-3);
        EXPECT_GT(chance_of_counts(probabilities, counts, draws), chance);
    });
}

TEST(Samplers, MeanWeightIsTheAlbedo) {
    for_all_views([](const PathCase& c, const Item& seen, Items& items) {
        const Outgoing points = SphereBins(seen, c.division, c.width).points(12);
        Items from = items_from(seen, points);
        const Results there = paths(fastest_kernel(), from, c.surface);
        const Results drawn = paths(fastest_kernel(), items, c.surface);
        for (std::size_t channel = 0; channel < 3; ++channel) {
            double albedo = 0;
            for (std::size_t i = 0; i < points.v.size(); ++i)
                albedo += double(there[share_of_l + channel][i]) * points.solid_angle[i];
            double sum = 0, squares = 0;
            for (std::size_t i = 0; i < items.size(); ++i) {
                const double pdf = double(drawn[sampled_pdf][i]), share = double(drawn[sampled_share + channel][i]);
                const double weight = share > 0 ? share / pdf : 0;
                ASSERT_TRUE(std::isfinite(weight)) << share << " over " << pdf;
                sum += weight, squares += weight * weight;
            }
            const double mean = sum / draws, error = std::sqrt(std::max(squares / draws - mean * mean, 0.0) / draws);
            EXPECT_NEAR(mean, albedo, 4 * error + 1e-3 * albedo + 1e-8) << "channel " << channel;
        }
    });
}

TEST(Samplers, DirectionsAreUnit) {
    for_all_views([](const PathCase& c, const Item&, Items& items) {
        const Results drawn = paths(fastest_kernel(), items, c.surface);
        for (std::size_t i = 0; i < items.size(); ++i) {
            const Vector l = to_double(drawn.vector(sampled_l, i));
            ASSERT_NEAR(dot_of(l, l), 1, 2e-6) << i;
        }
    });
}

/// Greatest weight of a surface that shows nothing but one lobe of reflectance 1.
double greatest_weight(PathSurface s, double degrees_off) {
    s.kd[0] = s.kd[1] = s.kd[2] = 0;
    s.ks[0] = s.ks[1] = s.ks[2] = 1;
    s.dielectric_f0 = 1;
    Items items = random_draws(seen_at(degrees_off), draws);
    const Results drawn = paths(fastest_kernel(), items, s);
    double greatest = 0;
    for (std::size_t i = 0; i < items.size(); ++i)
        if (drawn[sampled_share][i] > 0)
            greatest = std::max(greatest, double(drawn[sampled_share][i]) / double(drawn[sampled_pdf][i]));
    return greatest;
}

TEST(Samplers, WeightsOfGgxStayWithinOneDownToTheNarrowestLobes) {
    constexpr std::array<std::pair<float, float>, 9> widths = {{{0.001f, 0.001f},
                                                                {0.003f, 0.003f},
                                                                {0.01f, 0.01f},
                                                                {0.1f, 0.1f},
                                                                {0.5f, 0.5f},
                                                                {1.0f, 1.0f},
                                                                {0.5f, 0.001f},
                                                                {0.001f, 0.1f},
                                                                {1.0f, 0.3f}}};
    for (const auto& [alpha_x, alpha_y] : widths)
        for (const double degrees_off : {0.0, 45.0, 80.0, 89.0, 89.9}) {
            const double weight = greatest_weight(metal("", alpha_x, alpha_y), degrees_off);
            EXPECT_LE(weight, 1 + 1e-5) << alpha_x << " " << alpha_y << " at " << degrees_off;
            EXPECT_GE(weight, 0.5) << alpha_x << " " << alpha_y << " at " << degrees_off;
        }
}

TEST(Samplers, WeightsOfTheOthersStayWithinWhatTheirTextSays) {
    for (const double degrees_off : {0.0, 45.0, 80.0, 89.0}) {
        for (const float exponent : {1.0f, 5.0f, 200.0f}) {
            const PathSurface s = {.model = blinn_phong, .exponent = exponent};
            EXPECT_LE(greatest_weight(s, degrees_off), 4.4) << exponent << " at " << degrees_off;
        }
        for (const float alpha : {0.001f, 0.1f, 0.6f})
            EXPECT_LE(greatest_weight(ward_surface("", 2, alpha, 2 * alpha), degrees_off), 2 + 1e-4)
                << alpha << " at " << degrees_off;
    }
}

TEST(Samplers, LobeSharesSumToOneOrNothing) {
    PathSurface black = plastic("black", 0.5f);
    black.kd[0] = black.kd[1] = black.kd[2] = black.ks[0] = black.ks[1] = black.ks[2] = black.f90 = 0;
    Items items = random_draws(seen_at(30), 16);
    const Results none = paths(scalar::kernel, items, black);
    EXPECT_EQ(drawn_share(none), 0);
    EXPECT_EQ(none[sampled_pdf][0], 0);
    EXPECT_TRUE(std::isfinite(none[sampled_l][0]));
    for_all_views([](const PathCase& c, const Item& seen, Items& draw) {
        const double sum = drawn_share(paths(fastest_kernel(), draw, c.surface));
        // from behind facets show nothing
        const bool is_seen = c.surface.model < ward || c.surface.kd[0] > 0 || dot(seen.n, seen.v) > 0 ||
                             (c.surface.has_coat != 0 && dot(seen.kd, seen.v) > 0);
        EXPECT_NEAR(sum, is_seen ? 1 : 0, 1e-6);
    });
}

TEST(Samplers, LobesAreDrawnByWhatTheyReflect) {
    Items items = random_draws(seen_at(30), 16);
    const Results plain = paths(scalar::kernel, items, plastic("", 0.3f)),
                  coated = paths(scalar::kernel, items, with_coat(plastic("", 0.3f), "", 0.1f));
    EXPECT_GT(plain[lobe_share][0], 0.9f);
    EXPECT_GT(plain[lobe_share + 1][0], 0.03f);
    EXPECT_EQ(plain[lobe_share + 4][0], 0.0f);
    EXPECT_GT(coated[lobe_share + 4][0], 0.03f);
    EXPECT_LT(coated[lobe_share][0], plain[lobe_share][0]);
}

TEST(Samplers, WhereLightIsReflectedTheDensityIsNotZero) {
    Random random;
    Items items;
    for (int i = 0; i < 50000; ++i) {
        Item item = random_item(random);
        item.ka = random.direction(), item.kd = random.direction();
        if (i % 2 == 0) {  // so that narrow lobes are met
            const Vector h = sum_of(to_double(item.n), i % 4 == 0 ? 1e-3 : 0.1, to_double(item.ka));
            const Vector l = mirrored(unit_of(h), to_double(item.v));
            item.l = {float(l.x), float(l.y), float(l.z)};
        }
        items.push(item);
    }
    for (const PathCase& path : path_cases()) {
        const PathSurface& s = path.surface;
        const Results r = paths(fastest_kernel(), items, s);
        int lit = 0;
        for (std::size_t i = 0; i < items.size(); ++i)
            for (std::size_t c = share_of_l; c < share_of_l + 3; ++c) {
                const bool is_lit = r[c][i] > 1e-30f;
                lit += is_lit;
                ASSERT_TRUE(!is_lit || r[pdf_of_l][i] > 0) << s.name << " item " << i << ": " << r[c][i];
            }
        EXPECT_GT(lit, 100) << s.name;
    }
}

}  // namespace
}  // namespace rakelight::lighting_test
