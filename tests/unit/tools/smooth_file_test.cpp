// SPDX-License-Identifier: Apache-2.0
// Small files made for the purpose: OBJ line by line, written anew as GLB and PLY, what is refused, JSON.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstring>

#include <rakelight/tools/rows.h>

#include "io/gltf/write/glb_writer.h"
#include "smooth_file_support.h"
#include "tools/smooth/smooth_file_scene.h"
#include "world/placed_in_world.h"

namespace rakelight {
namespace {

using namespace test;
using Json = nlohmann::json;

constexpr const char* two_quads =
    "# two quads that meet at a right angle\r\n"
    "mtllib none.mtl\r\n"
    "v 0 0 0 # a comment\r\n"
    "v 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nvn 0 1 0\r\n"
    "o first\r\nusemtl a\r\n"
    "f 1/ 2// \\\r\n  3//1   4   # the first\r\n"
    "v 0 0 -1\r\nv 0 1 -1\r\no second\r\ng part\r\n"
    "f -6 -3 -1 -2\r\nf 1 2 99//1\r\nl 1 2\r\n";

TEST(SmoothFile, ObjLinesWithContinuationRelativeIndicesAndFaultyFacesAreRewrittenInPlace) {
    const TemporaryFolder folder;
    const fs::path file = folder / "quads.obj";
    write(file, two_quads);
    Context context;
    SmoothFileOptions options = anew;
    options.attributes.crease_angle_rad = pi;
    const SmoothedFile result = smooth_file(file.string(), file.string(), options, context);
    EXPECT_TRUE(result.changed);
    const std::string text = bytes_of(file);
    EXPECT_NE(text.find("f 1//"), std::string::npos) << text;
    EXPECT_NE(text.find("\\\r\n  3//"), std::string::npos) << text;
    EXPECT_NE(text.find("   # the first\r\n"), std::string::npos) << text;
    EXPECT_NE(text.find("f -6//-"), std::string::npos) << text;  // relative stays relative
    EXPECT_NE(text.find("f 1 2 99\r\nl 1 2\r\n"), std::string::npos) << text;
    EXPECT_EQ(text.find("vn 0 1 0"), std::string::npos) << text;
    EXPECT_LT(text.find("vn "), text.find("o first")) << text;  // where data stands, before the faces
    const std::size_t second = text.find("vn ", text.find("v 0 1 -1"));
    EXPECT_LT(second, text.find("o second")) << text;
    // the border is continuous
    const Scene scene = load(file.string(), {}, context);
    const Mesh &a = scene.meshes[0], &b = scene.meshes[1];
    int shared = 0;
    for (std::size_t i = 0; i < a.positions.size(); ++i)
        for (std::size_t k = 0; k < b.positions.size(); ++k)
            if (a.positions[i] == b.positions[k]) {
                EXPECT_EQ(a.normals[i], b.normals[k]);
                ++shared;
            }
    EXPECT_EQ(shared, 2);
    EXPECT_FALSE(smooth_file(file.string(), file.string(), options, context).changed);
    EXPECT_EQ(bytes_of(file), text);
}

TEST(SmoothFile, FreeFormSurfacesNeverNameNormalsThatAreGone) {
    const TemporaryFolder folder;
    const fs::path file = folder / "surface.obj";
    const std::string surface =
        "cstype bezier\ndeg 1 1\nsurf 0.0 1 0 1.0 1/1/3 -3/1/-2 \\\n 3/1 4 # control points\nend\n";
    write(file,
          "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvn 0 1 0\nvn 1 0 0\nvn 0 1 1\nf 1//1 2//2 3//3\n" + surface);
    Context context;
    EXPECT_TRUE(smooth_file(file.string(), file.string(), anew, context).changed);
    const std::string text = bytes_of(file);
    EXPECT_NE(text.find("surf 0.0 1 0 1.0 1/1 -3/1 \\\n 3/1 4 # control points\nend\n"), std::string::npos) << text;
    EXPECT_TRUE(is_said(context, Remark::dropped, "2 references to normals")) << text;
}

TEST(SmoothFile, PlyAndGlbOfAnObjHaveTheSameNormals) {
    const TemporaryFolder out;
    const fs::path file = out / "quads.obj";
    write(file, two_quads);
    Context context;
    SmoothFileOptions options = anew;
    options.attributes.crease_angle_rad = pi;
    smooth_file(file.string(), (out / "a.glb").string(), options, context);
    const Scene wanted = smooth_for_file(load(file.string(), {}, context), options, context).scene;
    const Scene got = load((out / "a.glb").string(), {}, context);
    expect_attributes(wanted, got);
    EXPECT_FALSE(smooth_file((out / "a.glb").string(), (out / "b.glb").string(), options, context).changed);
    smooth_file(file.string(), (out / "a.ply").string(), options, context);
    const std::string ply = bytes_of(out / "a.ply");
    EXPECT_NE(ply.find("element vertex 8\n"), std::string::npos);
    EXPECT_NE(ply.find("element face 4\n"), std::string::npos);
    const std::size_t data = ply.find("end_header\n") + 11;
    ASSERT_EQ(ply.size(), data + 8 * 24 + 4 * 13);
    vec3 first_normal;
    std::memcpy(&first_normal, ply.data() + data + 12, 12);
    EXPECT_EQ(first_normal, wanted.meshes[0].normals[0]);
}

/// One triangle; x of its first vertex is a float whose lowest byte is `byte`.
std::string triangle_from(unsigned byte) {
    const std::uint32_t bits = 0x3F800000u + byte;
    float x = 0;
    std::memcpy(&x, &bits, 4);
    char line[64];
    std::snprintf(line, sizeof line, "v %.9g 0 0\n", double(x));
    return std::string(line) + "v 3 0 0\nv 0 1 0\nf 1 2 3\n";
}

TEST(SmoothFile, PlyDataNeverBeginsWithWhiteSpaceWhichReadersSkip) {
    if (!use_import_helper()) GTEST_SKIP() << "built without the import helper";
    const TemporaryFolder out;
    for (const unsigned byte : {0u, 8u, 9u, 10u, 11u, 12u, 13u, 14u, 31u, 32u, 33u, 255u}) {
        SCOPED_TRACE(byte);
        write(out / "a.obj", triangle_from(byte));
        Context context;
        smooth_file((out / "a.obj").string(), (out / "a.ply").string(), anew, context);
        const std::string ply = bytes_of(out / "a.ply");
        EXPECT_EQ(ply.find("pad") != std::string::npos, (byte >= 9 && byte <= 13) || byte == 32);
        const std::size_t data = ply.find("end_header\n") + 11;
        EXPECT_EQ(std::string("\t\n\v\f\r ").find(ply[data]), std::string::npos);
        const Scene wanted = load((out / "a.obj").string(), {}, context),
                    got = load((out / "a.ply").string(), {}, context);
        ASSERT_EQ(got.meshes.size(), 1u);
        expect_same(wanted.meshes[0].positions, got.meshes[0].positions, "positions");
        EXPECT_FALSE(smooth_file((out / "a.ply").string(), (out / "b.ply").string(), anew, context).changed);
        EXPECT_EQ(ply, bytes_of(out / "b.ply"));
    }
}

/// A fold of two placements that meet only to rounding.
TEST(SmoothFile, PlyIsSmoothWherePartsMeetThroughDifferentMatrices) {
    if (!use_import_helper()) GTEST_SKIP() << "built without the import helper";
    const TemporaryFolder out;
    const double c = std::cos(0.7), s = std::sin(0.7);
    Scene scene;
    for (const bool is_turned : {false, true}) {
        Mesh mesh;  // a fold along y, its ridge at x = 0.3, z = 0.1; the second half in axes turned about y
        std::vector<vec3> positions;
        for (const dvec3 p : {dvec3{0.3, 0, 0.1}, {0.3, 1, 0.1}, {is_turned ? 1.3 : -0.7, 0, 0}})
            positions.push_back(is_turned ? vec3{float(c * p.x - s * p.z), float(p.y), float(s * p.x + c * p.z)}
                                          : vec3{float(p.x), float(p.y), float(p.z)});
        mesh.positions = positions;
        mesh.indices = is_turned ? std::vector<std::uint32_t>{0, 2, 1} : std::vector<std::uint32_t>{0, 1, 2};
        Node node;
        node.meshes = {std::uint32_t(scene.meshes.size())};
        if (is_turned) node.local.matrix = dmat4{{{c, 0, -s, 0}, {0, 1, 0, 0}, {s, 0, c, 0}, {0, 0, 0, 1}}};
        scene.meshes.push_back(mesh);
        scene.nodes.push_back(node);
    }
    Context context;
    io::write_glb(scene, (out / "a.glb").string(), context);
    smooth_file((out / "a.glb").string(), (out / "a.ply").string(), anew, context);
    const Scene got = load((out / "a.ply").string(), {}, context);
    const Mesh& mesh = got.meshes.at(0);
    const auto at = [&](std::size_t corner) { return mesh.normals[mesh.indices[corner]]; };
    const auto place = [&](std::size_t corner) { return mesh.positions[mesh.indices[corner]]; };
    EXPECT_FALSE(place(0) == place(3) && place(1) == place(5)) << "the parts meet exactly: nothing is proven";
    EXPECT_EQ(at(0), at(3));
    EXPECT_EQ(at(1), at(5));
    EXPECT_FALSE(at(0) == at(2));
    EXPECT_FALSE(smooth_file((out / "a.ply").string(), (out / "b.ply").string(), anew, context).changed);
}

/// An OBJ model with an MTL file in a folder of its own, and pictures here and there.
struct ModelWithMaterials {
    const TemporaryFolder dir;
    const fs::path model = dir / "from" / "a.obj", to = dir / "to";
    ModelWithMaterials() {
        fs::create_directories(dir / "from" / "mats" / "deep");
        fs::create_directories(to);
        write(model, "mtllib mats/My Colors.mtl\r\nmtllib gone.mtl\r\n" + std::string(two_quads));
        write(dir / "from" / "mats" / "My Colors.mtl",
              "newmtl a\nmap_Kd -s 2 2 2 deep/Wood.PNG\nmap_Ns shine.tga\nmap_Ks none.png\nrefl -type sphere "
              "../sky.hdr\n");
        write(dir / "from" / "mats" / "deep" / "wood.png", "not a picture, and nobody looks");
        write(dir / "from" / "mats" / "shine.tga", "shine");
        write(dir / "from" / "sky.hdr", "sky");
    }
    SmoothedFile run(const char* name, Context& context, bool allow_outside = false) const {
        SmoothFileOptions options = anew;
        options.load.allow_outside = allow_outside;
        return smooth_file(model.string(), (to / name).string(), options, context);
    }
};

TEST(SmoothFile, ObjInAnotherFolderGetsItsMaterialsAndPictures) {
    const ModelWithMaterials files;
    Context context;
    files.run("b.obj", context);
    for (const char* name : {"mats/My Colors.mtl", "mats/deep/wood.png", "mats/shine.tga", "sky.hdr"})
        EXPECT_TRUE(!bytes_of(files.to / name).empty() &&
                    bytes_of(files.to / name) == bytes_of(files.dir / "from" / name))
            << name;
    const Scene scene = load((files.to / "b.obj").string(), {}, context);
    ASSERT_FALSE(scene.materials.empty());
    EXPECT_EQ(scene.materials[0].name, "a");
    EXPECT_EQ(scene.textures.size(), 1u);
    files.run("c.obj", context);  // what is there with the same bytes stays
}

TEST(SmoothFile, ObjInAnotherFolderNeverReplacesADifferentFile) {
    const ModelWithMaterials files;
    write(files.to / "sky.hdr", "my own sky");
    Context context;
    try {
        files.run("b.obj", context);
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::failed);
        EXPECT_NE(error.reason().find("sky.hdr"), std::string::npos);
    }
    EXPECT_EQ(bytes_of(files.to / "sky.hdr"), "my own sky");
    EXPECT_FALSE(fs::exists(files.to / "mats"));  // nothing was copied
    EXPECT_FALSE(fs::exists(files.to / "b.obj"));
}

TEST(SmoothFile, MaterialsOutsideTheModelsFolderAreNotCopiedAndItIsSaid) {
    const ModelWithMaterials files;
    write(files.dir / "outer.mtl", "newmtl a\nmap_Kd from/sky.hdr\n");
    write(files.model, "mtllib ../outer.mtl\n" + std::string(two_quads));
    Context context;
    files.run("b.obj", context, true);
    EXPECT_TRUE(is_said(context, Remark::warning, "'outer.mtl' is not copied"));
    EXPECT_TRUE(fs::exists(files.to / "b.obj"));
    EXPECT_FALSE(fs::exists(files.to / "outer.mtl"));
}

/// A skinned triangle, mirrored by its bind pose; its own node is far away, which does not count, and carries another
/// object.
Scene skinned_scene() {
    Scene scene;
    Mesh mesh;
    mesh.positions = std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.indices = std::vector<std::uint32_t>{0, 1, 2};
    scene.meshes = {mesh, mesh};
    scene.meshes[0].influences = std::vector<JointInfluence>(3, JointInfluence{{0, 0, 0, 0}, {1, 0, 0, 0}});
    Node joint, skinned, child;
    joint.local.translation = {5, 0, 0};
    skinned.name = "skinned";
    skinned.local.translation = {100, 0, 0};
    skinned.meshes = {0};
    skinned.skin = 0;
    child.parent = 1;
    child.meshes = {1};
    scene.nodes = {joint, skinned, child};
    dmat4 inverse_bind;
    inverse_bind[0].x = -1;
    inverse_bind[3].y = 1;
    scene.skins = {Skin{"", {0}, {inverse_bind}}};
    return scene;
}

TEST(SmoothFile, SkinnedMeshesStandInTheirBindPoseWhereTheFormatHasNoSkins) {
    Context context;
    const Scene scene = skinned_scene(), flat = placed_in_world(scene, false, context);
    const std::vector<vec3> wanted{{5, 1, 0}, {4, 1, 0}, {5, 2, 0}};
    EXPECT_TRUE(std::equal(wanted.begin(), wanted.end(), flat.meshes[0].positions.begin()));
    const std::vector<std::uint32_t> turned{0, 2,
                                            1};  // mirrored: the other way round, so that the front stays in front
    EXPECT_TRUE(std::equal(turned.begin(), turned.end(), flat.meshes[0].indices.begin()));
    EXPECT_EQ(flat.meshes[1].positions[0], (vec3{100, 0, 0}));
}

TEST(SmoothFile, StlAsOutputIsRefusedWithTheReason) {
    const TemporaryFolder out;
    write(out / "a.obj", two_quads);
    Context context;
    try {
        smooth_file((out / "a.obj").string(), (out / "a.STL").string(), anew, context);
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::usage);
        EXPECT_NE(error.reason().find("STL cannot store vertex normals"), std::string::npos);
    }
    EXPECT_FALSE(fs::exists(out / "a.STL"));
}

