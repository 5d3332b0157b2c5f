// SPDX-License-Identifier: Apache-2.0
// Lighting models of more parameters in the soft engine: the same bits everywhere, and pixels against closed forms.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>

#include "math/isa.h"
#include "unit/raster/busy_scene.h"
#include "unit/raster/drawn.h"
#include "unit/raster/facing_square.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

constexpr Lighting models[] = {Lighting::lambert, Lighting::oren_nayar, Lighting::oren_nayar_full, Lighting::ward,
                               Lighting::pbr};

/// busy_scene() with every layer, and tangents.
Scene layered_scene() {
    Scene scene = busy_scene();
    const TextureUse map = scene.materials[0].base_color_texture;
    MetallicRoughnessParameters& p = scene.materials[1].metallic_roughness;
    p.anisotropy = 0.7f, p.anisotropy_rotation_rad = 0.5f, p.anisotropy_texture = map;
    p.clearcoat = 0.8f, p.clearcoat_roughness = 0.3f, p.clearcoat_texture = p.clearcoat_normal_texture = map;
    p.sheen_color = {0.5f, 0.2f, 0.1f}, p.sheen_roughness = 0.4f, p.sheen_color_texture = map;
    p.specular_texture = p.specular_color_texture = map;
    scene.materials[0].sigma_rad = 0.4f;
    scene.materials[0].ward_alpha = vec2{0.1f, 0.4f};
    for (Mesh& mesh : scene.meshes) mesh.tangents = std::vector<vec4>(4, vec4{0.6f, 0.8f, 0, 1});
    return scene;
}

RenderSettings settings_for(Lighting lighting, Shading shading = Shading::phong) {
    RenderSettings s{.width = 150, .height = 100, .shading = shading, .lighting = lighting};
    s.multiple_scattering = true;
    return s;
}

TEST(LightingModels, EveryInstructionSetAndAnyThreadsGiveTheSameBits) {
    const Scene scene = layered_scene();
    for (const Lighting model : models)
        for (const Shading shading : {Shading::phong, Shading::gouraud, Shading::flat}) {
            setenv("RAKELIGHT_ISA", "scalar", 1);
            const Frame expected = draw(scene, busy_view(), settings_for(model, shading));
            for (const Isa isa : {Isa::sse2, Isa::avx2, Isa::avx512}) {
                if (!is_available(isa)) continue;
                setenv("RAKELIGHT_ISA", name(isa), 1);
                EXPECT_TRUE(same_bits(expected, draw(scene, busy_view(), settings_for(model, shading), 3)))
                    << int(model) << " in " << name(isa);
            }
            unsetenv("RAKELIGHT_ISA");
        }
}

TEST(LightingModels, AClearcoatsNormalMapDoesNothingOnAMeshWithoutItsCoordinates) {
    Scene scene = busy_scene();
    MetallicRoughnessParameters& p = scene.materials[1].metallic_roughness;
    p.clearcoat = 1, p.clearcoat_roughness = 0.2f;
    const auto drawn = [&](Scene s) { return draw(s, busy_view(), settings_for(Lighting::automatic)); };
    Scene with_map = scene;
    const auto tilted = [](int, int) { return std::array{250, 128, 160}; };
    with_map.materials[1].metallic_roughness.clearcoat_normal_texture =
        add_texture(with_map, picture(rgb_pixels(4, 4, tilted)));
    EXPECT_FALSE(same_bits(drawn(with_map), drawn(scene)));
    for (Scene* const s : {&scene, &with_map})
        for (Mesh& mesh : s->meshes) mesh.texcoords.clear();
    EXPECT_TRUE(same_bits(drawn(with_map), drawn(scene)));
}

TEST(LightingModels, PbrIsTheFormulaOfGltfWhereLightAndViewerFaceTheSurface) {
    // D V = 1 / (4 pi alpha^2); a light of color 1 has irradiance pi
    const double lobe = 1 / (4 * std::pow(0.5, 4));
    const vec4 plastic = middle(facing_square(metallic(0, 0.5f)), Lighting::pbr);
    EXPECT_NEAR(plastic.x, 0.96 * 0.5 + 0.04 * lobe, 2e-5);
    EXPECT_NEAR(plastic.y, 0.96 * 0.25 + 0.04 * lobe, 2e-5);
    const vec4 metal = middle(facing_square(metallic(1, 0.5f)), Lighting::pbr);
    EXPECT_NEAR(metal.x, 0.5 * lobe, 2e-5);
    EXPECT_NEAR(metal.z, 1 * lobe, 2e-5);
}

TEST(LightingModels, AmbientLightMeetsAWhiteMetalWithItsDirectionalAlbedo) {
    // roughness 1 from above: 1 - ln 2 of single scattering, all of it with what scatters between the facets
    const Scene scene = facing_square(metallic(1, 1, {1, 1, 1}), {1, 1, 1}, {0, 0, 0});
    EXPECT_NEAR(middle(scene, Lighting::pbr).x, 1 - std::log(2.0), 1e-3);
    EXPECT_NEAR(middle(scene, Lighting::pbr, true).x, 1, 2e-3);
}

