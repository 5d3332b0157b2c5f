// SPDX-License-Identifier: Apache-2.0
// Materials, textures, images and samplers of glTF.
#include "unit/io/gltf/gltf_support.h"

namespace rakelight {
namespace {

using namespace test;
using Json = nlohmann::json;

TEST(GltfMaterials, DefaultsAreThoseOfTheSpecification) {
    GltfFile file;
    file.triangle()["material"] = 0;
    file.root["materials"] = {Json::object()};
    const Scene scene = file.load();
    ASSERT_EQ(scene.materials.size(), 1u);
    const Material& m = scene.materials[0];
    EXPECT_EQ(m.name, "material 0");
    EXPECT_EQ(m.model, MaterialModel::metallic_roughness);
    EXPECT_EQ(m.base_color, (vec4{1, 1, 1, 1}));
    EXPECT_EQ(m.metallic_roughness.metallic, 1);
    EXPECT_EQ(m.metallic_roughness.roughness, 1);
    EXPECT_EQ(m.alpha_cutoff, 0.5f);
    EXPECT_FALSE(m.double_sided);
}

TEST(GltfMaterials, ExtensionsAreRead) {
    GltfFile file;
    file.triangle()["material"] = 0;
    file.root["materials"] = Json::parse(
        R"([{"emissiveFactor": [0.5, 0.25, 0], "alphaMode": "MASK", "alphaCutoff": 0.75, "doubleSided": true,
        "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 8}, "KHR_materials_ior": {"ior": 1.25},
        "KHR_materials_specular": {"specularFactor": 0.5, "specularColorFactor": [1, 2, 3]}, "KHR_materials_anisotropy": {"anisotropyStrength": 0.5, "anisotropyRotation": 1},
        "KHR_materials_unlit": {}}}])");
    const Material m = file.load().materials[0];
    EXPECT_EQ(m.emission, (vec3{4, 2, 0}));
    EXPECT_EQ(m.alpha_mode, AlphaMode::mask);
    EXPECT_EQ(m.alpha_cutoff, 0.75f);
    EXPECT_TRUE(m.double_sided);
    EXPECT_EQ(m.model, MaterialModel::unlit);
    EXPECT_EQ(m.metallic_roughness.ior, 1.25f);
    EXPECT_EQ(m.metallic_roughness.specular, 0.5f);
    EXPECT_EQ(m.metallic_roughness.specular_color, (vec3{1, 2, 3}));
    EXPECT_EQ(m.metallic_roughness.anisotropy, 0.5f);
    EXPECT_EQ(m.metallic_roughness.anisotropy_rotation_rad, 1);
}

TEST(GltfMaterials, ClearcoatAndSheenAreRead) {
    GltfFile file;
    file.triangle()["material"] = 0;
    file.root["materials"] = Json::parse(
        R"([{"extensions": {"KHR_materials_clearcoat": {"clearcoatFactor": 0.75, "clearcoatRoughnessFactor": 0.25},
        "KHR_materials_sheen": {"sheenColorFactor": [0.5, 0.25, 3], "sheenRoughnessFactor": 0.125}}}])");
    const MetallicRoughnessParameters p = file.load().materials[0].metallic_roughness;
    EXPECT_EQ(p.clearcoat, 0.75f);
    EXPECT_EQ(p.clearcoat_roughness, 0.25f);
    EXPECT_EQ(p.sheen_color, (vec3{0.5f, 0.25f, 1}));
    EXPECT_EQ(p.sheen_roughness, 0.125f);
}

TEST(GltfMaterials, TransmissionAndVolumeAreRead) {
    GltfFile file;
    file.triangle()["material"] = 0;
    file.root["materials"] = Json::parse(R"([{"extensions": {"KHR_materials_transmission": {"transmissionFactor": 0.75},
            "KHR_materials_volume": {"thicknessFactor": 2, "attenuationDistance": 0.5, "attenuationColor": [0.25, 0.5, 1]}}}])");
    file.root["extensionsUsed"] = {"KHR_materials_transmission", "KHR_materials_volume"};
    file.root["extensionsRequired"] = {"KHR_materials_transmission", "KHR_materials_volume"};
    Context context({.threads = 1});
    const MetallicRoughnessParameters p = file.load(context).materials.at(0).metallic_roughness;
    EXPECT_EQ(p.transmission, 0.75f);
    EXPECT_EQ(p.thickness, 2);
    EXPECT_EQ(p.attenuation_distance, 0.5f);
    EXPECT_EQ(p.attenuation_color, (vec3{0.25f, 0.5f, 1}));
    EXPECT_TRUE(context.report().entries().empty());
}

