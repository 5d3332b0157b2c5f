// SPDX-License-Identifier: Apache-2.0
// Which maps of a material are read alike, so that kernels find the place of their texels once.
#include "cpu_shading/material_views.h"

#include <gtest/gtest.h>

#include "cpu_shading/textures.h"
#include "support/scene_builder.h"

namespace rakelight::cpu_shading {
namespace {

ImageHandle gray(int width, int height) {
    return test::picture(test::rgb_pixels(width, height, [](int x, int y) { return std::array<int, 3>{x, y, 128}; }));
}

/// One square with a metallic-roughness material.
class Viewed {
public:
    Viewed() { scene.materials.emplace_back(); }
    Material& material() { return scene.materials[0]; }
    TextureUse map(int width, int height, Sampler sampler = {}) {
        return test::add_texture(scene, gray(width, height), sampler);
    }
    const MaterialView& view() {
        Mesh square = test::square_mesh(0);
        square.texcoords.push_back(square.texcoords[0]);
        test::add_object(scene, std::move(square));
        list = shading::make_draw_list(scene, cache, CpuTexturePacker(), context);
        views = make_material_views(list, cache);
        return views.materials[0];
    }
    bool shares(TextureRoleNumber role) { return (view().shared_maps >> role & 1u) != 0; }

    Scene scene;
    Context context;
    shading::TextureCache cache;
    shading::DrawList list;
    MaterialViews views;
};

TEST(MaterialViews, MapsOfOneSizeFilterAndPlaceShareTheBaseColorsTexels) {
    Viewed v;
    v.material().base_color_texture = v.map(16, 8);
    v.material().normal_texture = v.map(16, 8);
    v.material().metallic_roughness.texture = v.map(16, 8);
    v.material().emission = {1, 1, 1};
    v.material().emission_texture = v.map(8, 8);
    EXPECT_EQ(v.view().shared_maps, 1u << role_base_color | 1u << role_normal | 1u << role_metallic_roughness);
}

TEST(MaterialViews, AMapWithOtherCoordinatesWrappingOrFilterIsReadForItself) {
    for (const int what : {0, 1, 2, 3}) {
        Viewed v;
        v.material().base_color_texture = v.map(16, 16);
        Sampler sampler;
        if (what == 0) sampler.wrap_u = Wrap::clamp_to_edge;
        if (what == 1) sampler.magnify = Filter::nearest;
        v.material().normal_texture = v.map(16, 16, sampler);
        if (what == 2) v.material().normal_texture.transform.offset = {0.5f, 0};
        if (what == 3) v.material().normal_texture.texcoord_set = 1;
        EXPECT_FALSE(v.shares(role_normal)) << what;
    }
}

TEST(MaterialViews, AHeightMapIsReadAtLevelsOfItsOwn) {
    Viewed v;
    v.material().base_color_texture = v.material().height_texture = v.map(16, 16);
    EXPECT_FALSE(v.shares(role_height));
}

TEST(MaterialViews, WithoutABaseColorMapNothingIsShared) {
    Viewed v;
    v.material().normal_texture = v.material().metallic_roughness.texture = v.map(16, 16);
    EXPECT_EQ(v.view().shared_maps, 0u);
}

TEST(MaterialViews, AnOcclusionMapThatIsTheMetallicRoughnessMapIsReadOnce) {
    Viewed one;
    one.material().metallic_roughness.texture = one.material().occlusion_texture = one.map(16, 16);
    EXPECT_EQ(one.view().occlusion_in_metallic, 1);
    Viewed moved;
    moved.material().metallic_roughness.texture = moved.material().occlusion_texture = moved.map(16, 16);
    moved.material().occlusion_texture.transform.scale = {2, 2};
    EXPECT_EQ(moved.view().occlusion_in_metallic, 0);
    Viewed two;
    two.material().metallic_roughness.texture = two.map(16, 16);
    two.material().occlusion_texture = two.map(16, 16);
    EXPECT_EQ(two.view().occlusion_in_metallic, 0) << "pictures of two files may be equal; they are not compared";
    Viewed none;
    EXPECT_EQ(none.view().occlusion_in_metallic, 0);
}

}  // namespace
}  // namespace rakelight::cpu_shading
