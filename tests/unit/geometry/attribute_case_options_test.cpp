// SPDX-License-Identifier: Apache-2.0
// The table of hard cases, continued from attribute_cases_test.cpp: how faces hang together, and what options make of
// them.
#include "unit/geometry/attribute_cases.h"

namespace rakelight::test {
namespace {

TEST(AttributeCases, BowTie) {
    // Two tents of two triangles that touch in one vertex.
    Shape s;
    s.positions = {{0, 0, 0}, {1, 0, -1}, {1, 0.5f, 0}, {1, 0, 1}, {-1, 1, -1}, {-1, 2, 0}, {-1, 1, 1}};
    s.indices = {0, 2, 1, 0, 3, 2, 0, 4, 5, 0, 5, 6};
    AttributeOptions options = published();
    const MeshAttributes one = compute({s}, options).front();
    EXPECT_TRUE(one.indices.empty()) << "by position: one average";
    options.fans = true;
    const MeshAttributes two = compute({s}, options).front();
    EXPECT_EQ(two.source_vertex, (std::vector<std::uint32_t>{0}));
    EXPECT_EQ(corner_normal(s, two, 0), corner_normal(s, two, 3)) << "one group a fan";
    EXPECT_EQ(corner_normal(s, two, 6), corner_normal(s, two, 9));
    EXPECT_GT(angle_between(corner_normal(s, two, 0), corner_normal(s, two, 6)), 0.1);
    Shape first = s, second = s;
    first.indices.resize(6);
    second.indices.erase(second.indices.begin(), second.indices.begin() + 6);
    EXPECT_EQ(corner_normal(s, two, 0), compute({first}, options).front().normals[0]);
    EXPECT_EQ(corner_normal(s, two, 6), compute({second}, options).front().normals[0]);
}

TEST(AttributeCases, NonManifold) {
    // Three pages on one spine are one fan.
    Shape s;
    s.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 0.2f, 0}, {0.5f, 1, 0}};
    s.indices = {0, 1, 2, 1, 0, 3, 0, 1, 4};
    AttributeOptions options = published();
    options.fans = true;
    const MeshAttributes fan = compute({s}, options).front(), joined = compute({s}, published()).front();
    EXPECT_TRUE(fan.indices.empty());
    for (std::size_t v = 0; v < 5; ++v) EXPECT_LT(length(fan.normals[v] - joined.normals[v]), 1e-6f);
}

TEST(AttributeCases, TJunction) {
    // The middle of a long edge belongs to two small triangles only: it is no vertex of the large one, which stays as
    // it is.
    const Shape large = triangle({0, 0, 0}, {2, 0, 0}, {1, 0, -2});
    Shape small;
    small.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, -1, 1}};
    small.indices = {0, 3, 1, 1, 3, 2};
    small.object = 1;
    const auto out = compute({large, small}, published());
    const auto alone = compute({small}, published());
    EXPECT_EQ(out[1].normals[1], alone[0].normals[1]);
    EXPECT_EQ(out[0].normals[0], out[1].normals[0]);
    EXPECT_NE(out[1].normals[0], alone[0].normals[0]);
}

TEST(AttributeCases, CreaseAngle) {
    // Joined over edges, not face against face: a chain of 30 degrees each, 120 in all, is smooth at each of its edges.
    Shape s;
    for (int i = 0; i <= 5; ++i) {
        const double a = radians(30.0 * i);
        s.positions.push_back({float(std::cos(a)), float(std::sin(a)), 0});
        s.positions.push_back({0, 0, 1});
        if (i > 0) {
            const std::uint32_t v = std::uint32_t(2 * i);
            s.indices.insert(s.indices.end(), {v - 2, v, 1});
        }
    }
    const MeshAttributes out = compute({s}, crease(30)).front();
    for (std::size_t i = 3; i < s.indices.size(); i += 3)
        EXPECT_EQ(corner_normal(s, out, i), corner_normal(s, out, i - 2));
    for (const double bend : {0.0, 59.999, 60.0, 60.001, 180.0}) {
        const auto hinge = make_hinge(radians(bend));
        const auto at_60 = compute(hinge, crease(60)), at_0 = compute(hinge, crease(0));
        EXPECT_EQ(at_60[0].normals[0] == at_60[1].normals[0], bend <= 60.0005) << bend << ": inclusive";
        EXPECT_EQ(at_0[0].normals[0], (vec3{0, 1, 0})) << bend;
    }
}

