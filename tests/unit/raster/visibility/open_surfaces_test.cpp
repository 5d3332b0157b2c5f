// SPDX-License-Identifier: Apache-2.0
// When a picture says that back faces of an open object were culled, and when it says nothing.
#include <gtest/gtest.h>

#include "engines/raster/raster_engine.h"
#include "support/scene_builder.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

/// A cube from -half to half, four vertices a side, of which the last `left_out` are not there; the last is on top.
Mesh box(int left_out, std::uint32_t material, float half = 0.5f) {
    constexpr std::uint32_t sides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 4, 6, 2},
                                           {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}};
    std::vector<vec3> positions;
    std::vector<std::uint32_t> indices;
    for (int s = 0; s < 6 - left_out; ++s) {
        const auto first = std::uint32_t(positions.size());
        for (const std::uint32_t c : sides[s])
            positions.push_back({c & 1 ? half : -half, c & 2 ? half : -half, c & 4 ? half : -half});
        for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) indices.push_back(first + k);
    }
    Mesh mesh;
    mesh.normals = std::vector<vec3>(positions.size(), vec3{0, 1, 0});
    mesh.positions = std::move(positions);
    mesh.indices = std::move(indices);
    mesh.material = material;
    return mesh;
}

Scene with_material(bool double_sided) {
    Scene scene;
    Material m;
    m.model = MaterialModel::unlit;
    m.double_sided = double_sided;
    scene.materials.push_back(m);
    return scene;
}

Scene box_scene(int left_out, bool double_sided = false) {
    Scene scene = with_material(double_sided);
    add_object(scene, box(left_out, 0));
    return scene;
}

std::vector<ReportEntry> remarks(const Scene& scene, Cull cull, int pictures = 1,
                                 Visibility visibility = Visibility::z_reversed, Window window = {}) {
    Context context;
    auto engine = raster::make_engine();
    engine->prepare(scene, context);
    RenderSettings s{.width = 32, .height = 32, .window = window, .cull = cull};
    s.visibility = visibility;
    for (int i = 0; i < pictures; ++i) {
        Frame frame;
        engine->render(flat_camera(), s, frame, context);
    }
    return context.report().entries();
}

TEST(OpenSurfaces, AnOpenBoxWithoutItsBackFacesIsWarnedOfWithItsBoundaryEdges) {
    const auto entries = remarks(box_scene(1), Cull::back);
    ASSERT_EQ(entries.size(), 1u);
    EXPECT_EQ(entries[0].remark, Remark::warning);
    EXPECT_EQ(entries[0].place, "node 0 'object 0'");
    EXPECT_EQ(entries[0].message,
              "back faces were culled of an open surface with 4 boundary edges: its inside is not shown");
}

TEST(OpenSurfaces, AClosedBoxIsNotWarnedOf) { EXPECT_TRUE(remarks(box_scene(0), Cull::back).empty()); }

TEST(OpenSurfaces, ABoxOfTwoMeshesThatCloseEachOtherIsNotWarnedOf) {
    Scene scene = box_scene(1);
    Mesh lid = box(0, 0);
    lid.indices = std::vector<std::uint32_t>(lid.indices.end() - 6, lid.indices.end());
    scene.meshes.push_back(std::move(lid));
    scene.nodes[0].meshes.push_back(1);
    EXPECT_TRUE(remarks(scene, Cull::back).empty());
    scene.nodes[0].meshes.pop_back();
    EXPECT_EQ(remarks(scene, Cull::back).size(), 1u);
}

TEST(OpenSurfaces, ASeamThatOnlyRoundingOpensIsNoBoundary) {
    Scene scene = box_scene(0);
    for (const float scale : {1 + 0x1p-23f, 1 + 0x1p-8f}) {
        std::vector<vec3> positions(scene.meshes[0].positions.begin(), scene.meshes[0].positions.end());
        for (std::size_t v = 20; v < 24; ++v) positions[v].x *= scale;  // the top
        scene.meshes[0].positions = std::move(positions);
        EXPECT_EQ(remarks(scene, Cull::back).size(), scale > 1.001f ? 1u : 0u);
    }
}

