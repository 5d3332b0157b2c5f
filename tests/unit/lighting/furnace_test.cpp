// SPDX-License-Identifier: Apache-2.0
// Energy: what a surface sends out of a beam from 0 to 89.9 degrees, by quadrature over the outgoing directions.
#include <gtest/gtest.h>

#include <cmath>

#include "lighting/albedo_tables.h"
#include "lighting_items.h"

namespace rakelight::lighting_test {
namespace {

constexpr double pi_d = 3.14159265358979323846;
constexpr double furnace_degrees[] = {0, 15, 30, 45, 60, 70, 80, 85, 88, 89, 89.5, 89.9};

struct Direction {
    double x, y, z;
};
vec3 to_float(Direction d) { return {float(d.x), float(d.y), float(d.z)}; }
Direction beam(double degrees_in) { return {std::sin(radians(degrees_in)), 0, std::cos(radians(degrees_in))}; }

/// Outgoing directions with the solid angle that each stands for.
struct Outgoing {
    std::vector<Direction> v;
    std::vector<double> solid_angle;
};

/// Rings that are denser at the horizon.
Outgoing whole_hemisphere() {
    Outgoing out;
    constexpr int rings = 192, sectors = 128;
    for (int i = 0; i < rings; ++i) {
        const double q = (i + 0.5) / rings, z = q * q, s = std::sqrt(1 - z * z);
        for (int k = 0; k < sectors; ++k) {
            const double phi = 2 * pi_d * (k + 0.5) / sectors;
            out.v.push_back({s * std::cos(phi), s * std::sin(phi), z});
            out.solid_angle.push_back(2 * q / rings * 2 * pi_d / sectors);
        }
    }
    return out;
}

/// Mirror directions of l on facets of slope tan theta = alpha q / (1 - q), q even in 0..1: dense where lobes as wide
/// as alpha are high, with room for their tails.
Outgoing about_the_mirror(Direction l, double alpha) {
    Outgoing out;
    constexpr int rings = 256, sectors = 192;
    for (int i = 0; i < rings; ++i) {
        const double q = (i + 0.5) / rings, tangent = alpha * q / (1 - q);
        const double z = 1 / std::sqrt(1 + tangent * tangent), s = tangent * z;
        const double step = alpha / ((1 - q) * (1 - q)) * z * z / rings;  // d theta
        for (int k = 0; k < sectors; ++k) {
            const double phi = 2 * pi_d * (k + 0.5) / sectors;
            const Direction h = {s * std::cos(phi), s * std::sin(phi), z};
            const double l_dot_h = l.x * h.x + l.y * h.y + l.z * h.z;
            const Direction v = {2 * l_dot_h * h.x - l.x, 2 * l_dot_h * h.y - l.y, 2 * l_dot_h * h.z - l.z};
            if (l_dot_h <= 0 || v.z <= 0) continue;
            out.v.push_back(v);
            out.solid_angle.push_back(4 * l_dot_h * s * step * 2 * pi_d / sectors);
        }
    }
    return out;
}

Items items_of(Direction l, const Outgoing& out, Item like) {
    Items items;
    like.l = to_float(l), like.p = {1, 0, 0};
    for (const Direction& v : out.v) {
        like.v = to_float(v);
        items.push(like);
    }
    return items;
}

/// Integral of the BRDF times the cosine.
double albedo(const char* operation, Direction l, const Outgoing& out, const Item& like) {
    Items items = items_of(l, out, like);
    const Results r = run(scalar::kernel, operation, items);
    double sum = 0;
    for (std::size_t i = 0; i < out.v.size(); ++i) sum += double(r[0][i]) * out.v[i].z * out.solid_angle[i];
    return sum;
}

Item widths(double ax, double ay) {
    Item item;
    item.ka = {float(ax), float(ay), 0};
    return item;
}

double ggx_albedo(double degrees_in, double alpha) {
    const Direction l = beam(degrees_in);
    return albedo("ggx_brdf", l, about_the_mirror(l, alpha), widths(alpha, alpha));
}

TEST(Furnace, ClassicalModelsStayWithinTheirReflectance) {
    const Outgoing out = whole_hemisphere();
    for (const double angle : furnace_degrees) {
        const Direction l = beam(angle);
        for (const int model : {lambert, phong, blinn_phong})
            for (const float e : {1.0f, 5.0f, 40.0f}) {
                Item like;
                like.e = e;
                Items items = items_of(l, out, like);
                const Results r = terms(scalar::kernel, items, {model, normalized, 1});
                const std::size_t column = model == lambert ? 3 : 6;
                double sum = 0;
                for (std::size_t i = 0; i < out.v.size(); ++i)
                    sum += double(r[column][i]) / (pi_d * l.z) * out.v[i].z * out.solid_angle[i];
                EXPECT_LE(sum, 1.002) << "model " << model << " exponent " << e << " at " << angle;
                if (model == lambert) {
                    EXPECT_NEAR(sum, 1, 2e-4) << angle;
                }
            }
    }
}

TEST(Furnace, OrenNayarReachesItsPublishedSurplusAndNoMore) {
    const Outgoing out = whole_hemisphere();
    double most = 0;
    for (const double angle : furnace_degrees)
        for (const float sigma : {0.0f, 0.1f, 0.2f, 0.3f, 0.5f, 1.0f}) {
            Item like;
            like.s = sigma;
            const double a = albedo("oren_nayar_brdf", beam(angle), out, like);
            most = std::max(most, a);
            if (sigma == 0) {
                EXPECT_NEAR(a, 1, 2e-4);
            }
        }
    EXPECT_NEAR(most, 1.015, 0.001);  // A + B / 2 at the horizon, greatest at sigma 0.2
}

TEST(Furnace, BoundedWardStaysWithinItsReflectance) {
    for (const auto& [ax, ay] : {std::pair{0.05, 0.05}, {0.2, 0.2}, {0.6, 0.6}, {0.1, 0.4}, {0.4, 0.1}})
        for (const double angle : furnace_degrees) {
            const Direction l = beam(angle);
            const double a = albedo("ward_bounded_brdf", l, about_the_mirror(l, std::max(ax, ay)), widths(ax, ay));
            EXPECT_LE(a, 1.003) << ax << " " << ay << " at " << angle;
            if (angle == 0 && ax <= 0.05) {
                EXPECT_NEAR(a, 1, 0.01);
            }
        }
}

TEST(Furnace, EarlierFormsOfWardHaveTheirKnownFaults) {
    const Direction steep = beam(0), grazing = beam(88);
    const Outgoing above = about_the_mirror(steep, 0.2), along = about_the_mirror(grazing, 0.2);
    EXPECT_NEAR(albedo("ward_1992_brdf", steep, above, widths(0.05, 0.05)), 1, 0.02);
    EXPECT_LT(albedo("ward_1992_brdf", grazing, along, widths(0.2, 0.2)), 0.7);  // loses light where it should not
    EXPECT_GT(albedo("ward_duer_brdf", grazing, along, widths(0.2, 0.2)), 1.2);  // makes light
}

TEST(Furnace, GgxStaysWithinOneAndLosesOneMinusLogTwoOfARoughSurface) {
    EXPECT_NEAR(ggx_albedo(0, 1), 1 - std::log(2.0), 1e-3);
    for (const double alpha : {0.01, 0.05, 0.2, 0.5, 1.0})
        for (const double angle : furnace_degrees)
            EXPECT_LE(ggx_albedo(angle, alpha), 1.002) << alpha << " at " << angle;
    const Direction l = beam(60);
    EXPECT_LE(albedo("ggx_anisotropic_brdf", l, about_the_mirror(l, 0.5), widths(0.5, 0.1)), 1.002);
}

/// A table between its columns and rows as the engine reads it.
double from_table(const float* table, double place, double roughness) {
    const double x = std::sqrt(place) * (lighting::albedo_columns - 1);
    const double y = roughness * (lighting::albedo_rows - 1);
    const int c = std::min(int(x), lighting::albedo_columns - 2), r = std::min(int(y), lighting::albedo_rows - 2);
    const auto at = [&](int row, int column) { return double(table[row * lighting::albedo_columns + column]); };
    const double p = x - c, q = y - r;
    return (at(r, c) * (1 - p) + at(r, c + 1) * p) * (1 - q) + (at(r + 1, c) * (1 - p) + at(r + 1, c + 1) * p) * q;
}

double lobe_from_table(double n_dot_l, double roughness) {
    const double alpha = std::max(roughness * roughness, 1e-3), width = alpha / (n_dot_l + alpha);
    return 1 - width * width * from_table(lighting::albedo_tables().lobe_loss, (1 - width) * (1 + alpha), roughness);
}

double loss_from_table(double roughness) {
    const double y = roughness * (lighting::albedo_rows - 1);
    const int r = std::min(int(y), lighting::albedo_rows - 2);
    const float* const loss = lighting::albedo_tables().loss;
    return std::pow(roughness, 4) * (double(loss[r]) * (1 - (y - r)) + double(loss[r + 1]) * (y - r));
}

TEST(Furnace, TheTableHoldsTheAlbedoOfTheLobe) {
    for (const double roughness : {0.1, 0.33, 0.5, 0.71, 0.9, 1.0})
        for (const double angle : furnace_degrees)
            EXPECT_NEAR(lobe_from_table(beam(angle).z, roughness), ggx_albedo(angle, roughness * roughness), 0.005)
                << roughness << " at " << angle;
}

TEST(Furnace, WithCompensationGgxReflectsAllWithinOnePercent) {
    const Outgoing rest = whole_hemisphere();
    for (const double roughness : {0.1, 0.25, 0.4, 0.6, 0.8, 1.0}) {
        const double mean_loss = loss_from_table(roughness);
        double lost = 0;  // integral of (1 - E(v)) cos v
        for (std::size_t i = 0; i < rest.v.size(); ++i)
            lost += (1 - lobe_from_table(rest.v[i].z, roughness)) * rest.v[i].z * rest.solid_angle[i];
        for (const double angle : furnace_degrees) {
            const double from_l = lobe_from_table(beam(angle).z, roughness);
            const double given_back = (1 - from_l) * lost / (pi_d * std::max(mean_loss, 1e-6));
            EXPECT_NEAR(ggx_albedo(angle, roughness * roughness) + given_back, 1, 0.01) << roughness << " at " << angle;
        }
    }
}

TEST(Furnace, TheTableOfSchlicksWeightSplitsTheAlbedo) {
    // lobe (f0 (1 - grazing) + f90 grazing) is what a surface of f0 0.04 reflects of white surroundings
    const lighting::AlbedoTables t = lighting::albedo_tables();
    for (const double roughness : {0.3, 0.6, 1.0})
        for (const double angle : {0.0, 45.0, 75.0, 88.0}) {
            const Direction l = beam(angle);
            const Outgoing out = about_the_mirror(l, roughness * roughness);
            Item like;
            like.ks = {0.04f, 0.04f, 0.04f}, like.e = like.t = float(roughness * roughness);
            Items items = items_of(l, out, like);
            const Results r = material(scalar::kernel, items, {pbr});
            double sum = 0;
            for (std::size_t i = 0; i < out.v.size(); ++i)
                sum += double(r[6][i]) / (pi_d * l.z) * out.v[i].z * out.solid_angle[i];
            const double lobe = lobe_from_table(l.z, roughness), grazing = from_table(t.grazing, l.z, roughness);
            EXPECT_NEAR(lobe * (0.04 * (1 - grazing) + grazing), sum, 0.004) << roughness << " at " << angle;
        }
}

TEST(Furnace, TheTableOfSheenHoldsItsAlbedo) {
    const Outgoing out = whole_hemisphere();
    const lighting::AlbedoTables t = lighting::albedo_tables();
    for (const int row : {5, 10, 15}) {
        const double roughness = double(row) / (lighting::sheen_rows - 1);
        for (const int column : {8, 16, 24, 31}) {
            const double x = double(column) / (lighting::albedo_columns - 1), c = x * x;
            const double expected =
                albedo("sheen_brdf", {std::sqrt(1 - c * c), 0, c}, out, widths(roughness * roughness, 1));
            EXPECT_NEAR(double(t.sheen[row * lighting::albedo_columns + column]), expected, 0.003)
                << row << " " << column;
        }
    }
}

}  // namespace
}  // namespace rakelight::lighting_test
