// SPDX-License-Identifier: Apache-2.0
// Which side is lit, of materials whose format says nothing about sides. The reference is the same mesh with a material
// whose format does: by winding alone.
#include <gtest/gtest.h>

#include "unit/geometry/folded.h"
#include "unit/raster/drawn.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

constexpr int side = 128;

Scene scene_of(const std::vector<Shape>& shapes, MaterialModel model) {
    Scene scene;
    Material m = matte();
    m.model = model;
    m.double_sided = true;
    m.metallic_roughness.metallic = 0;
    scene.materials = {m};
    for (const Shape& s : shapes) {
        Mesh mesh;
        mesh.material = 0;
        mesh.positions = s.positions;
        mesh.indices = s.indices;
        mesh.normals = s.normals;
        add_object(scene, mesh);
    }
    scene.lights = {directional({0.3, -0.4, -1})};
    return scene;
}

/// Near plane 0.1 m before the eye: from 0.25 m away it cuts triangles of the sheet.
Camera camera_at(double distance) {
    Camera camera = flat_camera(distance);
    camera.projection = Projection::perspective;
    camera.vertical_fov_rad = radians(60);
    camera.z_near = 0.1, camera.z_far = 100;
    return camera;
}

RenderSettings settings_of(Shading shading, Lighting lighting) {
    RenderSettings s{.width = side, .height = side};
    s.shading = shading;
    s.lighting = lighting;
    s.channels = channel_normal;
    return s;
}

}  // namespace

TEST(LitSide, AroundAFoldTheWindingSaysWhichSideIsSeen) {
    const std::vector<Shape> sheet = smoothed(in_parts(make_crumpled_sheet(4)), CornerWeight::uniform);
    int against = 0;
    for (const Shape& part : sheet) against += count_against_own(part);
    ASSERT_GT(against, 3);
    const Scene classical = scene_of(sheet, MaterialModel::classical),
                by_winding = scene_of(sheet, MaterialModel::metallic_roughness);
    for (const double distance : {3.0, 0.25, -3.0})
        for (const Lighting lighting :
             {Lighting::lambert, Lighting::oren_nayar}) {  // the plain kernel, and the full one
            const RenderSettings s = settings_of(Shading::phong, lighting);
            const Frame a = draw(classical, camera_at(distance), s), b = draw(by_winding, camera_at(distance), s);
            EXPECT_TRUE(same_bits(a.normal, b.normal)) << distance;
        }
}

TEST(LitSide, VerticesAreLitOnTheSideThatTheirTrianglesShow) {
    const std::vector<Shape> sheet = smoothed(in_parts(make_crumpled_sheet(4)), CornerWeight::uniform);
    const RenderSettings s = settings_of(Shading::gouraud, Lighting::lambert);
    for (const double distance : {3.0, 0.25}) {
        const Frame a = draw(scene_of(sheet, MaterialModel::classical), camera_at(distance), s),
                    b = draw(scene_of(sheet, MaterialModel::metallic_roughness), camera_at(distance), s);
        EXPECT_TRUE(same_bits(a.normal, b.normal));
        int lit = 0, differ = 0;
        for (std::size_t i = 0; i < a.color.size(); ++i) {
            lit += b.color[i].x > 1e-3f;
            differ += (a.color[i].x > 1e-3f) != (b.color[i].x > 1e-3f);
        }
        EXPECT_GT(lit, side * side / 4);
        EXPECT_EQ(differ, 0) << distance;
    }
}

TEST(LitSide, TrianglesWoundWronglyAreLitByTheNormalsOfTheirFile) {
    Shape sphere = make_sphere(32, 16);
    sphere.normals = sphere.positions;
    const Frame right = draw(scene_of({sphere}, MaterialModel::classical), camera_at(3),
                             settings_of(Shading::phong, Lighting::lambert));
    std::mt19937 random(8);
    for (std::size_t t = 0; t < sphere.indices.size(); t += 3)
        if (random() % 3 == 0) std::swap(sphere.indices[t + 1], sphere.indices[t + 2]);
    const Frame mixed = draw(scene_of({sphere}, MaterialModel::classical), camera_at(3),
                             settings_of(Shading::phong, Lighting::lambert));
    int seen = 0;
    for (std::size_t i = 0; i < right.normal.size(); ++i) {
        seen += right.color[i].w > 0;
        ASSERT_LT(length(mixed.normal[i] - right.normal[i]), 1e-5f) << i;
    }
    EXPECT_GT(seen, 1000);
}

TEST(LitSide, ClockwiseFrontsTurnNothingThatTheNormalsSay) {
    Shape sphere = make_sphere(32, 16);
    sphere.normals = sphere.positions;
    RenderSettings s = settings_of(Shading::phong, Lighting::lambert);
    const Scene scene = scene_of({sphere}, MaterialModel::classical);
    const Frame as_is = draw(scene, camera_at(3), s);
    s.front_face = FrontFace::clockwise;
    EXPECT_TRUE(same_bits(draw(scene, camera_at(3), s).normal, as_is.normal));
}
