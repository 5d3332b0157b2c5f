// SPDX-License-Identifier: Apache-2.0
// Plans made from plans (the crease slider): the same vectors, to the bit, as grouping afresh and as the one-shot call.
#include <gtest/gtest.h>

#include <array>

#include "unit/geometry/shapes.h"

namespace rakelight::test {
namespace {

bool operator==(const MeshAttributes& a, const MeshAttributes& b) {
    return a.normals == b.normals && a.tangents == b.tangents && a.bitangents == b.bitangents &&
           a.indices == b.indices && a.source_vertex == b.source_vertex && a.degenerate_faces == b.degenerate_faces &&
           a.isolated_vertices == b.isolated_vertices && a.orthogonality_loss_max_deg == b.orthogonality_loss_max_deg &&
           a.orthogonality_loss_mean_deg == b.orthogonality_loss_mean_deg;
}
bool equal(const std::vector<MeshAttributes>& a, const std::vector<MeshAttributes>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) { return x == y; });
}

std::uint32_t below(std::mt19937& random, std::uint32_t count) { return random() % count; }

// A wild surface: many creases, mirrored and empty texture charts.
Shape crumpled(std::mt19937& random) {
    Shape s = make_torus(12, 8);
    std::uniform_real_distribution<float> shift(-0.3f, 0.3f);
    for (vec3& p : s.positions) p += vec3{shift(random), shift(random), shift(random)};
    for (vec2& q : s.texcoords) q = {float(below(random, 4)), float(below(random, 4))};
    return s;
}

// Triangles between the points of a small lattice: coincident, degenerate, back to back, many on one edge.
Shape lattice_soup(std::mt19937& random) {
    Shape s;
    for (int i = 0; i < 40; ++i)
        s.positions.push_back({float(below(random, 3)), float(below(random, 3)), float(below(random, 2))});
    for (int i = 0; i < 240; ++i) s.indices.push_back(below(random, 40));
    return s;
}

// Some models, each with something that grouping must mind.
std::vector<Shape> random_model(std::uint32_t seed) {
    std::mt19937 random(seed);
    std::vector<Shape> shapes;
    if (seed % 4 == 0) shapes = cut_at_random(make_torus(14, 9), 3, seed);
    if (seed % 4 == 1) shapes = {crumpled(random), make_cube()};
    if (seed % 4 == 2) shapes = {lattice_soup(random), lattice_soup(random)};
    if (seed % 4 == 3) {  // a sheet and its back
        shapes = {make_grid(5, 5, [](double u, double v) { return vec3{float(u), float(u * u), float(-v)}; })};
        shapes.push_back(shapes[0]);
        for (std::size_t i = 0; i < shapes[1].indices.size(); i += 3)
            std::swap(shapes[1].indices[i], shapes[1].indices[i + 1]);
    }
    for (std::uint32_t m = 0; m < shapes.size(); ++m) {
        Shape& s = shapes[m];
        s.object = below(random, 2);
        s.normals.assign(s.positions.size(), vec3{0, 0, 1});
        if (seed % 3 == 1) {
            s.kind = seed % 2 == 0 ? GroupKind::masks : GroupKind::numbers;
            for (std::size_t t = 0; t < s.indices.size() / 3; ++t) s.smoothing.push_back(below(random, 4));
        }
        if (seed % 3 == 2)
            for (std::size_t i = 0; i < s.indices.size(); ++i) s.hints.push_back({0, 0, float(1 + below(random, 2))});
        if (seed % 5 == 4 && m == 0) s.to_world = random_affine(random, seed % 2 == 0);
    }
    return shapes;
}

AttributeOptions random_options(std::mt19937& random) {
    constexpr std::array angles{0.0, 15.0, 60.0, 100.0, 179.0, 180.0};
    constexpr std::array distances{-1.0, 0.0, 0.02};
    AttributeOptions o;
    o.crease_angle_rad = radians(angles[below(random, angles.size())]);
    o.weight = CornerWeight(below(random, 4));
    o.fans = below(random, 4) == 0;
    o.groups_across = below(random, 2) == 0;
    o.locked_vote = below(random, 2) == 0;
    o.tangents = below(random, 4) != 0;
    o.tangent_mode = TangentMode(below(random, 3));
    o.orthogonalize = Orthogonalize(below(random, 2));
    o.measure_orthogonality = below(random, 2) == 0;
    if (below(random, 4) == 0) o.scope = Scope(below(random, 3));
    if (below(random, 4) == 0) o.weld_distance = distances[below(random, distances.size())];
    if (below(random, 8) == 0) o.normals = false;
    return o;
}

