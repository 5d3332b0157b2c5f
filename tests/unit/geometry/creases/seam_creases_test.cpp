// SPDX-License-Identifier: Apache-2.0
// Creases between curved parts: a rim that was authored hard stays, a cut of a smooth surface is closed.
#include <gtest/gtest.h>

#include <array>
#include <span>
#include <utility>

#include "unit/geometry/groups/joined_shapes.h"

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
                                         {45.0, 10u},
                                         {45.0, 8u},
                                         {30.0, 24u},
                                         {30.0, 16u},
                                         {30.0, 12u},
                                         {20.0, 16u},
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

TEST(SeamCreases, NormalsThatBendTowardsEachOtherMakeNoCrease) {
    EXPECT_GT(join(rim(45, 32, 20)).report.turned, 0u) << "by nearly a half";
    EXPECT_EQ(join(rim(45, 32, 10)).report.turned, 0u);
}

/// Each part with the normals that it has by itself.
std::vector<Shape> smoothed_apart(std::vector<Shape> parts, CornerWeight weight = CornerWeight::angle) {
    Context context;
    AttributeOptions options;
    options.scope = Scope::object;
    options.weight = weight;
    const std::vector<MeshAttributes> own = compute_attributes(views(parts), options, context);
    for (std::size_t m = 0; m < parts.size(); ++m) {
        EXPECT_TRUE(own[m].source_vertex.empty());
        parts[m].normals.assign(own[m].normals.begin(), own[m].normals.end());
    }
    return parts;
}

/// A surface of revolution that is cut at each row in turn, each part smoothed by itself.
void expect_closed(const char* name, const Shape& whole, std::uint32_t rows, std::size_t triangles_per_row) {
    for (std::uint32_t row = 1; row < rows; ++row) {
        std::vector<Shape> parts =
            cut(whole, 2, [&](std::size_t t) { return std::uint32_t(t / triangles_per_row >= row); });
        const Joined joined = join(smoothed_apart(std::move(parts)));
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

/// A sphere of some rows, columns around the y axis, and parts from the bottom to the top.
std::vector<Shape> sphere_in_parts(std::uint32_t columns, std::uint32_t rows, std::uint32_t parts) {
    return cut(make_sphere(columns, rows), parts,
               [=](std::size_t t) { return std::uint32_t(t / (2 * columns)) / (rows / parts); });
}

TEST(SeamCreases, HemispheresOfTwoRowsAreACutSphereByAnyWeightsOfTheirNormals) {
    for (const CornerWeight weight : {CornerWeight::angle, CornerWeight::area, CornerWeight::uniform}) {
        const std::vector<Shape> halves = smoothed_apart(sphere_in_parts(64, 4, 2), weight);
        const Joined joined = join(halves);
        EXPECT_EQ(joined.report.crease_pairs, 0u);
        std::size_t border = 0;
        for (const Shape& half : applied(halves, joined))
            for (std::size_t v = 0; v < half.positions.size(); ++v) {
                if (std::fabs(half.positions[v].y) > 1e-6f) continue;
                ++border;
                EXPECT_LT(degrees_between(half.normals[v], half.positions[v]), 0.1);
            }
        EXPECT_EQ(border, 2u * 65);
    }
}

TEST(SeamCreases, RingsOfOneRowAreACutSphere) {
    for (const std::uint32_t columns : {24u, 64u}) {
        const std::vector<Shape> rings = smoothed_apart(sphere_in_parts(columns, 16, 16));
        const Joined joined = join(rings);
        EXPECT_EQ(joined.report.crease_pairs, 0u);
        for (const Shape& ring : applied(rings, joined))
            for (std::size_t v = 0; v < ring.positions.size(); ++v) {
                // Around the poles, the angles of the corners are far from equal.
                if (std::fabs(ring.positions[v].y) < 0.7f) {
                    EXPECT_LT(degrees_between(ring.normals[v], ring.positions[v]), 1);
                }
            }
    }
}

TEST(SeamCreases, AChamferBetweenACylinderAndItsLidStaysThoughAllItsCornersAreAtBorders) {
    const double half = std::sqrt(0.5);
    const std::array<dvec2, 2> out{{{1, 0}, {1, 0}}}, slope{{{half, half}, {half, half}}}, up{{{0, 1}, {0, 1}}};
    std::vector<Shape> parts = {
        revolved(std::array<dvec2, 2>{{{0, 0}, {1, 0}}}, 24, std::array<dvec2, 2>{{{0, -1}, {0, -1}}}),
        revolved(std::array<dvec2, 2>{{{1, 0}, {1, 1}}}, 24, out),
        revolved(std::array<dvec2, 2>{{{1, 1}, {0.8, 1.2}}}, 24, slope),
        revolved(std::array<dvec2, 2>{{{0.8, 1.2}, {0, 1.2}}}, 24, up)};
    for (std::uint32_t m = 0; m < 4; ++m) parts[m].object = m;
    const Joined joined = join(parts);
    EXPECT_EQ(joined.report.turned, 0u);
    EXPECT_EQ(joined.report.crease_pairs, 48u) << "both rims of the chamfer";
}

TEST(SeamCreases, ACreaseOfMirroredMeshesStaysToo) {
    std::vector<Shape> parts = rim(30, 12);
    for (const bool mirrored : {false, true}) {
        for (Shape& s : parts) s.to_world = translation(dvec3{1, 2, 3}) * scaling(dvec3{mirrored ? -1.0 : 1.0, 1, 1});
        const Joined joined = join(parts);
        EXPECT_EQ(joined.report.turned, 0u);
        EXPECT_EQ(joined.report.crease_pairs, 12u);
    }
}

/// Triangles around an apex, each a mesh with the normal of its face.
std::vector<Shape> petals(std::uint32_t count) {
    std::vector<Shape> all;
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto at = [&](std::uint32_t k) {
            const double a = 2 * pi * (k % count) / count;
            return cast<float>(dvec3{std::cos(a), -0.5, -std::sin(a)});
        };
        Shape s;
        s.object = i;
        s.positions = {{0, 0, 0}, at(i), at(i + 1)};
        s.indices = {0, 1, 2};
        s.normals.assign(3, cast<float>(normalize_or(edge_product(s, 0), dvec3{})));
        all.push_back(s);
    }
    return all;
}

TEST(SeamCreases, FlatPartsThatFollowOneAfterTheOtherAreJoinedInOneCall) {
    // One petal is not flat at the apex: its neighbors join it and are flat no more, and so on all around.
    constexpr std::uint32_t count = 40;
    std::vector<Shape> before = petals(count);
    EXPECT_EQ(join(before).report.turned, 0u);
    before[0].normals[0] = {0, 1, 0};
    dvec3 wanted{0, 1, 0};
    for (std::uint32_t i = 1; 2 * i <= count; ++i) {  // one more on either side; all angles are equal
        dvec3 sum = wanted * (2.0 * i - 1) + cast<double>(before[i].normals[0]);
        if (2 * i < count) sum += cast<double>(before[count - i].normals[0]);
        wanted = normalize_or(sum, dvec3{});
    }
    const std::vector<Shape> after = applied(before, join(before));
    for (const Shape& s : after) EXPECT_LT(degrees_between(cast<double>(s.normals[0]), wanted), 1e-4);
    EXPECT_EQ(join(after).report.turned, 0u) << "a second call changes nothing";
}

}  // namespace
}  // namespace rakelight::test