TEST(GltfMaterials, SpecularGlossinessKeepsItsReflectance) {
    GltfFile file;
    file.triangle()["material"] = 0;
    file.root["materials"] = Json::parse(R"([{"extensions": {"KHR_materials_pbrSpecularGlossiness":
        {"diffuseFactor": [0.5, 0.5, 0.5, 1], "specularFactor": [0.2, 0.1, 0.04], "glossinessFactor": 0.75}}}])");
    Context context({.threads = 1});
    const Material m = file.load(context).materials[0];
    EXPECT_EQ(m.base_color, (vec4{0.5f, 0.5f, 0.5f, 1}));
    EXPECT_EQ(m.metallic_roughness.metallic, 0);
    EXPECT_EQ(m.metallic_roughness.roughness, 0.25f);
    EXPECT_NEAR(m.metallic_roughness.specular_color.x * 0.04, 0.2, 1e-6);
    EXPECT_TRUE(is_said(context, Remark::changed, "specular-glossiness"));
}

TEST(GltfMaterials, ValuesOutOfRangeAreMovedAndSaid) {
    GltfFile file;
    file.triangle()["material"] = 0;
    file.root["materials"] =
        Json::parse(R"([{"pbrMetallicRoughness": {"metallicFactor": 7, "baseColorFactor": [1.00000012, -3, 1, 1]}}])");
    Context context({.threads = 1});
    const Material m = file.load(context).materials[0];
    EXPECT_EQ(m.metallic_roughness.metallic, 1);
    EXPECT_EQ(m.base_color, (vec4{1, 0, 1, 1}));
    EXPECT_TRUE(is_said(context, Remark::changed, "metallicFactor"));
}

GltfFile textured(const char* textures, const char* images, const char* info = R"({"index": 0})") {
    GltfFile file;
    file.triangle()["material"] = 0;
    file.root["materials"] = {{{"normalTexture", Json::parse(info)}}};
    file.root["textures"] = Json::parse(textures);
    file.root["images"] = Json::parse(images);
    return file;
}

constexpr const char* embedded_image = R"([{"uri": "data:image/png;base64,AAAA"}])";

TEST(GltfTextures, ACoordinateSetBeyondTheLastLeavesTheTextureOut) {
    for (const char* use : {R"({"index": 0, "texCoord": 8})", R"({"index": 0, "texCoord": 4294967296})",
                            R"({"index": 0, "extensions": {"KHR_texture_transform": {"texCoord": 4294967297}}})"}) {
        Context context({.threads = 1});
        GltfFile file = textured(R"([{"source": 0}])", embedded_image, use);
        EXPECT_FALSE(file.load(context).materials[0].normal_texture) << use;
        EXPECT_TRUE(is_said(context, Remark::dropped, "is more than 7")) << use;
    }
}

TEST(GltfTextures, TransformsAndTheirCoordinateSetAreRead) {
    GltfFile file = textured(
        R"([{"source": 0}])", embedded_image,
        R"({"index": 0, "texCoord": 1, "scale": 0.5, "extensions": {"KHR_texture_transform": {"offset": [1, 2], "rotation": 0.5, "scale": [3, 4], "texCoord": 2}}})");
    const Scene scene = file.load();
    const TextureUse& use = scene.materials[0].normal_texture;
    ASSERT_TRUE(use);
    EXPECT_EQ(use.texcoord_set, 2u);
    EXPECT_EQ(use.transform.offset, (vec2{1, 2}));
    EXPECT_EQ(use.transform.scale, (vec2{3, 4}));
    EXPECT_EQ(use.transform.rotation_rad, 0.5f);
    EXPECT_EQ(scene.materials[0].normal_scale, 0.5f);
    ASSERT_TRUE(scene.textures[0].image->bytes);
    EXPECT_EQ(scene.textures[0].image->bytes->size(), 3u);
}