TEST(SmoothFile, ObjAsOutputKeepsDigitsColorsAndOtherFiles) {
    const TemporaryFolder out;
    write(out / "far.ply",
          "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\nproperty "
          "uchar red\n"
          "property uchar green\nproperty uchar blue\nproperty float heat\nelement face 1\nproperty list uchar int "
          "vertex_indices\nend_header\n"
          "1000000.01 0 0 255 0 0 1\n1000000.02 0 0 0 255 0 2\n1000000.01 0.01 0 0 0 255 3\n3 0 1 2\n");
    write(out / "far.mtl", "my own");
    Context context;
    for (int run = 0; run < 2; ++run) {  // the second replaces its own library
        smooth_file((out / "far.ply").string(), (out / "far.obj").string(), anew, context);
        EXPECT_EQ(bytes_of(out / "far.mtl"), "my own");
        EXPECT_TRUE(fs::exists(out / "far.2.mtl"));
        EXPECT_FALSE(fs::exists(out / "far.3.mtl"));
    }
    const Scene wanted = load((out / "far.ply").string(), {}, context),
                made = load((out / "far.obj").string(), {}, context);
    ASSERT_EQ(made.meshes[0].positions.size(), 3u);
    for (std::size_t v = 0; v < 3; ++v) {
        const auto place = [&](const Mesh& m) { return double(m.positions[v].x) + m.origin.x; };
        EXPECT_NEAR(place(made.meshes[0]), place(wanted.meshes[0]), 1e-6);
        EXPECT_EQ(made.meshes[0].colors[v], wanted.meshes[0].colors[v]);
    }
    const auto entries = context.report().entries();
    EXPECT_TRUE(std::ranges::any_of(
        entries, [](const ReportEntry& e) { return e.message == "OBJ cannot store other vertex attributes"; }));
}