TEST(Regroup, EveryStepOfASliderEqualsGroupingAfresh) {
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        const std::vector<Shape> shapes = random_model(seed);
        std::vector<AttributeMesh> meshes = views(shapes);
        std::vector<std::vector<std::uint8_t>> locked;
        for (const Shape& s : shapes) locked.emplace_back(s.positions.size(), 0);
        if (seed % 4 == 1)
            for (std::size_t m = 0; m < meshes.size(); ++m) {
                for (std::size_t v = 0; v < locked[m].size(); v += 3) locked[m][v] = 1;
                meshes[m].locked = locked[m];
            }
        std::mt19937 random(seed);
        Context context({.threads = int(1 + seed % 2)});
        AttributePlan plan = group(meshes, random_options(random), context);
        for (int step = 0; step < 6; ++step) {
            const AttributeOptions options = random_options(random);
            plan = regroup(plan, meshes, options, context);
            const auto made = accumulate(plan, meshes, context);
            EXPECT_TRUE(equal(made, accumulate(group(meshes, options, context), meshes, context)))
                << seed << " step " << step;
            EXPECT_LE(largest_difference(made, compute_attributes(meshes, options, context)), float_rounding)
                << seed << " step " << step;
        }
    }
}

// What compute_attributes_into() gives, put together as arrays.
std::vector<MeshAttributes> through_buffers(std::span<const AttributeMesh> meshes, const AttributeOptions& options,
                                            AttributeWorkspace& workspace, Context& context) {
    std::vector<MeshAttributes> all(meshes.size());
    std::vector<AttributeBuffers> out;
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        all[m].normals.resize(meshes[m].positions.size(), vec3{9, 9, 9});
        if (options.tangents && !meshes[m].texcoords.empty()) all[m].tangents.resize(meshes[m].positions.size());
        out.push_back({all[m].normals, all[m].tangents});
    }
    const auto splits = compute_attributes_into(meshes, options, out, workspace, context);
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        all[m].normals.insert(all[m].normals.end(), splits[m].normals.begin(), splits[m].normals.end());
        all[m].tangents.insert(all[m].tangents.end(), splits[m].tangents.begin(), splits[m].tangents.end());
        all[m].source_vertex = splits[m].source_vertex;
        all[m].degenerate_faces = splits[m].degenerate_faces;
        all[m].isolated_vertices = splits[m].isolated_vertices;
        if (splits[m].source_vertex.empty() && splits[m].corners.empty()) continue;
        all[m].indices.assign(meshes[m].indices.begin(), meshes[m].indices.end());
        for (const CornerVertex& c : splits[m].corners) all[m].indices[c.corner] = c.vertex;
    }
    return all;
}

TEST(Workspace, WhatItHeldBeforeDoesNotShow) {
    AttributeWorkspace workspace;  // one for all models, sizes and options
    std::mt19937 random(7);
    for (std::uint32_t seed = 0; seed < 120; ++seed) {
        const std::vector<Shape> shapes = random_model(seed);
        const auto meshes = views(shapes);
        AttributeOptions options = random_options(random);
        options.measure_orthogonality = false;
        Context context({.threads = int(1 + seed % 3)});
        auto made = compute_attributes(meshes, options, context);
        for (MeshAttributes& m : made)
            m.bitangents.clear();  // of TangentMode::published; buffers have no place for them
        EXPECT_TRUE(equal(through_buffers(meshes, options, workspace, context), made)) << seed;
    }
    EXPECT_GT(workspace.bytes(), 0u);
}