TEST(GltfTextures, SamplersHaveTheDefaultsAndTheWordsOfTheSpecification) {
    GltfFile file = textured(R"([{"source": 0}])", embedded_image);
    EXPECT_EQ(file.load().textures[0].sampler, Sampler{});
    file.root["textures"][0]["sampler"] = 0;
    file.root["samplers"] = Json::parse(R"([{"wrapS": 33071, "wrapT": 33648, "magFilter": 9728, "minFilter": 9985}])");
    const Sampler expected{Wrap::clamp_to_edge, Wrap::mirrored_repeat, Filter::nearest, Filter::linear,
                           MipFilter::nearest};
    EXPECT_EQ(file.load().textures[0].sampler, expected);
}

TEST(GltfTextures, WebpIsPreferredAndBasisIsNotSupported) {
    GltfFile webp = textured(R"([{"source": 0, "extensions": {"EXT_texture_webp": {"source": 1}}}])",
                             R"([{"uri": "data:,a"}, {"uri": "data:image/webp,bcd", "name": "webp"}])");
    EXPECT_EQ(webp.load().textures[0].image->name, "webp");
    GltfFile basis = textured(R"([{"extensions": {"KHR_texture_basisu": {"source": 0}}}])", embedded_image);
    Context context({.threads = 1});
    const Scene scene = basis.load(context);
    EXPECT_FALSE(scene.materials[0].normal_texture);
    EXPECT_TRUE(is_said(context, Remark::dropped, "KHR_texture_basisu"));
}

TEST(GltfTextures, ReferencesThatCannotBeUsedAreLeftOut) {
    for (const char* uri : {"../secret.png", "/etc/passwd", "http://example.org/x.png", "file:///etc/passwd",
                            "missing.png", ".", "", "data:image/png;base64,@@@@"}) {
        GltfFile file = textured(R"([{"source": 0}])", "[{}]");
        file.root["images"][0]["uri"] = uri;
        Context context({.threads = 1});
        const Scene scene = file.load(context);
        EXPECT_FALSE(scene.materials[0].normal_texture) << uri;
        EXPECT_TRUE(scene.textures.empty()) << uri;
        EXPECT_TRUE(is_said(context, Remark::dropped, "normalTexture is left out")) << uri;
    }
}

TEST(GltfTextures, ImagesOfOneFileOrOneViewAreOnePicture) {
    const TemporaryFolder folder;
    folder.write("a.png", "x");
    GltfFile file = textured(R"([{"source": 0}, {"source": 1}, {"source": 2}, {"source": 3}])",
                             R"([{"uri": "a.png", "name": "first"}, {"uri": "%61.png", "name": "second"}, {}, {}])");
    const int view = file.view(std::vector<std::uint8_t>(100, 7));
    for (const std::size_t i : {2, 3}) file.root["images"][i] = {{"bufferView", view}, {"mimeType", "image/png"}};
    auto& material = file.root["materials"][0];
    material["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 1}};
    material["occlusionTexture"] = {{"index", 2}};
    material["emissiveTexture"] = {{"index", 3}};
    folder.write("data.bin", file.data);
    Context context({.threads = 1});
    const Scene scene = io::gltf_reader.read(folder.write("model.gltf", file.text()), {}, context);
    const Material& m = scene.materials[0];
    const auto image_of = [&](const TextureUse& use) { return scene.textures.at(use.texture).image; };
    EXPECT_EQ(image_of(m.normal_texture), image_of(m.base_color_texture));
    EXPECT_EQ(image_of(m.occlusion_texture), image_of(m.emission_texture));
    EXPECT_NE(image_of(m.normal_texture), image_of(m.occlusion_texture));
}

TEST(GltfTextures, PercentEncodedNamesAreFound) {
    const TemporaryFolder folder;
    folder.write("two words.png", "x");
    GltfFile file = textured(R"([{"source": 0}])", R"([{"uri": "two%20words.png"}])");
    folder.write("data.bin", file.data);
    Context context({.threads = 1});
    const Scene scene = io::gltf_reader.read(folder.write("model.gltf", file.text()), {}, context);
    ASSERT_TRUE(scene.materials[0].normal_texture);
    EXPECT_TRUE(scene.textures[0].image->path.ends_with("two words.png"));
}

}  // namespace
}  // namespace rakelight
