// SPDX-License-Identifier: Apache-2.0
// Normals and groups by automatic creases.
#include <gtest/gtest.h>

#include <algorithm>

#include "unit/geometry/creases/hard_shapes.h"

namespace rakelight::test {
namespace {

AttributeOptions automatic() {
    AttributeOptions options;
    options.creases = Creasing::automatic;
    return options;
}

/// [deg] The largest angle between a corner's normal and its face, over the faces of one surface.
double largest_lean(const HardShape& made, const MeshAttributes& out, int surface) {
    double most = 0;
    for (std::size_t c = 0; c < made.shape.indices.size(); ++c)
        if (made.surface[c / 3] == surface)
            most = std::max(most, angle_between(normalize_or(edge_product(made.shape, c / 3), {}),
                                                cast<double>(corner_normal(made.shape, out, c))));
    return degrees(most);
}

TEST(AutomaticCreases, FlatFacesStayFlat) {
    const HardShape box = make_chamfered_box(0.1);
    const std::vector<MeshAttributes> out = compute({box.shape}, automatic());
    for (int surface = 0; surface < 26; ++surface) EXPECT_LT(largest_lean(box, out[0], surface), 1e-3);
    const HardShape nut = make_nut(0, 0.1);
    const std::vector<MeshAttributes> of_nut = compute({nut.shape}, automatic());
    for (int side = 0; side < 6; ++side) EXPECT_LT(largest_lean(nut, of_nut[0], side), 1e-3);
    EXPECT_GT(largest_lean(nut, of_nut[0], 50), 7);  // the hole is round: 15 degrees a side
}

TEST(AutomaticCreases, RegroupGivesWhatGroupGives) {
    Context context;
    const HardShape made = make_column(12, false);
    const std::vector<Shape> parts = cut_at_random(made.shape, 3, 1);
    const std::vector<AttributeMesh> meshes = views(parts);
    const AttributePlan by_angle = group(meshes, {}, context), by_rule = group(meshes, automatic(), context);
    const auto normals = [&](const AttributePlan& plan) {
        std::vector<std::vector<vec3>> out;
        for (const MeshAttributes& m : accumulate(plan, meshes, context)) out.push_back(m.normals);
        return out;
    };
    EXPECT_EQ(normals(regroup(by_angle, meshes, automatic(), context)), normals(by_rule));
    EXPECT_EQ(normals(regroup(by_rule, meshes, {}, context)), normals(by_angle));
    EXPECT_EQ(normals(regroup(by_rule, meshes, automatic(), context)), normals(by_rule));
}

TEST(AutomaticCreases, NormalsAreThoseOfTheCutModel) {
    for (const HardShape& made : all_shapes()) {
        const std::vector<MeshAttributes> whole = compute({made.shape}, automatic());
        std::map<std::pair<std::size_t, std::size_t>, vec3> expected;
        std::vector<std::pair<std::uint32_t, std::size_t>> from;  // part and its triangle, of each triangle
        std::mt19937 random(3);
        std::uint32_t counts[3] = {};
        for (std::size_t t = 0; t < made.surface.size(); ++t) {
            const std::uint32_t part = random() % 3;
            from.emplace_back(part, counts[part]++);
        }
        const std::vector<Shape> parts = cut(made.shape, 3, [&](std::size_t t) { return from[t].first; });
        const std::vector<MeshAttributes> out = compute(parts, automatic());
        for (std::size_t c = 0; c < made.shape.indices.size(); ++c) {
            const auto [part, triangle] = from[c / 3];
            EXPECT_LT(angle_between(corner_normal(made.shape, whole[0], c),
                                    corner_normal(parts[part], out[part], 3 * triangle + c % 3)),
                      1e-6);
        }
    }
}

TEST(AutomaticCreases, SmoothingGroupsAndOwnAnglesGoBefore) {
    HardShape made = make_column(6, true);
    Shape grouped = made.shape;
    grouped.kind = GroupKind::numbers;
    grouped.smoothing.assign(made.surface.size(), 1);
    const std::vector<MeshAttributes> smooth = compute({grouped}, automatic());
    EXPECT_TRUE(smooth[0].source_vertex.empty());
    AttributeMesh mesh = made.shape.view();
    Context context;
    mesh.crease_angle_rad = pi;
    EXPECT_TRUE(compute_attributes(std::span(&mesh, 1), automatic(), context)[0].source_vertex.empty());
    mesh.crease_angle_rad = 0;
    AttributeOptions flat;
    flat.crease_angle_rad = 0;
    const AttributeMesh plain = made.shape.view();
    EXPECT_EQ(compute_attributes(std::span(&mesh, 1), automatic(), context)[0].normals,
              compute_attributes(std::span(&plain, 1), flat, context)[0].normals);
}

TEST(AutomaticCreases, CrossingSheetsAndShellsStayApart) {
    Shape cross;
    cross.positions = {{0, 0, 0},  {0, 0, 1}, {1, 0, 1}, {1, 0, 0},  {-1, 0, 1},
                       {-1, 0, 0}, {0, 1, 1}, {0, 1, 0}, {0, -1, 1}, {0, -1, 0}};
    cross.indices = {0, 1, 2, 0, 2, 3, 1, 0, 5, 1, 5, 4, 0, 1, 6, 0, 6, 7, 1, 0, 9, 1, 9, 8};
    const std::vector<MeshAttributes> out = compute({cross}, automatic());
    for (std::size_t c = 0; c < cross.indices.size(); ++c)
        EXPECT_LT(
            angle_between(normalize_or(edge_product(cross, c / 3), {}), cast<double>(corner_normal(cross, out[0], c))),
            1e-6);
    Shape shell = make_sphere(24, 12);
    const std::vector<MeshAttributes> one = compute({shell}, automatic());
    const std::size_t count = shell.indices.size();
    for (std::size_t c = 0; c < count; c += 3)
        shell.indices.insert(shell.indices.end(), {shell.indices[c], shell.indices[c + 2], shell.indices[c + 1]});
    const std::vector<MeshAttributes> both = compute({shell}, automatic());
    for (std::size_t c = 0; c < count; ++c)
        EXPECT_LT(angle_between(corner_normal(shell, both[0], c), one[0].normals[output_vertex(shell, one[0], c)]),
                  1e-6);
}

TEST(AutomaticCreases, APoseKeepsTheCreases) {
    Context context;
    const HardShape made = make_column(12, false);
    AttributeMesh mesh = made.shape.view();
    const AttributePlan plan = group(std::span(&mesh, 1), automatic(), context);
    std::vector<vec3> bent = made.shape.positions;
    for (vec3& p : bent) p.x += 0.3f * p.z * p.z;
    mesh.positions = bent;
    const std::vector<MeshAttributes> posed = accumulate(plan, std::span(&mesh, 1), context);
    EXPECT_EQ(posed[0].source_vertex, compute({made.shape}, automatic())[0].source_vertex);
}

}  // namespace
}  // namespace rakelight::test
