// SPDX-License-Identifier: Apache-2.0
// Parallax techniques against height fields whose ray intersections are solved in double: a plane, a ramp, a step, a
// sphere's cap. A texel is 1/256 of the relief's width.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

#include "unit/lighting/lighting_items.h"
#include "unit/lighting/relief_fields.h"

namespace rakelight::lighting_test {
namespace {

constexpr double texels = 256;

double field_height(int field, double u, double v) {
    if (field == field_constant) return 0.4;
    if (field == field_ramp) return 0.2 + 0.6 * u;
    if (field == field_step) return u < 0.5 ? 0.2 : 0.8;
    const double r2 = (u - 0.5) * (u - 0.5) + (v - 0.5) * (v - 0.5);
    return 0.25 + 3 * std::max(0.0, (r2 < 0.25 ? std::sqrt(0.25 - r2) : 0.0) - 0.3);
}

/// A ray that passes height h at u + du (h - level), v + dv (h - level).
struct Ray {
    double u, v, du, dv, level;
    double u_at(double h) const { return u + du * (h - level); }
    double v_at(double h) const { return v + dv * (h - level); }
};

double meet_step(const Ray& r) {
    if (r.u_at(0.8) >= 0.5) return 0.8;
    const double wall = r.du != 0 ? r.level + (0.5 - r.u) / r.du : -1;  // height at which it passes u = 0.5
    return wall > 0.2 && wall < 0.8 ? wall : 0.2;
}

/// ((h + 0.65) / 3)^2 + r^2 = 1/4, where the ray is not outside of the rim.
double meet_cap(const Ray& r) {
    const double a = r.u_at(0) - 0.5, b = r.v_at(0) - 0.5;
    const double p = 1.0 / 9 + r.du * r.du + r.dv * r.dv, q = 0.65 / 9 + a * r.du + b * r.dv;
    const double c = 0.65 * 0.65 / 9 + a * a + b * b - 0.25, root = q * q - p * c;
    if (root <= 0) return 0.25;
    const double h = (-q + std::sqrt(root)) / p, x = r.u_at(h) - 0.5, y = r.v_at(h) - 0.5;
    return h > 0.25 && x * x + y * y <= 0.16 ? h : 0.25;
}

/// The height at which the ray, coming down from height 1, first meets the field.
double exact_height(int field, const Ray& r) {
    if (field == field_constant) return 0.4;
    if (field == field_ramp) return (0.2 + 0.6 * (r.u - r.du * r.level)) / (1 - 0.6 * r.du);
    return field == field_step ? meet_step(r) : meet_cap(r);
}

/// Whether the point at u, v, h sees the light: 20,000 looks.
bool exact_light(int field, double u, double v, double h, double du, double dv) {
    constexpr int looks = 20000;
    for (int i = 1; i <= looks; ++i) {
        const double up = (1 - h) * i / looks;
        if (field_height(field, u + du * up, v + dv * up) > h + up + 1e-9) return false;
    }
    return true;
}

vec3 towards(double degrees_off_normal, double azimuth) {
    const double a = degrees_off_normal * pi / 180, b = azimuth * pi / 180;
    return {float(std::sin(a) * std::cos(b)), float(std::sin(a) * std::sin(b)), float(std::cos(a))};
}

constexpr double azimuths[] = {0, 37, 90, 180, 233};

/// 21 x 21 places in the middle half, each from five sides.
Items rays_at(double view_degrees, double light_degrees = 45) {
    Items items;
    for (const double azimuth : azimuths)
        for (int y = 0; y <= 20; ++y)
            for (int x = 0; x <= 20; ++x) {
                Item item;
                item.p = {0.253f + 0.5f * float(x) / 20, 0.253f + 0.5f * float(y) / 20, 0};
                item.v = towards(view_degrees, azimuth);
                item.l = towards(light_degrees, azimuth + 20);
                items.push(item);
            }
    return items;
}

constexpr float depth = 0.08f, level = 0.7f;
constexpr int fewest = 16, most = 48;

ReliefCase relief_case(int field, int march) { return {field, march, depth, level, fewest, most, 5}; }

Results find(const Kernel& kernel, Items& items, ReliefCase c) {
    const Inputs in = items.inputs();
    Results results(4, in.count);
    kernel.relief(in, c, results.out());
    return results;
}

Ray ray_of(const Inputs& in, std::size_t i) {
    const double rise = double(in.column[8][i]);
    return {double(in.column[18][i]), double(in.column[19][i]), double(in.column[6][i]) / rise * double(depth),
            double(in.column[7][i]) / rise * double(depth), double(level)};
}

struct Error {
    double mean = 0, worst = 0;
    double worst_height = 0;  ///< along the ray
};

/// Distance in texels between where a technique and the exact ray read the maps.
Error error_of(int field, int march, double degrees) {
    Items items = rays_at(degrees);
    const Results got = find(scalar::kernel, items, relief_case(field, march));
    const Inputs in = items.inputs();
    Error e;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const Ray r = ray_of(in, i);
        const double h = exact_height(field, r);
        const double off = std::hypot(double(got[0][i]) - r.u_at(h), double(got[1][i]) - r.v_at(h)) * texels;
        e.mean += off / double(items.size());
        e.worst = std::max(e.worst, off);
        e.worst_height = std::max(e.worst_height, std::fabs(double(got[2][i]) - h));
    }
    return e;
}

constexpr double view_angles[] = {20, 50, 75};

}  // namespace