TEST(OpenSurfaces, WhatTheMaterialLeavesOutIsANote) {
    const auto entries = remarks(box_scene(1), Cull::automatic);
    ASSERT_EQ(entries.size(), 1u);
    EXPECT_EQ(entries[0].remark, Remark::note);
    const auto method = remarks(box_scene(1), Cull::automatic, 1, Visibility::back_face);
    ASSERT_EQ(method.size(), 1u);
    EXPECT_EQ(method[0].remark, Remark::note);
}

TEST(OpenSurfaces, NothingIsSaidWhereBackFacesAreDrawn) {
    EXPECT_TRUE(remarks(box_scene(1, true), Cull::automatic).empty());
    EXPECT_TRUE(remarks(box_scene(1), Cull::none).empty());
    EXPECT_TRUE(remarks(box_scene(1), Cull::front).empty());
}

TEST(OpenSurfaces, NothingIsSaidOfAnOpenObjectThatIsSeenFromItsFrontAlone) {
    Scene scene = with_material(false);
    add_object(scene, square_mesh(0));
    EXPECT_TRUE(remarks(scene, Cull::back).empty());
    scene.nodes[0].local.matrix = scaling(dvec3{1, -1, -1});  // half a turn about x
    EXPECT_EQ(remarks(scene, Cull::back).size(), 1u);
}

TEST(OpenSurfaces, NothingIsSaidWhereTheBackFacesAreOutsideOfTheWindow) {
    for (const int parts : {1, 30}) {  // one square a side, too large for the kernel; many small ones
        Scene scene = with_material(false);
        std::vector<vec3> positions;
        std::vector<std::uint32_t> indices;
        for (int i = 0; i < 2 * parts; ++i) {  // columns from left to right, those on the right turned away
            const float left = float(i) / float(parts) - 1, right = left + 1 / float(parts);
            const auto first = std::uint32_t(positions.size());
            positions.insert(positions.end(), {{left, -1, 0}, {right, -1, 0}, {right, 1, 0}, {left, 1, 0}});
            const std::uint32_t turn = i < parts ? 0 : 1;
            for (const std::uint32_t k : {0u, 1 + turn, 2 - turn, 0u, 2 + turn, 3 - turn}) indices.push_back(first + k);
        }
        Mesh mesh;
        mesh.normals = std::vector<vec3>(positions.size(), vec3{0, 0, 1});
        mesh.positions = std::move(positions);
        mesh.indices = std::move(indices);
        mesh.material = 0;
        add_object(scene, std::move(mesh));
        const auto in = [&](Window window) {
            return remarks(scene, Cull::back, 1, Visibility::z_reversed, window).size();
        };
        EXPECT_EQ(in({}), 1u) << parts;
        EXPECT_EQ(in({0, 0, 16, 32}), 0u) << parts;
        EXPECT_EQ(in({0, 0, 17, 32}), 1u) << parts;
        EXPECT_EQ(in({20, 3, 5, 5}), 1u) << parts;
    }
}

TEST(OpenSurfaces, OnePictureHasOneRemarkOnAllOpenObjects) {
    Scene scene = box_scene(0);
    for (int i = 1; i < 4; ++i) add_object(scene, box(i == 2 ? 1 : 2, 0, 0.2f));
    const auto entries = remarks(scene, Cull::back, 3);
    ASSERT_EQ(entries.size(), 1u);
    EXPECT_EQ(entries[0].place, "node 1 'object 1'");
    EXPECT_EQ(entries[0].message,
              "back faces were culled of an open surface with 8 boundary edges, and of 2 more objects: its inside is "
              "not shown");
    EXPECT_EQ(entries[0].count, 3u);  // pictures
}

TEST(OpenSurfaces, CountsOfTheSceneBeforeAreForgotten) {
    Context context;
    auto engine = raster::make_engine();
    for (const int left_out : {0, 1, 0}) {
        const Scene scene = box_scene(left_out);
        context.report().clear();
        engine->prepare(scene, context);
        Frame frame;
        engine->render(flat_camera(), {.width = 32, .height = 32, .cull = Cull::back}, frame, context);
        EXPECT_EQ(context.report().entries().size(), std::size_t(left_out));
    }
}

}  // namespace