TEST(AttributeCases, SmoothingGroups) {
    for (const bool across : {false, true})
        for (const auto& [kind, a, b, joins] : {std::tuple{GroupKind::masks, 3u, 6u, true},
                                                {GroupKind::masks, 1u, 2u, false},
                                                {GroupKind::numbers, 4096u, 4096u, true},
                                                {GroupKind::numbers, 3u, 1u, false},
                                                {GroupKind::numbers, 0u, 0u, false},
                                                {GroupKind::masks, 0u, 0u, false}}) {
            auto parts = make_hinge(radians(45));
            parts[0].smoothing.assign(2, a);
            parts[1].smoothing.assign(2, b);
            for (Shape& s : parts) s.kind = kind;
            AttributeOptions options = crease(10);
            options.groups_across = across;
            auto out = compute(parts, options);
            EXPECT_EQ(out[0].normals[0] == out[1].normals[0], across && joins) << "two objects";
            parts[1].object = 0;
            out = compute(parts, options);
            EXPECT_EQ(out[0].normals[0] == out[1].normals[0], joins) << "one object";
        }
}

// Vertices 0 and 1 of the first part, at the hinge, are locked to a normal of their own.
MeshAttributes locked_hinge(bool vote, vec3 given, MeshAttributes* other) {
    const auto parts = make_hinge(radians(60));
    std::vector<vec3> normals(4, given);
    const std::vector<std::uint8_t> locked{1, 1, 0, 0};
    auto meshes = views(parts);
    meshes[0].normals = normals;
    meshes[0].locked = locked;
    AttributeOptions options = published();
    options.locked_vote = vote;
    Context context({.threads = 2});
    const auto out = compute_attributes(meshes, options, context);
    *other = out[1];
    return out[0];
}

TEST(AttributeCases, KeepAuthored) {
    const vec3 given{0.6f, 0, 0.8f};
    MeshAttributes other;
    for (const bool vote : {true, false}) {
        const MeshAttributes out = locked_hinge(vote, given, &other);
        EXPECT_EQ(out.normals[0], given) << "to the bit";
        EXPECT_EQ(out.normals[1], given);
        EXPECT_EQ(out.normals[2], (vec3{0, 1, 0})) << "not locked";
        EXPECT_NEAR(degrees(angle_between(other.normals[0], vec3{0, 1, 0})), vote ? 30 : 60, 1e-3)
            << "has a say: " << vote;
    }
    EXPECT_NEAR(degrees(angle_between(locked_hinge(true, vec3{}, &other).normals[0], vec3{0, 1, 0})), 30, 1e-3)
        << "a lock on a normal of no use does not hold";
    auto meshes = views(make_hinge(0));
    const std::vector<std::uint8_t> locked(4, 1);
    meshes[0].locked = locked;
    Context context;
    EXPECT_THROW(compute_attributes(meshes, {}, context), Error) << "no normals to keep";
}

TEST(AttributeCases, QuantizedAttributes) {
    // A sphere in two parts, each rounded to a grid of its own.
    const Shape whole = make_sphere(24, 12);
    const double step = 1.0 / 512;
    auto parts = cut_by_planes(whole, 2);
    const auto uncut = parts;
    std::mt19937 random(2);
    for (std::size_t m = 0; m < 2; ++m)
        for (vec3& p : parts[m].positions) {
            const double shift = 0.2 * step * double(m);
            p = {float(std::round((p.x + shift) / step) * step - shift), float(std::round(p.y / step) * step),
                 float(std::round(p.z / step) * step)};
        }
    auto meshes = views(parts);
    for (AttributeMesh& m : meshes) m.position_step = step;
    Context context({.threads = 2});
    const auto out = compute_attributes(meshes, published(), context);
    std::map<std::tuple<float, float, float>, vec3> seen;
    std::size_t shared = 0;
    for (std::size_t m = 0; m < 2; ++m)
        for (std::size_t v = 0; v < parts[m].positions.size(); ++v) {
            const vec3 p = uncut[m].positions[v];
            const auto [at, is_new] =
                seen.try_emplace(std::tuple(p.x + 0.0f, p.y + 0.0f, p.z + 0.0f), out[m].normals[v]);
            if (is_new) continue;
            ++shared;
            EXPECT_EQ(at->second, out[m].normals[v]) << "part " << m << " vertex " << v;
        }
    EXPECT_GT(shared, 20u);
    for (AttributeMesh& m : meshes) m.position_step = -1;
    EXPECT_THROW(compute_attributes(meshes, published(), context), Error);
}

