// SPDX-License-Identifier: Apache-2.0
#include "io/obj/mtl_materials.h"

#include <rakelight/base/report.h>
#include <rakelight/scene/validate.h>

#include <cmath>

#include "io/obj/mtl_file.h"
#include "math/color.h"
#include "unit/io/obj/obj_fixture.h"

namespace rakelight::io {
namespace {

class ObjMaterials : public obj_test::ObjFolder {
protected:
    /// The materials of an MTL text, its first one used by a triangle.
    Scene with(const std::string& mtl, const std::string& name = "m") {
        write("a.mtl", mtl);
        Scene s = load("mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl " + name + "\nf 1 2 3\n");
        EXPECT_NO_THROW(validate(s));
        return s;
    }
    Material material(const std::string& body) { return with("newmtl m\n" + body + "\n").materials.at(0); }
    void picture(const std::string& name) { write(name, "not decoded on loading"); }
};

vec3 linear(float r, float g, float b) { return linear_from_srgb(vec3{r, g, b}); }

TEST_F(ObjMaterials, ClassicalValuesBecomeLinear) {
    const Material m = material("Ka 0.1 0.2 0.3\nKd 0.5 0.6 0.7\nKs 0.8\nNs 40\nKe 0.25 0 0\nillum 2\nNi 1.45");
    EXPECT_EQ(m.model, MaterialModel::classical);
    EXPECT_EQ(m.base_color.xyz(), linear(0.5f, 0.6f, 0.7f));
    EXPECT_EQ(m.classical.ambient, linear(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(m.classical.specular, linear(0.8f, 0.8f, 0.8f));
    EXPECT_EQ(m.classical.shininess, 40);
    EXPECT_EQ(m.emission, linear(0.25f, 0, 0));
    EXPECT_EQ(m.alpha_mode, AlphaMode::opaque);
    EXPECT_TRUE(remarks().empty());
}

TEST_F(ObjMaterials, WithoutKaTheAmbientColorIsKd) {
    EXPECT_EQ(material("Kd 0.5 0.6 0.7").classical.ambient, linear(0.5f, 0.6f, 0.7f));
    EXPECT_EQ(material("").base_color.xyz(), linear(0.8f, 0.8f, 0.8f));
}

TEST_F(ObjMaterials, VertexColorsAreNotMultipliedByAGrayThatNoFileGives) {
    const std::string colored = "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\n";
    write("m.mtl", "newmtl with\nKd 0.5 0.6 0.7\nnewmtl without\nKs 1 1 1\nnewmtl ambient\nKa 0.1 0.2 0.3\n");
    const auto of = [&](const std::string& use) { return load("mtllib m.mtl\n" + colored + use + "\nf 1 2 3\n"); };
    for (const char* use : {"", "usemtl without", "usemtl missing"}) {
        const Scene s = of(use);
        const Material& m = s.materials.at(s.meshes.at(0).material);
        EXPECT_EQ(m.base_color, (vec4{1, 1, 1, 1})) << use;
        EXPECT_EQ(m.classical.ambient, (vec3{1, 1, 1})) << use;
    }
    const Scene authored = of("usemtl with");
    EXPECT_EQ(authored.materials.at(0).base_color.xyz(), linear(0.5f, 0.6f, 0.7f));
    EXPECT_EQ(authored.materials.at(0).classical.ambient, linear(0.5f, 0.6f, 0.7f));
    const Scene ambient = of("usemtl ambient");
    EXPECT_EQ(ambient.materials.at(2).base_color.xyz(), (vec3{1, 1, 1}));
    EXPECT_EQ(ambient.materials.at(2).classical.ambient, linear(0.1f, 0.2f, 0.3f));
}

TEST_F(ObjMaterials, PartsWithoutVertexColorsKeepTheGrayOfAMaterialThatColoredPartsShare) {
    const Scene s = load(
        "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nv 0 0 1\nv 1 0 1\nv 0 1 1\no a\nf 1 2 3\no b\nf 4 5 6\n"
        "o c\nf 1 2 3\n");
    ASSERT_EQ(s.meshes.size(), 3u);
    ASSERT_EQ(s.materials.size(), 2u);
    EXPECT_EQ(s.materials.at(s.meshes[0].material).base_color, (vec4{1, 1, 1, 1}));
    EXPECT_EQ(s.materials.at(s.meshes[1].material).base_color.xyz(), linear(0.8f, 0.8f, 0.8f));
    EXPECT_EQ(s.meshes[2].material, s.meshes[0].material);
    EXPECT_EQ(s.materials[0].name, s.materials[1].name);
}

TEST_F(ObjMaterials, IlluminationModelsDecideTheTerms) {
    EXPECT_EQ(material("Ks 1 1 1\nillum 1").classical.specular, (vec3{0, 0, 0}));
    EXPECT_EQ(material("Ks 1 1 1\nillum 0").model, MaterialModel::unlit);
    EXPECT_EQ(material("Ks 1 1 1").classical.specular, (vec3{1, 1, 1}));
    material("illum 77");
    EXPECT_TRUE(remark("cannot be read"));
}

TEST_F(ObjMaterials, IlluminationModelsFrom3To7SayWhereRaysGoOn) {
    const auto of = [this](int model, const std::string& more = {}) {
        return material("Ks 1 1 1\nNi 1.5\nTf 0 0.5 1\nillum " + std::to_string(model) + "\n" + more).classical;
    };
    for (const int model : {0, 1, 2, 8, 9, 10}) {
        EXPECT_EQ(of(model).mirror, Mirror::none) << model;
        EXPECT_EQ(of(model).transmission, vec3{}) << model;
    }
    for (const int model : {3, 4, 6}) EXPECT_EQ(of(model).mirror, Mirror::constant) << model;
    for (const int model : {5, 7}) EXPECT_EQ(of(model).mirror, Mirror::fresnel) << model;
    for (const int model : {3, 5}) EXPECT_EQ(of(model).transmission, vec3{}) << model;
    for (const int model : {4, 6, 7}) EXPECT_EQ(of(model).transmission, linear(0, 0.5f, 1)) << model;
    for (const int model : {3, 4, 5}) EXPECT_EQ(of(model).refraction_index, 0) << model;
    for (const int model : {6, 7}) EXPECT_EQ(of(model).refraction_index, 1.5f) << model;
    EXPECT_EQ(of(6, "Ni 0").refraction_index, 0) << "means nothing";
    EXPECT_EQ(material("illum 4").classical.transmission, vec3{}) << "opaque, without Tf";
    EXPECT_EQ(material("illum 4\nd 0.25").classical.transmission, (vec3{1, 1, 1}));
    EXPECT_TRUE(remarks().empty());
}

TEST_F(ObjMaterials, SmallExponentsAndValuesOutOfRangeAreChanged) {
    const Material m = material("Ka 20 20 20\nKs 1 1 1\nNs 0");
    EXPECT_EQ(m.classical.ambient, (vec3{1, 1, 1}));
    EXPECT_EQ(m.classical.shininess, 1);
    EXPECT_EQ(m.classical.specular, (vec3{0, 0, 0})) << "Ns 0 beside a white Ks means no highlight";
    EXPECT_EQ(remark("outside 0..1")->remark, Remark::changed);
    EXPECT_EQ(remark("Ns below 1")->remark, Remark::changed);
}

TEST_F(ObjMaterials, EmissionKeepsItsStrengthOverOne) {
    const Material m = material("Ke 10 5 0");
    EXPECT_EQ(m.emission.x, 10);
    EXPECT_FLOAT_EQ(m.emission.y, 10 * linear_from_srgb(0.5f));
    EXPECT_TRUE(remarks().empty());
}

TEST_F(ObjMaterials, AlphaIsDElseOneMinusTr) {
    EXPECT_EQ(material("d 0.25").base_color.w, 0.25f);
    EXPECT_EQ(material("d 0.25").alpha_mode, AlphaMode::blend);
    EXPECT_EQ(material("Tr 0.25").base_color.w, 0.75f);
    EXPECT_EQ(material("d 1\nTr 1").alpha_mode, AlphaMode::opaque);
    EXPECT_EQ(material("d -halo 0.5").base_color.w, 0.5f);
    EXPECT_EQ(material("Tr 1").base_color.w, 1);
    EXPECT_EQ(remark("Tr 1")->remark, Remark::guessed);
}

TEST_F(ObjMaterials, BrokenNumbersKeepTheDefaults) {
    const Material m = material("Kd 1 nan 1\nKs 1 1\nNs x\nd 1e999\nKa spectral f.rfl\nKe 1,5 0 0");
    EXPECT_EQ(m.base_color.xyz(), linear(0.8f, 0.8f, 0.8f));
    EXPECT_EQ(m.base_color.w, 1);
    EXPECT_EQ(remark("cannot be read or is not finite")->place, "line 2");
    EXPECT_NE(remark("cannot be read or is not finite")->message.find("(5 times)"), std::string::npos);
    EXPECT_EQ(remark("spectral")->remark, Remark::dropped);
}

TEST_F(ObjMaterials, UndefinedAndAbsentMaterialsAreLightGray) {
    const Scene s = load("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nusemtl nope\nf 1 2 3\nusemtl nope\nf 1 2 3\n");
    ASSERT_EQ(s.materials.size(), 2u);
    EXPECT_EQ(s.materials[0].name, "default");
    EXPECT_EQ(s.materials[1].name, "nope");
    EXPECT_EQ(s.materials[1].base_color.xyz(), linear(0.8f, 0.8f, 0.8f));
    EXPECT_EQ(s.materials[1].model, MaterialModel::classical);
    ASSERT_EQ(remarks().size(), 1u);
    EXPECT_EQ(remark("'nope' is not defined")->place, "line 5");
}

TEST_F(ObjMaterials, NamesMayHoldBlanks) {
    const Scene s =
        with("newmtl  Material name with many, many  spaces \nKd 1 0 0\n", "Material name with many, many  spaces");
    EXPECT_EQ(s.materials.size(), 1u);
    EXPECT_TRUE(remarks().empty());
}

TEST_F(ObjMaterials, AMaterialDefinedTwiceKeepsItsFirstDefinition) {
    EXPECT_EQ(with("newmtl m\nKd 1 0 0\nnewmtl m\nKd 0 1 0\n").materials.at(0).base_color.x, 1);
    EXPECT_EQ(remark("defined more than once")->place, "line 3");
}

TEST_F(ObjMaterials, TexturesOfAllRolesAreFound) {
    for (const char* name : {"d.png", "s.png", "e.png", "o.png", "b.png", "n.png"}) picture(name);
    const Scene s = with(
        "newmtl m\nmap_Kd d.png\nmap_Ka d.png\nmap_Ks s.png\nmap_Ke e.png\nmap_d o.png\nmap_Bump -bm 0.3 b.png\nnorm "
        "n.png\n");
    const Material& m = s.materials.at(0);
    const auto name = [&](const TextureUse& use) { return use ? s.textures.at(use.texture).name : ""; };
    EXPECT_EQ(name(m.base_color_texture), "d.png");
    EXPECT_EQ(m.base_color.xyz(), (vec3{1, 1, 1}));
    EXPECT_EQ(name(m.classical.specular_texture), "s.png");
    EXPECT_EQ(m.classical.specular, (vec3{1, 1, 1}));
    EXPECT_EQ(name(m.emission_texture), "e.png");
    EXPECT_EQ(m.emission, (vec3{1, 1, 1}));
    EXPECT_EQ(name(m.opacity_texture), "o.png");
    EXPECT_EQ(m.alpha_mode, AlphaMode::blend);
    EXPECT_EQ(name(m.height_texture), "b.png");
    EXPECT_EQ(m.height_scale, 0.3f);
    EXPECT_EQ(name(m.normal_texture), "n.png");
    EXPECT_TRUE(remarks().empty());
}

TEST_F(ObjMaterials, TexturesAreSharedByFileAndClamping) {
    picture("t.png");
    const Scene s = with("newmtl m\nmap_Kd t.png\nnewmtl n\nmap_Kd ./t.png\nmap_Ks -clamp on t.png\n");
    ASSERT_EQ(s.textures.size(), 2u);
    EXPECT_EQ(s.textures[0].image, s.textures[1].image);
    EXPECT_EQ(s.textures[1].sampler.wrap_u, Wrap::clamp_to_edge);
}

TEST_F(ObjMaterials, ABumpMapThatIsCalledNormalIsOne) {
    picture("brick_n.png");
    const Material m = material("map_bump -bm 0.5 brick_n.png");
    EXPECT_TRUE(m.normal_texture);
    EXPECT_FALSE(m.height_texture);
    EXPECT_EQ(m.normal_scale, 0.5f);
    EXPECT_EQ(remark("normal map by its name")->remark, Remark::guessed);
}

TEST(ObjNormalMapName, IsDecidedByWords) {
    using obj::is_normal_map_name;
    for (const char* yes : {"a/Brick_Normal.png", "bricknormal2.jpg", "x_NRM.tga", "wall-n.png", "wall_n01.png",
                            "norm_wall.png", "a.nor.png"})
        EXPECT_TRUE(is_normal_map_name(yes)) << yes;
    for (const char* no :
         {"brick.png", "enormous_height.png", "normal/height.png", "stone.png", "n.png", "bump_sn.png", "", "."})
        EXPECT_FALSE(is_normal_map_name(no)) << no;
}

TEST_F(ObjMaterials, DispIsTheHeightMapWhereNoBumpMapIs) {
    picture("h.png");
    picture("b.png");
    EXPECT_EQ(material("disp -mm 0 0.25 h.png").height_scale, 0.25f);
    EXPECT_TRUE(material("disp h.png\nbump b.png").height_texture);
    EXPECT_EQ(remark("disp is left out")->remark, Remark::dropped);
}

TEST_F(ObjMaterials, AlphaOfTheColorMapServesWhenMapDNamesIt) {
    picture("leaf.png");
    const Material m = material("map_Kd leaf.png\nmap_d leaf.png");
    EXPECT_FALSE(m.opacity_texture);
    EXPECT_EQ(m.alpha_mode, AlphaMode::blend);
    EXPECT_TRUE(remark("map_d names the file of map_Kd"));
}

TEST_F(ObjMaterials, OffsetAndScaleAreTurnedToVDown) {
    picture("t.png");
    const Material m = material("map_Kd -s 2 4 1 -o 0.25 0.5 t.png");
    const TextureTransform t = m.base_color_texture.transform;
    EXPECT_EQ(t.scale, (vec2{2, 4}));
    EXPECT_EQ(t.offset.x, 0.25f);
    const float v_up = 0.375f;  // of a vertex in the file; here it is 1 - v_up
    EXPECT_FLOAT_EQ(t.offset.y + t.scale.y * (1 - v_up), 1 - (0.5f + 4 * v_up));
}

TEST_F(ObjMaterials, OptionsStandBeforeNamesWithBlanks) {
    using obj::parse_map;
    obj::Remarks remarks("x");
    const auto parse = [&](const std::string& text) { return parse_map(text, 0, text.size(), 1, remarks); };
    const auto map = parse(
        " -blendu on -blendv off -boost 2 -mm 0.1 2 -o 1 2 3 -s 1 -t 0 0 0 -texres 512 -clamp on -bm 2 -imfchan l -cc "
        "off -type sphere bump 01.png\t");
    ASSERT_TRUE(map);
    EXPECT_EQ(map->file, "bump 01.png");
    EXPECT_EQ(map->bump_multiplier, 2);
    EXPECT_EQ(map->gain, 2);
    EXPECT_EQ(map->offset, (vec2{1, 2}));
    EXPECT_EQ(map->scale, (vec2{1, 1}));
    EXPECT_TRUE(map->is_clamped);
    EXPECT_EQ(parse("-o 0.5 01.png")->file, "01.png");
    EXPECT_EQ(parse("\"my file.png\"")->file, "my file.png");
    EXPECT_EQ(parse("-strange.png")->file, "-strange.png");
    EXPECT_EQ(parse("tex #1.png")->file, "tex #1.png");
    const auto trailing = parse("a b.png -bm 0.25 ");
    EXPECT_EQ(trailing->file, "a b.png");
    EXPECT_EQ(trailing->bump_multiplier, 0.25);
    EXPECT_FALSE(parse("  "));
    EXPECT_FALSE(parse("-bm 1"));
    EXPECT_FALSE(parse("\"\""));
    EXPECT_EQ(parse("-s nan inf a.png")->scale, (vec2{1, 1}));
    EXPECT_GT(remarks.count(obj::Issue::mtl_option_hint), 0u);
}

TEST_F(ObjMaterials, PhysicalValuesMakeAMetallicRoughnessMaterial) {
    picture("orm.png");
    picture("r.png");
    picture("m.png");
    const Material m = material("Kd 1 1 1\nPr 0.25\nPm 0.75\nNi 1.4");
    EXPECT_EQ(m.model, MaterialModel::metallic_roughness);
    EXPECT_EQ(m.metallic_roughness.roughness, 0.25f);
    EXPECT_EQ(m.metallic_roughness.metallic, 0.75f);
    EXPECT_EQ(m.metallic_roughness.ior, 1.4f);
    const Material packed = material("map_Pr orm.png\nmap_Pm orm.png");
    EXPECT_TRUE(packed.metallic_roughness.texture);
    EXPECT_EQ(packed.metallic_roughness.metallic, 1);
    EXPECT_TRUE(remarks().empty());
    EXPECT_EQ(material("map_Pr r.png").metallic_roughness.metallic, 0);
    EXPECT_EQ(material("map_Pr r.png\nmap_Pm m.png").metallic_roughness.metallic, 0);
    EXPECT_EQ(remark("map_Pm is left out")->remark, Remark::dropped);
    EXPECT_FLOAT_EQ(material("Pm 1\nNs 30").metallic_roughness.roughness, std::sqrt(0.25f));
}

TEST_F(ObjMaterials, AMissingTextureIsOneWarningAndLeftOut) {
    const Material m = material("map_Kd gone.png\nmap_Ks gone.png\nmap_Ns other.png");
    EXPECT_FALSE(m.base_color_texture);
    EXPECT_EQ(remark("'gone.png'")->remark, Remark::warning);
    EXPECT_EQ(remark("'gone.png'")->place, "line 2");
    EXPECT_EQ(remark("that the material model does not have")->remark, Remark::dropped);
    EXPECT_EQ(remarks().size(), 2u);
}

TEST_F(ObjMaterials, FilesAreFoundInOtherCaseAndByTheirBareName) {
    picture("Textures/Wood.PNG");
    picture("stone.png");
    EXPECT_TRUE(material("map_Kd textures\\wood.png").base_color_texture);
    EXPECT_EQ(remark("was found as 'Wood.PNG'")->remark, Remark::guessed);
    EXPECT_TRUE(material("map_Kd C:\\Users\\someone\\maps\\Stone.png").base_color_texture);
    EXPECT_EQ(remark("was found as 'stone.png'")->remark, Remark::guessed);
    EXPECT_TRUE(material("map_Kd /home/someone/stone.png").base_color_texture);
}

TEST_F(ObjMaterials, AnMtlFileInAnotherFolderHasItsTexturesThere) {
    write("folder/deep.mtl", "newmtl m\nmap_Kd t.png\nmap_Ks ../up.png\nmap_Ke top.png\n");
    picture("folder/t.png");
    picture("up.png");
    picture("top.png");
    const Scene s = load("mtllib folder/deep.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
    EXPECT_TRUE(s.materials.at(0).base_color_texture);
    EXPECT_TRUE(s.materials.at(0).classical.specular_texture);
    EXPECT_TRUE(s.materials.at(0).emission_texture);
    EXPECT_TRUE(remarks().empty());
}

TEST_F(ObjMaterials, SeveralLibrariesAndNamesWithBlanksAreRead) {
    write("a b.mtl", "newmtl one\nKd 1 0 0\n");
    write("c.mtl", "newmtl two\n");
    write("d.mtl", "newmtl three\n");
    const Scene s = load(
        "mtllib a b.mtl\nmtllib c.mtl d.mtl gone.mtl\nmtllib ./c.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl three\nf 1 2 "
        "3\n");
    EXPECT_EQ(s.materials.size(), 3u);
    EXPECT_EQ(remarks().size(), 1u);
    EXPECT_EQ(remark("'gone.mtl'")->remark, Remark::warning);
}

TEST_F(ObjMaterials, NothingOutsideTheFolderIsOpened) {
    write("inner/model.obj", "mtllib ../outer.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
    write("outer.mtl", "newmtl m\nKd 1 0 0\n");
    Context context;
    const Scene s = obj_reader.read((folder_ / "inner/model.obj").string(), {}, context);
    EXPECT_EQ(s.materials.at(0).base_color.xyz(), linear(0.8f, 0.8f, 0.8f));
    ASSERT_FALSE(context.report().entries().empty());
    const ReportEntry remark = context.report().entries()[0];
    EXPECT_EQ(remark.message,
              "material file '../outer.mtl' lies outside the model's folder; default materials are used instead "
              "('allow-outside' permits it)");
    EXPECT_EQ(remark.settings, std::vector<std::string>{"allow-outside"});
    Context allowed;
    EXPECT_EQ(obj_reader.read((folder_ / "inner/model.obj").string(), {.allow_outside = true}, allowed)
                  .materials.at(0)
                  .base_color.x,
              1);
}

TEST_F(ObjMaterials, ThousandsOfMissingNamesAreSummedUp) {
    std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (int i = 0; i < 5000; ++i) text += "usemtl u" + std::to_string(i) + "\nf 1 2 3\n";
    EXPECT_EQ(load(text).materials.size(), 5000u);
    EXPECT_EQ(remarks().size(), 201u);
    EXPECT_TRUE(remark("4800 more"));
}

TEST_F(ObjMaterials, SearchesInVainAreBounded) {
    write("there.mtl", "newmtl m\n");
    obj::ReferenceFinder finder((folder_ / "model.obj").string(), false);
    EXPECT_TRUE(finder.find("There.MTL"));
    for (int i = 0; i < 1999; ++i) EXPECT_FALSE(finder.find("gone" + std::to_string(i)));
    EXPECT_TRUE(finder.find("there.mtl"));
    EXPECT_FALSE(finder.find("gone"));
    EXPECT_FALSE(finder.find("there.mtl"));
}

}  // namespace
}  // namespace rakelight::io
