// SPDX-License-Identifier: Apache-2.0
// Creases between curved parts: a rim that was authored hard stays, a cut of a smooth surface is closed.
#include <gtest/gtest.h>

#include <array>
#include <span>
#include <utility>

#include "unit/geometry/joined_shapes.h"

namespace rakelight::test {
namespace {

/// A strip of a surface of revolution about y, with the normals of that surface: `profile` from below, {radius, height}.
Shape revolved(std::span<const dvec2> profile, std::uint32_t segments, std::span<const dvec2> normals) {
    Shape s;
    for (std::size_t r = 0; r < profile.size(); ++r)
        for (std::uint32_t i = 0; i < segments; ++i) {
            const double a = 2 * pi * i / segments, c = std::cos(a), z = std::sin(a);
            s.positions.push_back(cast<float>(dvec3{profile[r].x * c, profile[r].y, -profile[r].x * z}));
            s.normals.push_back(cast<float>(dvec3{normals[r].x * c, normals[r].y, -normals[r].x * z}));
        }
    for (std::uint32_t r = 0; r + 1 < profile.size(); ++r)
        for (std::uint32_t i = 0; i < segments; ++i) {
            const std::uint32_t a = r * segments + i, b = r * segments + (i + 1) % segments;
            s.indices.insert(s.indices.end(), {a, b, b + segments, a, b + segments, a + segments});
        }
    return s;
}

/// A cylinder below, a cone above that bends inwards by an angle at the rim; both smooth in themselves.
std::vector<Shape> rim(double bend_deg, std::uint32_t segments, double lean_deg = 0) {
    const double c = std::cos(radians(bend_deg)), s = std::sin(radians(bend_deg)), l = radians(lean_deg);
    const dvec2 wall{std::cos(l), std::sin(l)}, roof{std::cos(radians(bend_deg) - l), std::sin(radians(bend_deg) - l)};
    std::vector<Shape> parts = {
        revolved(std::array<dvec2, 2>{{{1, 0}, {1, 1}}}, segments, std::array<dvec2, 2>{{{1, 0}, wall}}),
        revolved(std::array<dvec2, 2>{{{1, 1}, {1 - 0.5 * s, 1 + 0.5 * c}}}, segments,
                 std::array<dvec2, 2>{{roof, {c, s}}})};
    parts[1].object = 1;
    return parts;
}

TEST(SeamCreases, ARimAuthoredHardBetweenTwoCurvedPartsStays) {
    for (const auto& [bend, segments] : {std::pair(45.0, 32u),
                                         {45.0, 16u},
                                         {45.0, 12u},
                                         {30.0, 24u},
                                         {30.0, 16u},
                                         {20.0, 24u},
                                         {20.0, 64u},
                                         {12.0, 64u},
                                         {59.0, 12u}}) {
        const Joined joined = join(rim(bend, segments));
        EXPECT_EQ(joined.report.turned, 0u) << bend << " degrees, " << segments << " segments";
        EXPECT_EQ(joined.report.crease_pairs, segments);
        EXPECT_EQ(joined.report.flat_pairs, 0u);
    }
}

TEST(SeamCreases, ARimThatBendsAsThePartsDoThemselvesIsACut) {
    // A barrel: where its walls bend by 15 degrees, they do so around it too; the normal in the middle is horizontal.
    std::vector<Shape> barrel = rim(15, 24);
    const std::vector<Shape> after = applied(barrel, join(barrel));
    const double half = radians(7.5);
    for (std::uint32_t i = 24; i < 48; ++i) {
        const vec3 p = barrel[0].positions[i];
        const dvec3 wanted{std::cos(half) * double(p.x), std::sin(half), std::cos(half) * double(p.z)};
        EXPECT_LT(degrees_between(cast<double>(after[0].normals[i]), wanted), 0.1);  // by the corners' angles
        EXPECT_EQ(after[0].normals[i], after[1].normals[i - 24]);
    }
    EXPECT_GT(join(rim(45, 32, 20)).report.turned, 0u) << "normals that bend towards each other, by nearly a half";
    EXPECT_EQ(join(rim(45, 32, 10)).report.turned, 0u);
}

/// A surface of revolution that is cut at each row in turn, each part smoothed by itself.
void expect_closed(const char* name, const Shape& whole, std::uint32_t rows, std::size_t triangles_per_row) {
    for (std::uint32_t row = 1; row < rows; ++row) {
        std::vector<Shape> parts =
            cut(whole, 2, [&](std::size_t t) { return std::uint32_t(t / triangles_per_row >= row); });
        Context context;
        AttributeOptions options;
        options.scope = Scope::object;
        for (std::size_t m = 0; m < 2; ++m) parts[m].object = std::uint32_t(m);
        const std::vector<MeshAttributes> own = compute_attributes(views(parts), options, context);
        for (std::size_t m = 0; m < 2; ++m) {
            ASSERT_TRUE(own[m].source_vertex.empty());
            parts[m].normals.assign(own[m].normals.begin(), own[m].normals.end());
        }
        const Joined joined = join(parts);
        EXPECT_EQ(joined.report.crease_pairs, 0u) << name << ", row " << row;
        EXPECT_GT(joined.report.turned, 0u) << name << ", row " << row;
    }
}

TEST(SeamCreases, CutsOfSmoothSurfacesAreClosedWhereverTheyAre) {
    const auto lathe = [](auto&& profile) {  // 24 rows of 32 segments
        return make_grid(32, 24, [=](double u, double v) {
            const dvec2 p = profile(v);
            const double a = wrapped(u);
            return cast<float>(dvec3{p.x * std::cos(a), p.y, -p.x * std::sin(a)});
        });
    };
    const auto ellipsoid = [&](double height) {
        return lathe([=](double v) {
            const double a = pi * (0.02 + 0.96 * v) - pi / 2;
            return dvec2{std::cos(a), height * std::sin(a)};
        });
    };
    expect_closed("sphere", ellipsoid(1), 24, 64);
    expect_closed("egg", ellipsoid(1.6), 24, 64);
    expect_closed("lens", ellipsoid(0.6), 24, 64);
    expect_closed("vase", lathe([](double v) { return dvec2{1 + 0.3 * std::sin(9 * v), 3 * v}; }), 24, 64);
}

}  // namespace
}  // namespace rakelight::test