TEST(Relief, PlainParallaxIsExactForAConstantHeight) {
    for (const double degrees : view_angles) EXPECT_LT(error_of(field_constant, march_plain, degrees).worst, 1e-3);
}

TEST(Relief, OffsetLimitingNeverShiftsFurtherThanPlainParallax) {
    for (const int field : {field_constant, field_ramp, field_step, field_cap})
        for (const double degrees : {0.0, 20.0, 50.0, 75.0, 88.0, 89.9}) {
            Items items = rays_at(degrees);
            const Results plain = find(scalar::kernel, items, relief_case(field, march_plain));
            const Results limited = find(scalar::kernel, items, relief_case(field, march_limited));
            const Inputs in = items.inputs();
            for (std::size_t i = 0; i < items.size(); ++i) {
                const auto shift = [&](const Results& r) {
                    return std::hypot(double(r[0][i]) - double(in.column[18][i]),
                                      double(r[1][i]) - double(in.column[19][i]));
                };
                EXPECT_LE(shift(limited), shift(plain) + 1e-7);
                EXPECT_LE(shift(limited), double(depth));  // bounded, whatever the angle
            }
        }
}

TEST(Relief, SteepParallaxIsAtMostALayerOffAlongTheRay) {
    for (const int field : {field_constant, field_ramp, field_step, field_cap})
        for (const double degrees : view_angles) {
            const double layers = std::floor(most + (fewest - most) * std::cos(degrees * pi / 180) + 0.5);
            EXPECT_LE(error_of(field, march_steep, degrees).worst_height, 1 / layers + 1e-5) << field << " " << degrees;
        }
}

TEST(Relief, OcclusionIsNearerThanSteepOnSmoothFields) {
    for (const int field : {field_ramp, field_cap})
        for (const double degrees : view_angles) {
            const Error steep = error_of(field, march_steep, degrees), fine = error_of(field, march_occlusion, degrees);
            EXPECT_LT(fine.mean, 0.1 * steep.mean) << field << " " << degrees;
            EXPECT_LT(fine.worst, steep.worst) << field << " " << degrees;
        }
}

/// The table of docs/bump.md, mean error in texels; rows: ramp, step, cap; columns: 20, 50, 75 degrees.
TEST(Relief, MeanErrorsAreThoseOfTheDocumentation) {
    struct Row {
        int march, field;
        double mean[3];
    };
    const Row rows[] = {
        {march_plain, field_ramp, {0.02, 0.19, 1.92}}, {march_limited, field_ramp, {0.09, 1.75, 11.64}},
        {march_steep, field_ramp, {0.21, 0.47, 0.94}}, {march_occlusion, field_ramp, {0, 0, 0}},
        {march_plain, field_step, {0, 0.12, 2.47}},    {march_limited, field_step, {0.13, 2.48, 14.78}},
        {march_steep, field_step, {0.21, 0.46, 0.1}},  {march_occlusion, field_step, {0, 0, 0}},
        {march_plain, field_cap, {0.02, 0.18, 2.43}},  {march_limited, field_cap, {0.04, 0.73, 5.77}},
        {march_steep, field_cap, {0.2, 0.45, 0.93}},   {march_occlusion, field_cap, {0, 0, 0}},
    };
    for (const Row& row : rows)
        for (std::size_t a = 0; a < 3; ++a)
            EXPECT_NEAR(error_of(row.field, row.march, view_angles[a]).mean, row.mean[a], 0.0051)
                << "march " << row.march << " field " << row.field << " angle " << view_angles[a];
}

