// SPDX-License-Identifier: Apache-2.0
// The picture of what is behind transmissive surfaces: its size, who is on it, where points lie on it.
#include "shading/behind.h"

#include <gtest/gtest.h>

#include "math/linear.h"
#include "support/scene_builder.h"
#include "unit/shading/fake_textures.h"

namespace rakelight::shading {
namespace {

Material glass() {
    Material m;
    m.metallic_roughness.metallic = 0;
    m.metallic_roughness.transmission = 1;
    return m;
}

DrawList list_of(const std::vector<Material>& materials) {
    Scene scene;
    scene.materials = materials;
    for (std::uint32_t m = 0; m < materials.size(); ++m) test::add_object(scene, test::square_mesh(m));
    Context context({.threads = 1});
    TextureCache textures;
    return make_draw_list(std::move(scene), textures, test::FakePacker(), context);
}

PictureCamera view_of_size(int width, int height, bool parallel = false) {
    Camera camera;
    camera.projection = parallel ? Projection::orthographic : Projection::perspective;
    camera.half_height = 2;
    camera.to_world = compose({1, 2, 3}, {0, 0.198669331, 0, 0.980066578}, {1, 1, 1});
    return make_picture_camera(camera, camera.to_world, {.width = width, .height = height});
}

TEST(Behind, SidesAreThePowersOfTwoNextToThePicturesButNotMoreThan2048) {
    const auto sides = [](int width, int height) {
        const PictureCamera behind = camera_behind(view_of_size(width, height));
        return std::pair(behind.width, behind.height);
    };
    EXPECT_EQ(sides(1280, 720), std::pair(1024, 512));
    EXPECT_EQ(sides(1920, 1080), std::pair(2048, 1024));
    EXPECT_EQ(sides(512, 1), std::pair(512, 1));
    EXPECT_EQ(sides(65536, 3000), std::pair(2048, 2048));
    EXPECT_EQ(sides(90, 91), std::pair(64, 128)) << "next by ratio";
}

TEST(Behind, IsOnlyNeededForSurfacesThatShowIt) {
    const RenderSettings s;
    EXPECT_FALSE(needs_behind(list_of({test::matte()}), s));
    const DrawList both = list_of({test::matte(), glass()});
    EXPECT_TRUE(needs_behind(both, s));
    EXPECT_FALSE(needs_behind(both, {.lighting = Lighting::blinn_phong})) << "no transmission but of pbr";
    EXPECT_FALSE(needs_behind(both, {.colors = false}));
    EXPECT_TRUE(is_behind(both, both.draws[0], s));
    EXPECT_FALSE(is_behind(both, both.draws[1], s));
    Material blended = test::matte();
    blended.alpha_mode = AlphaMode::blend;
    const DrawList veil = list_of({blended});
    EXPECT_FALSE(is_behind(veil, veil.draws[0], s));
}

TEST(Behind, PointsLieOnItAsOnThePicture) {
    for (const bool parallel : {false, true}) {
        const PictureCamera view = view_of_size(300, 200, parallel);
        const BehindFactors f = behind_factors(camera_behind(view));
        for (const dvec3 world : {dvec3{0, 0, -3}, dvec3{1.5, 2.5, -1}, dvec3{-2, 1, -9}}) {
            const dvec3 p = transform_point(view.world_to_eye, world), c = transform_point(view.world_to_camera, world);
            const auto row = [&p](const float(&r)[4]) {
                return double(r[0]) * p.x + double(r[1]) * p.y + double(r[2]) * p.z + double(r[3]);
            };
            const ClipVertex clip{float(c.x * view.scale_x), float(c.y * view.scale_y), parallel ? 1.0f : float(-c.z),
                                  float(-c.z)};
            const dvec2 pixel = view.screen(clip);
            EXPECT_NEAR(row(f.to_u) / row(f.to_w) * 300, pixel.x, 1e-3) << parallel;
            EXPECT_NEAR(row(f.to_v) / row(f.to_w) * 200, pixel.y, 1e-3) << parallel;
        }
        EXPECT_EQ(f.last_level, 8.0f);
    }
}

TEST(Behind, ThicknessesGrowWithTheirMesh) {
    Draw draw;
    draw.to_world = scaling(dvec3{2, 3, 4});
    EXPECT_FLOAT_EQ(thickness_scale(draw), 3);
}

}  // namespace
}  // namespace rakelight::shading