TEST(Regroup, BitsAreThoseOfOneThread) {
    // Larger than the chunks in which work is handed out.
    std::vector<Shape> parts = cut_by_planes(make_torus(300, 160), 2);
    parts.push_back(make_torus(220, 170));
    std::mt19937 random(1);
    std::uniform_real_distribution<float> shift(-0.004f, 0.004f);
    for (vec3& p : parts[2].positions) p += vec3{shift(random), shift(random) + 3, shift(random)};
    const auto meshes = views(parts);
    std::vector<std::vector<MeshAttributes>> of_one;
    for (const int threads : {1, 2, 4}) {
        Context context({.threads = threads});
        std::vector<std::vector<MeshAttributes>> steps;
        AttributePlan plan = group(meshes, {}, context);
        for (const double deg : {3.0, 12.0, 60.0, 0.0}) {
            plan = regroup(plan, meshes, {.crease_angle_rad = radians(deg)}, context);
            steps.push_back(accumulate(plan, meshes, context));
            const auto at_once = compute_attributes(meshes, {.crease_angle_rad = radians(deg)}, context);
            EXPECT_LE(largest_difference(steps.back(), at_once), float_rounding);
        }
        if (of_one.empty()) of_one = steps;
        for (std::size_t i = 0; i < steps.size(); ++i) EXPECT_TRUE(equal(steps[i], of_one[i])) << threads << " threads";
    }
    EXPECT_GT(of_one[0][2].source_vertex.size(), of_one[1][2].source_vertex.size()) << "the angle does part vertices";
    EXPECT_GT(of_one[1][2].source_vertex.size(), of_one[2][2].source_vertex.size());
}

TEST(Regroup, GroupsRunThroughAreTheAngles) {
    const auto hinge = make_hinge(radians(50));
    const auto meshes = views(hinge);
    Context context({.threads = 2});
    AttributePlan plan = group(meshes, {}, context);
    for (const double deg : {60.0, 40.0, 180.0, 0.0, 50.0, 49.9}) {
        plan = regroup(plan, meshes, {.crease_angle_rad = radians(deg)}, context);
        const auto out = accumulate(plan, meshes, context);
        EXPECT_EQ(out[0].normals[0] == out[1].normals[0], deg >= 50) << deg;
    }
}

TEST(Regroup, ANewWeldDistanceCounts) {
    auto hinge = make_hinge(radians(30));
    for (vec3& p : hinge[1].positions) p.x += 1e-4f;
    const auto meshes = views(hinge);
    Context context({.threads = 1});
    AttributePlan plan = group(meshes, {.weld_distance = 0}, context);
    const auto apart = accumulate(plan, meshes, context);
    plan = regroup(plan, meshes, {.weld_distance = 1e-3}, context);
    const auto joined = accumulate(plan, meshes, context);
    EXPECT_NE(apart[0].normals[0], apart[1].normals[0]);
    EXPECT_EQ(joined[0].normals[0], joined[1].normals[0]);
}

TEST(Regroup, OtherMeshesAreRefused) {
    Context context({.threads = 1});
    const std::vector<Shape> cube{make_cube()}, sphere{make_sphere(4, 3)};
    const AttributePlan plan = group(views(cube), {}, context);
    EXPECT_THROW(regroup(plan, views(sphere), {}, context), Error);
    EXPECT_THROW(regroup(plan, {}, {}, context), Error);
    EXPECT_THROW(regroup(plan, views(cube), {.crease_angle_rad = -1}, context), Error);
    EXPECT_THROW(regroup(plan, views(cube), {.normals = false}, context), Error) << "no normals to keep";
}

TEST(Regroup, NothingToGroup) {
    Context context({.threads = 1});
    const AttributePlan plan = group({}, {}, context);
    EXPECT_TRUE(accumulate(regroup(plan, {}, {.crease_angle_rad = 1}, context), {}, context).empty());
    const std::vector<Shape> one(1);
    const AttributePlan empty = group(views(one), {}, context);
    EXPECT_TRUE(accumulate(regroup(empty, views(one), {.crease_angle_rad = 1}, context), views(one), context)[0]
                    .normals.empty());
}

}  // namespace
}  // namespace rakelight::test