TEST(Relief, SelfShadowIsTheExactOneButForItsBorder) {
    for (const int field : {field_constant, field_ramp, field_step, field_cap})
        for (const double light : {30.0, 60.0, 78.0}) {
            Items items = rays_at(50, light);
            const Results got = find(scalar::kernel, items, relief_case(field, march_occlusion));
            const Inputs in = items.inputs();
            std::size_t wrong = 0, dark = 0;
            for (std::size_t i = 0; i < items.size(); ++i) {
                const Ray r = ray_of(in, i);
                const double h = exact_height(field, r), rise = double(in.column[5][i]);
                const bool lit =
                    exact_light(field, r.u_at(h), r.v_at(h), h, double(in.column[3][i]) / rise * double(depth),
                                double(in.column[4][i]) / rise * double(depth));
                dark += !lit;
                wrong += (got[3][i] > 0.5f) != lit;
            }
            const bool is_even = field == field_constant || field == field_ramp;
            EXPECT_LE(double(wrong), is_even ? 0 : 0.04 * double(items.size())) << field << " " << light;
            EXPECT_TRUE(field != field_step || light < 70 || dark > items.size() / 50);  // there is something to see
        }
}

TEST(Relief, LightFromUnderThePolygonIsHidden) {
    Items items;
    for (const double degrees : {89.0, 90.0, 91.0, 120.0, 180.0}) {
        Item item;
        item.p = {0.4f, 0.4f, 0};
        item.v = towards(20, 0);
        item.l = towards(degrees, 37);
        if (degrees == 90) item.l.z = 0;  // the cosine of pi / 2 as rounded is not
        items.push(item);
    }
    const auto expect_hidden = [&](const Kernel& kernel, const char* name) {
        for (const int field : {field_constant, field_ramp, field_cap}) {
            const Results got = find(kernel, items, relief_case(field, march_occlusion));
            for (std::size_t i = 1; i < items.size(); ++i)
                EXPECT_EQ(got[3][i], 0.0f) << name << " " << field << " " << i;
        }
        EXPECT_EQ(find(kernel, items, relief_case(field_constant, march_occlusion))[3][0], 1.0f) << name;
    };
    for (const Isa isa : {Isa::scalar, Isa::sse2, Isa::avx2, Isa::avx512})
        if (is_available(isa)) expect_hidden(RL_BY_ISA(isa, kernel), name(isa));
}

TEST(Relief, EveryFlavourGivesTheScalarBits) {
    for (const int field : {field_ramp, field_step, field_cap})
        for (const int march : {march_plain, march_limited, march_steep, march_occlusion}) {
            Items items = rays_at(65, 70);
            const Results expected = find(scalar::kernel, items, relief_case(field, march));
            const auto compare = [&](const Kernel& kernel) {
                const Results got = find(kernel, items, relief_case(field, march));
                for (std::size_t c = 0; c < 4; ++c)
                    for (std::size_t i = 0; i < items.size(); ++i)
                        ASSERT_EQ(std::bit_cast<std::uint32_t>(got[c][i]),
                                  std::bit_cast<std::uint32_t>(expected[c][i]));
            };
            for (const Isa isa : {Isa::sse2, Isa::avx2, Isa::avx512})
                if (is_available(isa)) compare(RL_BY_ISA(isa, kernel));
        }
}

TEST(Relief, DegenerateDirectionsGiveFiniteHeights) {
    Items items;
    for (const vec3 v : {vec3{0, 0, 0}, vec3{1, 0, 0}, vec3{0, 0, -1}, vec3{1e30f, 0, 0}}) {
        Item item;
        item.v = item.l = v;
        item.p = {0.4f, 0.4f, 0};
        items.push(item);
    }
    for (const int march : {march_plain, march_limited, march_steep, march_occlusion}) {
        const Results got = find(scalar::kernel, items, relief_case(field_step, march));
        for (std::size_t i = 0; i < items.size(); ++i) EXPECT_TRUE(got[2][i] >= 0 && got[2][i] <= 1) << i;
    }
}

}  // namespace rakelight::lighting_test