TEST(AttributeCases, LargeCoordinates) {
    const auto near = cut_by_planes(make_sphere(24, 12), 3);
    auto far = near;
    for (Shape& s : far) s.to_world = translation(dvec3{4.5e6, -1.2e6, 4.5e6});
    const auto a = compute(near, published()), b = compute(far, published());
    for (std::size_t m = 0; m < 3; ++m) EXPECT_EQ(a[m].normals, b[m].normals) << "georeferenced: exact";
}

TEST(AttributeCases, ToleranceTransitivity) {
    // A chain of points closer than the tolerance but wider in all than twice it stays exact, and is reported.
    std::vector<Shape> chain;
    for (std::uint32_t i = 0; i < 6; ++i)
        chain.push_back(
            triangle({0.9f * float(i), 0, 0}, {0.9f * float(i), 50, float(i)}, {0.9f * float(i) + 50, 0, 50}, i));
    AttributeOptions options = published();
    options.weld_distance = 1;
    Context context({.threads = 2});
    const auto out = compute_attributes(views(chain), options, context);
    EXPECT_NE(out[0].normals[0], out[1].normals[0]);
    EXPECT_FALSE(context.report().entries().empty());
    chain.resize(2);
    const auto pair = compute(chain, options);
    EXPECT_EQ(pair[0].normals[0], pair[1].normals[0]);
}

TEST(AttributeCases, Weights) {
    // A cube's corner, one of whose sides is cut into two triangles there: by angle and by area that makes no
    // difference.
    const Shape cube = make_cube();
    const double even = 1 / std::sqrt(3.0);
    for (const auto& [weight, is_even] : {std::pair{CornerWeight::uniform, false},
                                          {CornerWeight::angle, true},
                                          {CornerWeight::area, false},
                                          {CornerWeight::angle_area, true},
                                          {CornerWeight::max, true}}) {
        AttributeOptions options = published();
        options.weight = weight;
        double worst = 0;
        const MeshAttributes out = compute({cube}, options).front();
        for (const vec3 n : out.normals)
            worst = std::fmax(worst, std::fabs(std::fabs(n.x) - even) + std::fabs(std::fabs(n.y) - even));
        EXPECT_EQ(worst < 1e-6, is_even) << int(weight);
    }
    // Two sheets of areas 4 to 1 and angles 90 to 45 degrees at the common corner.
    Shape big = triangle({0, 0, 0}, {2, 0, 0}, {0, 2, 0}), small = triangle({0, 0, 0}, {0, 1, 0}, {0, 1, 1}, 1);
    for (const auto& [weight, x, z] : {std::tuple{CornerWeight::uniform, 1.0, 1.0},
                                       {CornerWeight::area, 0.5, 2.0},
                                       {CornerWeight::angle, pi / 4, pi / 2},
                                       {CornerWeight::angle_area, pi / 8, pi},
                                       {CornerWeight::max, 0.5, 0.25}}) {
        AttributeOptions options = published();
        options.weight = weight;
        const vec3 n = compute({big, small}, options).front().normals[0];
        EXPECT_LT(degrees(angle_between(cast<double>(n), normalize_or(dvec3{x, 0, z}, dvec3{}))), 1e-4) << int(weight);
    }
}

TEST(AttributeCases, EmptyAndOutOfRange) {
    Context context;
    EXPECT_TRUE(compute_attributes({}, {}, context).empty());
    Shape bad = quad();
    bad.indices[4] = 4;
    EXPECT_THROW(compute({bad}, {}), Error);
    bad.indices.resize(5);
    EXPECT_THROW(compute({bad}, {}), Error);
    // One array of indices seen by many meshes: more corners than 32 bits count is an error, not a wrap.
    const std::vector<std::uint32_t> indices(3 << 20, 0);
    const std::vector<vec3> positions(1);
    std::vector<AttributeMesh> many(2000);
    for (AttributeMesh& m : many) {
        m.positions = positions;
        m.indices = indices;
    }
    EXPECT_THROW(compute_attributes(many, {}, context), Error);
}

TEST(AttributeCases, ManyTinyObjects) {
    std::vector<Shape> objects;
    for (std::uint32_t i = 0; i < 20000; ++i) {
        const float x = float(i % 200), y = float(i / 200);
        objects.push_back(triangle({x, y, 0}, {x + 1, y, 0}, {x, y + 1, 0}, i));
    }
    const auto out = compute(objects, published());
    for (const MeshAttributes& m : out)
        for (const vec3 n : m.normals) ASSERT_EQ(n, (vec3{0, 0, 1}));
}

}  // namespace
}  // namespace rakelight::test
