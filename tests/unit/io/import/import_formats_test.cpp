// SPDX-License-Identifier: Apache-2.0
// Small files of our own through the real helper: formats without an asset, odd names, textures, limits.
#include <numbers>

#include "io/import/collada_cameras.h"
#include "io/import/scene_from_import.h"
#include "io/import/texture_finder.h"
#include "io/import/texture_placement.h"
#include "math/linear.h"
#include "scene/drawn_vertices.h"
#include "support/thrown_error.h"
#include "unit/io/import/import_support.h"

namespace rakelight::io::import_test {
namespace {

using ImportFormats = ImportTest;

std::string x_file(const std::string& texture) {
    return "xof 0303txt 0032\n"
           "Mesh quad {\n 4;\n 0.0;0.0;0.0;,\n 1.0;0.0;0.0;,\n 1.0;1.0;0.0;,\n 0.0;1.0;0.0;;\n 2;\n 3;0,2,1;,\n "
           "3;0,3,2;;\n"  // clockwise from -Z, left-handed
           " MeshNormals {\n 1;\n 0.0;0.0;-1.0;;\n 2;\n 3;0,0,0;,\n 3;0,0,0;;\n }\n"
           " MeshTextureCoords {\n 4;\n 0.0;0.25;,\n 1.0;0.25;,\n 1.0;1.0;,\n 0.0;1.0;;\n }\n"
           " MeshMaterialList {\n 1;\n 2;\n 0,\n 0;\n Material red {\n 0.5;0.25;0.0;1.0;;\n 20.0;\n "
           "0.5;0.5;0.5;;\n "
           "0.0;0.0;0.0;;\n" +
           (texture.empty() ? std::string() : " TextureFilename { \"" + texture + "\"; }\n") + " }\n }\n}\n";
}

TEST_F(ImportFormats, NamesThatLookLikeOptionsAreNames) {
    const auto here = std::filesystem::current_path();
    write("--memory.x", x_file(""));
    write("-", x_file(""));
    std::filesystem::current_path(folder_.path());
    const Outcome outcome = read_import("--memory.x");
    std::filesystem::current_path(here);
    EXPECT_TRUE(outcome.scene) << outcome.what();
}

TEST_F(ImportFormats, NamesWithSpacesQuotesAndUmlautsAreNames) {
    const Outcome outcome = read_import(write("a b/it's \"\xC3\xA4\" $(x).x", x_file("")));
    EXPECT_TRUE(outcome.scene) << outcome.what();
}

TEST_F(ImportFormats, DirectXFilesKeepNormalsColorsAndCoordinates) {
    const Outcome outcome = read_import(write("quad.x", x_file("")));
    ASSERT_TRUE(outcome.scene) << outcome.what();
    const Mesh& mesh = outcome.scene->meshes.at(0);
    EXPECT_EQ(mesh.triangle_count(), 2u);
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    ASSERT_EQ(mesh.texcoords.size(), 1u);
    float least = 2;
    for (const vec2& uv : mesh.texcoords[0]) least = std::min(least, uv.y);
    EXPECT_FLOAT_EQ(least, 0.25f);  // X counts v downwards, as we do
    const std::vector<Corner> corners = corners_of(*outcome.scene);
    const dvec3 face = cross(corners[1].position - corners[0].position, corners[2].position - corners[0].position);
    EXPECT_GT(dot(face, corners[0].normal), 0) << "winding and normal disagree after the change of hands";
    const Material& m = outcome.scene->materials.at(mesh.material);
    EXPECT_EQ(m.model, MaterialModel::classical);
    EXPECT_NEAR(m.base_color.x, 0.214f, 1e-3f);  // 0.5 as a display value
    EXPECT_NEAR(m.classical.shininess, 20, 1e-4);
}

TEST_F(ImportFormats, ATextureIsFoundBesideTheModelWhateverItsPathAndCase) {
    write("Skin.PNG", "not decoded here");
    const Outcome outcome = read_import(write("quad.x", x_file("C:\\\\art\\\\skin.png")));
    ASSERT_TRUE(outcome.scene) << outcome.what();
    ASSERT_EQ(outcome.scene->textures.size(), 1u);
    EXPECT_EQ(std::filesystem::path(outcome.scene->textures[0].image->path).filename(), "Skin.PNG");
}

TEST_F(ImportFormats, AMissingTextureIsAWarning) {
    const Outcome outcome = read_import(write("quad.x", x_file("nowhere.png")));
    ASSERT_TRUE(outcome.scene) << outcome.what();
    EXPECT_TRUE(outcome.scene->textures.empty());
    EXPECT_TRUE(outcome.says("nowhere.png"));
}

TEST_F(ImportFormats, ATextureOutsideTheFolderIsNotTaken) {
    write("secret.png", "x");
    write("model/other.txt", "x");
    const std::string model = write("model/quad.x", x_file("../secret.png"));
    EXPECT_EQ(find_texture_file(model, "../secret.png", false), std::nullopt);
    EXPECT_NE(find_texture_file(model, "../secret.png", true), std::nullopt);
    EXPECT_EQ(find_texture_file(model, "", false), std::nullopt);
    EXPECT_EQ(find_texture_file(model, "..", false), std::nullopt);
    const Outcome outcome = read_import(model);
    ASSERT_TRUE(outcome.scene) << outcome.what();
    EXPECT_TRUE(outcome.scene->textures.empty());
}

TEST_F(ImportFormats, ColladaUnitAndAxisAreHonored) {
    const auto dae = [](const std::string& asset) {
        return "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<COLLADA "
               "xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\"><asset>" +
               asset +
               "</asset><library_geometries><geometry id=\"g\"><mesh><source id=\"p\"><float_array id=\"pa\" "
               "count=\"9\">0 0 0 1 0 0 0 0 1</float_array>"
               "<technique_common><accessor source=\"#pa\" count=\"3\" stride=\"3\"><param name=\"X\" "
               "type=\"float\"/><param name=\"Y\" type=\"float\"/><param name=\"Z\" "
               "type=\"float\"/></accessor></technique_common></source>"
               "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices><triangles "
               "count=\"1\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>0 1 "
               "2</p></triangles></mesh></geometry></library_geometries>"
               "<library_visual_scenes><visual_scene id=\"s\"><node id=\"n\"><instance_geometry "
               "url=\"#g\"/></node></visual_scene></library_visual_scenes><scene><instance_visual_scene "
               "url=\"#s\"/></scene></COLLADA>";
    };
    const Outcome up = read_import(write("y.dae", dae("<unit meter=\"2\"/><up_axis>Y_UP</up_axis>")));
    ASSERT_TRUE(up.scene) << up.what();
    EXPECT_NEAR(world_bounds(*up.scene).high.z, 2, 1e-6);
    const Outcome z = read_import(write("z.dae", dae("<unit meter=\"0.01\"/><up_axis>Z_UP</up_axis>")));
    ASSERT_TRUE(z.scene) << z.what();
    EXPECT_NEAR(world_bounds(*z.scene).high.y, 0.01, 1e-7);
    EXPECT_NEAR(world_bounds(*z.scene).high.x, 0.01, 1e-7);
    EXPECT_TRUE(z.scene->meshes[0].normals.empty());
}

TEST_F(ImportFormats, MemoryBeyondTheLimitIsOneClearError) {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "the helper's address space has no limit";
#endif
    constexpr int triangles = 20000;
    std::string big = "xof 0303txt 0032\nMesh big {\n 3;\n 0.0;0.0;0.0;,\n 1.0;0.0;0.0;,\n 0.0;1.0;0.0;;\n " +
                      std::to_string(triangles) + ";\n";
    for (int i = 0; i < triangles; ++i) big += i + 1 < triangles ? " 3;0,1,2;,\n" : " 3;0,1,2;;\n";
    const Outcome outcome = read_import(write("big.x", big + "}\n"), {}, {.threads = 1, .max_memory = 600000});
    ASSERT_TRUE(outcome.error);
    EXPECT_EQ(outcome.error->code(), ErrorCode::bad_file) << outcome.what();
}

std::map<std::string, ColladaOptics> cameras_of(std::string_view text) {
    return collada_cameras(std::as_bytes(std::span(text)));
}

TEST(ImportColladaCameras, OpticsAreFoundByNode) {
    const auto cameras = cameras_of(
        "<COLLADA><library_cameras><camera id='c1'><optics><technique_common><perspective><xfov sid='x'> 60 "
        "</xfov><aspect_ratio>2</aspect_ratio>"
        "<znear>0.5</znear></perspective></technique_common></optics></camera><camera "
        "id=\"c2\"><optics><orthographic><ymag>3</ymag></orthographic>"
        "</optics></camera></library_cameras><!-- <camera id='c3'> --><node id='n1' name='eye'><instance_camera "
        "url='#c1'/></node><node name='side'>"
        "<node id='n2'/><instance_camera url='#c2'></instance_camera></node><node id='lost'><instance_camera "
        "url='#none'/></node></COLLADA>");
    ASSERT_EQ(cameras.size(), 3u);
    EXPECT_EQ(cameras.at("n1").xfov_deg, 60.0);
    EXPECT_EQ(cameras.at("eye").znear, 0.5);
    EXPECT_EQ(cameras.at("side").ymag, 3.0);
    std::vector<import_stream::View> views(3);
    views[0].name = "eye";
    views[1].name = "side";
    views[2].name = "unknown";
    complete_views(cameras, views);
    EXPECT_NEAR(views[0].horizontal_fov_rad, std::numbers::pi / 3, 1e-9);
    EXPECT_EQ(views[0].aspect, 2);
    EXPECT_NEAR(views[1].half_width, 4, 1e-12);
    EXPECT_EQ(views[2].horizontal_fov_rad, 0);
    EXPECT_TRUE(cameras_of("<COLLADA><camera/><node/><instance_camera url='#a'/></COLLADA>").empty());
    for (const char* broken : {"", "<camera id='a' <node <<< '"})
        EXPECT_EQ(rakelight::test::error_of([&] { (void)cameras_of(broken); }).code(), ErrorCode::bad_file);
}

TEST(ImportAxes, TheFilesAxesBecomeOurs) {
    import_stream::AxisSystem z_up{2, 1, 1, -1, 0, 1, 0.01};
    const dmat4 m = detail::to_our_axes(z_up);
    const dvec3 up = transform_point(m, dvec3{0, 0, 1}), front = transform_point(m, dvec3{0, -1, 0}),
                side = transform_point(m, dvec3{1, 0, 0});
    EXPECT_EQ(up, (dvec3{0, 0.01, 0}));
    EXPECT_EQ(front, (dvec3{0, 0, 0.01}));
    EXPECT_EQ(side, (dvec3{0.01, 0, 0}));
    import_stream::AxisSystem nonsense{1, 1, 1, 1, 1, 1, 0};
    EXPECT_EQ(detail::to_our_axes(nonsense), dmat4{});
}

vec2 applied(const TextureTransform& t, vec2 uv) {  // KHR_texture_transform, by its specification
    const float c = std::cos(t.rotation_rad), s = std::sin(t.rotation_rad), u = uv.x * t.scale.x, v = uv.y * t.scale.y;
    return {t.offset.x + c * u + s * v, t.offset.y - s * u + c * v};
}

TEST(ImportTexturePlacement, TransformAndMapAgree) {
    import_stream::TextureLink link;
    link.offset = {0.0f, 0.9f};
    link.scale = {1, 2};
    link.rotation_rad = -1.2566f;
    link.placement = std::uint32_t(import_stream::Placement::max);
    const TextureAffine map = placement_of(link);
    const auto transform = as_transform(map);
    ASSERT_TRUE(transform);
    for (const vec2 uv : {vec2{0, 0}, vec2{1, 0}, vec2{0.3f, 0.7f}}) {
        const vec2 got = applied(*transform, uv);
        EXPECT_NEAR(got.x, map.a * uv.x + map.b * uv.y + map.c, 1e-5);
        EXPECT_NEAR(got.y, map.d * uv.x + map.e * uv.y + map.f, 1e-5);
    }
}

TEST(ImportTexturePlacement, MaxMovesThePictureByItsOffset) {
    import_stream::TextureLink link;
    link.offset = {0.25f, 0.5f};
    link.placement = std::uint32_t(import_stream::Placement::max);
    const TextureAffine map = placement_of(link);  // v-up (0.75, 1) shows the picture's (0.5, 0.5)
    EXPECT_NEAR(map.a * 0.75 + map.b * 0.0 + map.c, 0.5, 1e-12);
    EXPECT_NEAR(map.d * 0.75 + map.e * 0.0 + map.f, 0.5, 1e-12);
}

TEST(ImportTexturePlacement, ScaleThenMoveKeepsTheBottomWhereItWas) {
    import_stream::TextureLink link;
    link.offset = {0.5f, 0.25f};
    link.scale = {2, 4};
    const TextureAffine map =
        placement_of(link);  // v-up (0, 0) goes to (0.5, 0.25), that is v-down (0, 1) to (0.5, 0.75)
    EXPECT_NEAR(map.a * 0 + map.b * 1 + map.c, 0.5, 1e-12);
    EXPECT_NEAR(map.d * 0 + map.e * 1 + map.f, 0.75, 1e-12);
}

TEST(ImportTexturePlacement, MirroredScaleStaysATransformAndAShearIsNone) {
    import_stream::TextureLink mirrored;
    mirrored.scale = {-1, 1};
    const auto transform = as_transform(placement_of(mirrored));
    ASSERT_TRUE(transform);
    EXPECT_NEAR(applied(*transform, {1, 0}).x, -1, 1e-6);
    import_stream::TextureLink sheared;
    sheared.scale = {1, 2};
    sheared.rotation_rad = 0.5f;
    EXPECT_TRUE(as_transform(placement_of(sheared)));  // scaled first, then turned: no shear
    EXPECT_FALSE(as_transform({1, 0.5, 0, 0, 1, 0}));
}

}  // namespace
}  // namespace rakelight::io::import_test
