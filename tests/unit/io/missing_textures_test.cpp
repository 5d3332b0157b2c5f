// SPDX-License-Identifier: Apache-2.0
// Textures that are missing, in every loader and in the writer: emission is none without its texture, all others count
// as white (docs/materials.md).
#include <cmath>

#include "io/gltf/write/glb_writer.h"
#include "io/import/scene_from_import.h"
#include "io/pictures/image_io.h"
#include "unit/io/gltf/gltf_support.h"
#include "unit/io/obj/obj_fixture.h"

namespace rakelight {
namespace {

using namespace test;
using Json = nlohmann::json;

constexpr const char* no_emission = "the emission texture is missing: there is no emission";

int times_said(Context& context, const std::string& message) {
    int times = 0;
    for (const ReportEntry& e : context.report().entries())
        if (e.message == message) times += int(e.count);
    return times;
}

/// A triangle of one material, whose textures are no files.
GltfFile textures_gone(const char* material) {
    GltfFile file;
    file.triangle()["material"] = 0;
    file.root["materials"] = {Json::parse(material)};
    file.root["textures"] = Json::parse(R"([{"source": 0}])");
    file.root["images"] = Json::parse(R"([{"uri": "gone.png"}])");
    return file;
}

TEST(MissingTextures, OfEmissionInGltfMeansNone) {
    Context context({.threads = 1});
    const Scene scene = textures_gone(R"({"emissiveFactor": [1, 1, 0], "emissiveTexture": {"index": 0},
        "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 4}}})")
                            .load(context);
    EXPECT_EQ(scene.materials[0].emission, (vec3{0, 0, 0}));
    EXPECT_FALSE(scene.materials[0].emission_texture);
    EXPECT_TRUE(is_said(context, Remark::dropped, no_emission));
}

TEST(MissingTextures, OfEmissionThatIsBlackAreNotSaidTwice) {
    Context context({.threads = 1});
    textures_gone(R"({"emissiveTexture": {"index": 0}})").load(context);
    EXPECT_FALSE(is_said(context, Remark::dropped, no_emission));
    EXPECT_TRUE(is_said(context, Remark::dropped, "emissiveTexture is left out"));
}

TEST(MissingTextures, EmissionWithoutAnyTextureStays) {
    Context context({.threads = 1});
    const Scene scene = textures_gone(R"({"emissiveFactor": [1, 1, 0]})").load(context);
    EXPECT_EQ(scene.materials[0].emission, (vec3{1, 1, 0}));
    EXPECT_EQ(times_said(context, no_emission), 0);
}

TEST(MissingTextures, OfAnyOtherRoleInGltfCountAsWhite) {
    Context context({.threads = 1});
    const Material m = textures_gone(R"({"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 1, 1],
        "baseColorTexture": {"index": 0}, "metallicFactor": 0.25, "roughnessFactor": 0.5,
        "metallicRoughnessTexture": {"index": 0}}, "occlusionTexture": {"index": 0}, "normalTexture": {"index": 0},
        "extensions": {"KHR_materials_specular": {"specularFactor": 0.5, "specularTexture": {"index": 0}},
        "KHR_materials_clearcoat": {"clearcoatFactor": 0.75, "clearcoatTexture": {"index": 0}}}})")
                           .load(context)
                           .materials[0];
    EXPECT_EQ(m.base_color, (vec4{0.5f, 0.25f, 1, 1}));
    EXPECT_EQ(m.metallic_roughness.metallic, 0.25f);
    EXPECT_EQ(m.metallic_roughness.roughness, 0.5f);
    EXPECT_EQ(m.metallic_roughness.specular, 0.5f);
    EXPECT_EQ(m.metallic_roughness.clearcoat, 0.75f);
    EXPECT_EQ(context.report().entries().size(), 1u);  // the file is named once
}

class MissingObjTextures : public io::obj_test::ObjFolder {
protected:
    Material material(const std::string& body) {
        write("a.mtl", "newmtl m\n" + body + "\n");
        return load("mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n").materials.at(0);
    }
};

TEST_F(MissingObjTextures, OfEmissionMeanNone) {
    const Material m = material("Ke 1 1 0\nmap_Ke gone.png");
    EXPECT_EQ(m.emission, (vec3{0, 0, 0}));
    ASSERT_TRUE(remark(no_emission));
    EXPECT_EQ(remark(no_emission)->remark, Remark::dropped);
    EXPECT_EQ(remark(no_emission)->place, "line 3");
    EXPECT_EQ(material("Ke 0 0 0\nmap_Ke gone.png").emission, (vec3{0, 0, 0}));
    EXPECT_FALSE(remark(no_emission));
    EXPECT_EQ(material("Ke 1 1 0").emission, (vec3{1, 1, 0}));
}

TEST_F(MissingObjTextures, GiveNoNumbersThatTheFileHasNot) {
    EXPECT_EQ(material("map_Ks gone.png").classical.specular, (vec3{0, 0, 0}));
    EXPECT_EQ(material("Ks 1 0 1\nmap_Ks gone.png").classical.specular, (vec3{1, 0, 1}));
    EXPECT_EQ(material("map_Kd gone.png").base_color, material("").base_color);
    EXPECT_EQ(material("Kd 1 0 1\nmap_Kd gone.png").base_color, (vec4{1, 0, 1, 1}));
    const MetallicRoughnessParameters p = material("Ns 30\nmap_Pr gone.png\nmap_Pm gone.png").metallic_roughness;
    EXPECT_EQ(p.metallic, 0);
    EXPECT_FLOAT_EQ(p.roughness, std::sqrt(0.25f));
    EXPECT_EQ(material("d 0.5\nmap_d gone.png").base_color.w, 0.5f);
    EXPECT_EQ(material("map_d gone.png").alpha_mode, AlphaMode::opaque);
}

Material imported(const vec3& emission, Context& context) {
    using namespace io::import_stream;
    Import import;
    import.document.surfaces.push_back({.name = "lamp", .has = Surface::has_emission, .emission = emission});
    import.document.surfaces[0].links.push_back({.path = "gone.png", .role = std::uint32_t(Role::emission)});
    Scene scene;
    io::detail::add_materials(import, "model.fbx", "fbx", false, scene, context);
    return scene.materials.at(0);
}

TEST(MissingTextures, OfEmissionInImportedFilesMeanNone) {
    Context context({.threads = 1}), black({.threads = 1});
    EXPECT_EQ(imported({1, 1, 0}, context).emission, (vec3{0, 0, 0}));
    EXPECT_EQ(times_said(context, no_emission), 1);
    EXPECT_EQ(imported({0, 0, 0}, black).emission, (vec3{0, 0, 0}));
    EXPECT_EQ(times_said(black, no_emission), 0);
}

/// The file was there when the model was loaded.
TEST(MissingTextures, OfEmissionAreWrittenAsNone) {
    Context context({.threads = 1});
    Scene scene = textures_gone(R"({"emissiveFactor": [1, 1, 0]})").load(context);
    const test::TemporaryFolder folder;
    scene.textures.push_back({"gone", io::image_from_file("gone", "", folder.file("gone.png")), {}});
    scene.materials[0].emission_texture.texture = 0;
    const std::string path = folder.file("out.glb");
    io::write_glb(scene, path, context);
    EXPECT_EQ(times_said(context, no_emission), 1);
    const Scene back = io::gltf_reader.read(path, {}, context);
    EXPECT_EQ(back.materials.at(0).emission, (vec3{0, 0, 0}));
}

}  // namespace
}  // namespace rakelight