TEST(SmoothFile, AnObjOfPointsAloneIsCopied) {
    const TemporaryFolder out;
    const std::string cloud = "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\n";
    write(out / "cloud.obj", cloud);
    Context context;
    EXPECT_FALSE(smooth_file((out / "cloud.obj").string(), (out / "same.obj").string(), anew, context).changed);
    EXPECT_EQ(bytes_of(out / "same.obj"), cloud);
}

TEST(SmoothFile, AFolderAsOutputIsCalledOne) {
    const TemporaryFolder out;
    write(out / "a.obj", two_quads);
    fs::create_directory(out / "b.glb");
    for (const char* name : {"", "b.glb", "none/"}) {
        Context context;
        try {
            smooth_file((out / "a.obj").string(), (out / name).string(), anew, context);
            ADD_FAILURE() << name;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::usage);
            EXPECT_NE(std::string(error.what()).find("is a folder"), std::string::npos) << error.what();
        }
    }
}

TEST(SmoothFile, FormatsWithoutAWayBetweenThemAreAUsageError) {
    const TemporaryFolder out;
    write(out / "a.obj", two_quads);
    Context context;
    for (const char* name : {"b.fbx", "b.stl", "b"}) try {
            smooth_file((out / "a.obj").string(), (out / name).string(), anew, context);
            ADD_FAILURE() << name;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::usage);
        }
}

TEST(SmoothFile, JsonSaysWhatHappenedToEachMesh) {
    SmoothedFileRow row{.file = "in.glb"};
    row.result =
        SmoothedFile{.file = "in.glb", .output = "out.glb", .changed = true, .meshes_added = 1, .missing_made = 7};
    row.result->meshes.push_back({.name = "body",
                                  .mesh = 2,
                                  .primitive = 0,
                                  .vertices = 8,
                                  .vertices_split = 3,
                                  .normals = SmoothedMesh::Change::replaced,
                                  .tangents = SmoothedMesh::Change::removed});
    const Json json = Json::parse(to_json(std::span(&row, 1)));
    EXPECT_EQ(json["schema"], "rakelight.smooth/1");
    const Json& got = json["rows"][0];
    EXPECT_EQ(got["vertices_split"], 3);
    EXPECT_EQ(got["meshes_added"], 1);
    EXPECT_EQ(got["missing_made"], 7);
    EXPECT_EQ(got["meshes"][0]["normals"], "replaced");
    EXPECT_EQ(got["meshes"][0]["tangents"], "removed");
    EXPECT_EQ(got["meshes"][0]["mesh"], 2);
}

}  // namespace
}  // namespace rakelight