TEST(LightingModels, DiffuseModelsShowMetalsInTheirBaseColor) {
    const vec4 by_lambert = middle(facing_square(metallic(1, 0)), Lighting::lambert);
    EXPECT_NEAR(by_lambert.x, 0.5, 1e-6);
    EXPECT_NEAR(by_lambert.z, 1, 1e-6);
    Material smooth = metallic(1, 0.8f);
    smooth.sigma_rad = 0.0f;
    EXPECT_EQ(middle(facing_square(smooth), Lighting::oren_nayar).x, by_lambert.x);
}

TEST(LightingModels, ATextbookHighlightKeepsItsCenterUnderWardAndPbr) {
    Material m = matte({0, 0, 0});
    m.classical.specular = {0.5f, 0.5f, 0.5f}, m.classical.shininess = 30;
    const Scene scene = facing_square(m);
    EXPECT_NEAR(middle(scene, Lighting::blinn_phong).x, 0.5, 1e-5);
    EXPECT_NEAR(middle(scene, Lighting::ward).x, 0.5, 1e-5);
    EXPECT_NEAR(middle(scene, Lighting::pbr).x, 0.5, 1e-5);
}

TEST(LightingModels, AClassicalMaterialWithoutHighlightHasNoneUnderPbrEither) {
    const Scene scene = facing_square(matte({0.5f, 0.5f, 0.5f}));
    EXPECT_NEAR(middle(scene, Lighting::pbr).x, 0.5, 1e-6);
}

TEST(LightingModels, FlatShadingHasThePhongPictureWhereLightAndViewerFaceTheSurface) {
    for (const Lighting model : models)
        for (const float metal : {0.0f, 1.0f}) {
            const Scene scene = facing_square(metallic(metal, 0.6f), {0.2f, 0.1f, 0.3f});
            const vec4 phong = middle(scene, model), flat = middle(scene, model, false, Shading::flat);
            EXPECT_NEAR(phong.x, flat.x, 1e-5) << int(model);
            EXPECT_NEAR(phong.z, flat.z, 1e-5) << int(model);
        }
}

TEST(LightingModels, AViewerAtInfinityMakesTheHighlightOfAFlatSquareEven) {
    Material m = matte({0, 0, 0});
    m.classical.specular = {1, 1, 1}, m.classical.shininess = 50;
    Scene scene = facing_square(m);
    Camera camera;
    camera.to_world = translation(dvec3{0, 0, 2});
    camera.vertical_fov_rad = 0.8;
    RenderSettings s{.width = 32, .height = 32};
    const Frame near = draw(scene, camera, s);
    s.viewer_at_infinity = true;
    const Frame far = draw(scene, camera, s);
    EXPECT_LT(pixel(near, 4, 4).x, 0.6f);
    EXPECT_NEAR(pixel(far, 4, 4).x, 1, 1e-5);
    EXPECT_EQ(pixel(far, 4, 4).x, pixel(far, 16, 16).x);
}

TEST(LightingModels, AnAnisotropicHighlightLiesAcrossTheTangentsThatAreWide) {
    Material m = metallic(1, 0.3f, {1, 1, 1});
    m.metallic_roughness.anisotropy = 1;
    Scene scene = facing_square(m);
    scene.meshes[0].tangents = std::vector<vec4>(4, vec4{1, 0, 0, 1});
    Camera camera;
    camera.to_world = translation(dvec3{0, 0, 2});
    camera.vertical_fov_rad = 0.8;
    const Frame f = draw(scene, camera, {.width = 32, .height = 32, .lighting = Lighting::pbr});
    EXPECT_GT(pixel(f, 28, 16).x, 5 * pixel(f, 16, 28).x);  // wide along x
    scene.materials[0].metallic_roughness.anisotropy_rotation_rad = float(pi / 2);
    const Frame turned = draw(scene, camera, {.width = 32, .height = 32, .lighting = Lighting::pbr});
    EXPECT_GT(pixel(turned, 16, 28).x, 5 * pixel(turned, 28, 16).x);
}

TEST(LightingModels, ChannelsOfLayeredMaterialsAddUpToTheirColor) {
    const Scene scene = layered_scene();
    RenderSettings s = settings_for(Lighting::pbr);
    s.channels = channels_lighting | channel_material;
    const Frame f = draw(scene, busy_view(), s);
    std::size_t seen = 0;
    for (std::size_t i = 0; i < f.color.size(); ++i) {
        if (f.material[i] != 1) continue;  // others are blended over
        const vec3 sum = f.ambient[i] + f.diffuse[i] + f.specular[i] + f.emission[i];
        if (std::fabs(sum.x - f.color[i].x) < 1e-3f * (1 + sum.x)) ++seen;
    }
    EXPECT_GT(seen, 200u);
}

}  // namespace
