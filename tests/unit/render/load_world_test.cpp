// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rakelight/base/report.h>
#include <rakelight/io/world.h>
#include <rakelight/render/picture.h>
#include <rakelight/scene/scene_queries.h>
#include <rakelight/scene/validate.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <tuple>

#include "math/linear.h"
#include "scene/drawn_vertices.h"
#include "scene/placement.h"
#include "support/shared.h"
#include "support/temporary_folder.h"
#include "support/thrown_error.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

constexpr const char* roof = "v -1 0 0\nv 0 0.2 0\nv -1 0 1\nv 1 0 0\nv 1 0 1\nv 0 0.2 1\nf 1 3 6 2\nf 2 6 5 4\n";

/// A folder with two small models.
class LoadWorld : public testing::Test {
protected:
    void SetUp() override {
        write("a.obj", "mtllib m.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        write("m.mtl", "newmtl red\nKd 1 0 0\nKs 0.5 0.5 0.5\nNs 20\n");
        write("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    }

    void write(const std::string& name, const std::string& text) { folder_.write(name, text); }
    Scene load_text(const std::string& text, LoadOptions options = {}) {
        write("w.scene.toml", text);
        return load((folder_ / "w.scene.toml").string(), options, context_);
    }

    Scene prepared(const std::string& text, const PrepareOptions& options = {}) {
        return prepare_scene(load_text(text), options, context_);
    }

    TemporaryFolder folder_;
    Context context_{{.threads = 1}};
};

}  // namespace

TEST_F(LoadWorld, ModelsAreTurnedAboutXThenYThenZ) {
    const Scene s =
        load_text("[[model]]\nfile = 'b.obj'\nposition = [5, 0, 0]\nrotation_deg = [90, 90, 0]\nscale = [2, 1, 1]\n");
    const dmat4 m = world_matrices(s).at(1);
    // x (2, 0, 0): about x stays, about y goes to (0, 0, -2). y (0, 1, 0): about x to (0, 0, 1), about y to (1, 0, 0).
    const dvec3 x = transform_point(m, dvec3{1, 0, 0}), y = transform_point(m, dvec3{0, 1, 0});
    EXPECT_NEAR(x.x, 5, 1e-12);
    EXPECT_NEAR(x.z, -2, 1e-12);
    EXPECT_NEAR(y.x, 6, 1e-12);
    EXPECT_NEAR(y.z, 0, 1e-12);
}

TEST_F(LoadWorld, AHorizontalAngleAloneHoldsInEveryPictureWithSquarePixels) {
    const Scene s = load_text("[[model]]\nfile = 'b.obj'\n[[camera]]\nposition = [0, 0, 5]\nhorizontal_fov_deg = 60\n");
    EXPECT_NO_THROW(validate(s));
    for (const double aspect : {0.5, 1.0, 3.0}) {
        const Camera c = choose_camera(s, {}, aspect, context_);
        EXPECT_NEAR(aspect * std::tan(c.vertical_fov_rad / 2), 1 / std::sqrt(3.0), 1e-12) << aspect;
        EXPECT_FALSE(c.horizontal_fov_rad);
    }
    EXPECT_TRUE(context_.report().entries().empty());
}

TEST_F(LoadWorld, AModelsSubdivisionIsItsMeshesAlone) {
    const Scene s = load_text(
        "[[model]]\nfile = 'a.obj'\nsubdivide = 3\nsubdivide_crease_deg = 30\nsubdivide_sharpness = 1.5\n"
        "subdivide_scheme = 'loop'\nsubdivide_uv = 'linear'\nsubdivide_boundary = 'edge'\n"
        "[[model]]\nfile = 'a.obj'\nname = 'second'\nsubdivide_edge = 0.5\n"
        "[[model]]\nfile = 'a.obj'\nname = 'third'\nsubdivide = 0\n[[model]]\nfile = 'a.obj'\nname = 'fourth'\n");
    ASSERT_EQ(s.meshes.size(), 4u);
    EXPECT_EQ(s.meshes[0].subdivision, (Subdivision{.level = 3,
                                                    .scheme = SubdivisionScheme::loop,
                                                    .uv = SubdivisionUv::linear,
                                                    .round_corners = true,
                                                    .crease_angle_rad = radians(30.0),
                                                    .sharpness = 1.5}));
    EXPECT_EQ(s.meshes[1].subdivision, (Subdivision{.level = 8, .edge = 0.5}));
    EXPECT_EQ(s.meshes[2].subdivision, Subdivision{});
    EXPECT_EQ(s.meshes[3].subdivision, std::nullopt);
    EXPECT_EQ(s.meshes[0].positions, s.meshes[3].positions);  // still shared
    const std::string error =
        error_of([&] { load_text("[[model]]\nfile = 'a.obj'\nsubdivide_sharpness = 2\n"); }).what();
    EXPECT_NE(error.find("line 3, column 23: 'subdivide_sharpness'"), std::string::npos) << error;
    const std::string model = "[[model]]\nfile = 'a.obj'\nsubdivide = 1\nsubdivide_crease = 'auto'\n";
    EXPECT_TRUE(load_text(model).meshes[0].subdivision->finds_creases);
    const std::string both = error_of([&] { load_text(model + "subdivide_crease_deg = 20\n"); }).what();
    EXPECT_NE(both.find("leaves nothing to 'subdivide_crease_deg'"), std::string::npos) << both;
}

TEST_F(LoadWorld, AFileThatStandsTwiceSharesItsArrays) {
    const Scene s = load_text("[[model]]\nfile = 'b.obj'\n[[model]]\nfile = 'b.obj'\nname = 'second'\n");
    ASSERT_EQ(s.meshes.size(), 2u);
    EXPECT_EQ(s.meshes[0].positions, s.meshes[1].positions);
    EXPECT_EQ(s.nodes.at(0).name, "b");
    EXPECT_EQ(s.nodes.at(2).name, "second");
}

TEST_F(LoadWorld, NormalsInsideAModelThatStandsSeveralTimesAreMadeOnce) {
    write("roof.obj", roof);
    for (const std::string normals : {"flat", "object"}) {
        const std::string model = "[[model]]\nfile = 'roof.obj'\nnormals = '" + normals + "'\n";
        const Scene s = prepared(model + "rotation_deg = [0, 40, 0]\n" + model + "position = [9, 0, 0]\n" + model +
                                 "crease_angle_deg = 5\n");
        ASSERT_EQ(s.meshes.size(), 3u);
        EXPECT_EQ(s.meshes[0].normals, s.meshes[1].normals) << normals << ": the same array";
        EXPECT_EQ(s.meshes[0].positions, s.meshes[1].positions);
        EXPECT_NE(s.meshes[0].normals, s.meshes[2].normals) << "asked for by another crease angle";
    }
}

TEST_F(LoadWorld, MaterialsAreChangedByNameAndByModel) {
    const Scene s = load_text(
        "[[model]]\nfile = 'a.obj'\n[[model]]\nfile = 'a.obj'\nname = 'other'\n"
        "[[material]]\nname = 'red'\nshininess = 99\n"
        "[[material]]\nname = 'red'\nmodel = 'other'\ncolor = [0, 1, 0]\nlighting = 'phong'\n");
    ASSERT_EQ(s.materials.size(), 2u);
    for (const Material& m : s.materials) EXPECT_EQ(m.classical.shininess, 99);
    EXPECT_EQ(s.materials[0].base_color, (vec4{1, 0, 0, 1}));
    EXPECT_EQ(s.materials[0].lighting, Lighting::automatic);
    EXPECT_EQ(s.materials[1].base_color, (vec4{0, 1, 0, 1}));
    EXPECT_EQ(s.materials[1].classical.ambient, (vec3{0, 1, 0}));
    EXPECT_EQ(s.materials[1].lighting, Lighting::phong);
}

TEST_F(LoadWorld, RoughnessMakesAClassicalMaterialMetallicRoughness) {
    const Scene s =
        load_text("[[model]]\nfile = 'a.obj'\n[[material]]\nname = 'red'\nroughness = 0.25\nclearcoat = 1\n");
    EXPECT_EQ(s.materials[0].model, MaterialModel::metallic_roughness);
    EXPECT_EQ(s.materials[0].metallic_roughness.roughness, 0.25f);
    EXPECT_EQ(s.materials[0].metallic_roughness.metallic, 0);
    EXPECT_EQ(s.materials[0].metallic_roughness.clearcoat, 1);
}

TEST_F(LoadWorld, AMaterialOfTheWorldGoesOverAWholeModel) {
    const Scene s = load_text(
        "[[model]]\nfile = 'a.obj'\nmaterial = 'gold'\n[[primitive]]\ntype = 'sphere'\nmaterial = 'gold'\n"
        "[[material]]\nname = 'gold'\ncolor = [1, 0.8, 0.3]\nmetallic = 1\nroughness = 0.2\nbump_depth = 0.1\n");
    for (const Mesh& mesh : s.meshes) {
        const Material& m = s.materials.at(mesh.material);
        EXPECT_EQ(m.name, "gold");
        EXPECT_EQ(m.metallic_roughness.metallic, 1);
        EXPECT_EQ(m.relief.value().depth, 0.1f);
    }
    EXPECT_TRUE(context_.report().entries().empty());
}

TEST_F(LoadWorld, AMaterialThatNothingHasIsWarnedOf) {
    load_text("[[model]]\nfile = 'a.obj'\n[[material]]\nname = 'rde'\nshininess = 9\n");
    ASSERT_EQ(context_.report().entries().size(), 1u);
    EXPECT_EQ(context_.report().entries()[0].place, "line 3, column 1");
}

TEST_F(LoadWorld, EveryPrimitiveIsMade) {
    const Scene s = load_text(
        "[[primitive]]\ntype = 'teapot'\n[[primitive]]\ntype = 'sphere'\nobjects = 4\n[[primitive]]\ntype = "
        "'cylinder'\n"
        "[[primitive]]\ntype = 'cone'\n[[primitive]]\ntype = 'torus'\n[[primitive]]\ntype = 'plane'\nsize = [8, 4]\n");
    EXPECT_EQ(s.nodes.front().name, "teapot");
    const Bounds box = world_bounds(s);
    EXPECT_EQ(box.low.x, -4);
    EXPECT_EQ(box.high.z, 2);
}

TEST_F(LoadWorld, APrimitivesPartsBearTheNameThatTheWorldGivesIt) {
    const Scene s = load_text(
        "[[primitive]]\ntype = 'torus'\nname = 'tyre'\n[[primitive]]\ntype = 'torus'\nname = 'spare'\nobjects = 2\n"
        "[[primitive]]\ntype = 'torus'\n");
    std::vector<std::string> drawn;
    for (const Node& node : s.nodes)
        if (!node.meshes.empty()) drawn.push_back(node.name + "|" + s.meshes[node.meshes[0]].name);
    EXPECT_EQ(drawn, (std::vector<std::string>{"tyre|tyre", "spare 1|spare 1", "spare 2|spare 2", "torus|torus"}));
}

TEST_F(LoadWorld, LightsAndCamerasOfModelsComeAlongOnlyWhereTheWorldSaysSo) {
    write("lamp.gltf", R"({"asset": {"version": "2.0"}, "extensionsUsed": ["KHR_lights_punctual"], "scene": 0,
        "scenes": [{"nodes": [0, 1, 2]}], "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}}],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point"}]}},
        "nodes": [{"mesh": 0}, {"camera": 0}, {"extensions": {"KHR_lights_punctual": {"light": 0}}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})");
    const std::string camera = "[[camera]]\nname = 'own'\nposition = [0, 0, 9]\n";
    EXPECT_TRUE(load_text("[[model]]\nfile = 'lamp.gltf'\n" + camera).lights.empty());
    const Scene with = load_text("[[model]]\nfile = 'lamp.gltf'\nlights = true\ncameras = true\n" + camera);
    EXPECT_EQ(with.lights.size(), 1u);
    EXPECT_EQ(with.cameras.size(), 2u);
    EXPECT_EQ(with.cameras.at(0).name, "own");
}

TEST_F(LoadWorld, NormalsOfOneModelAreMadeAsTheWorldSays) {
    write("roof.obj", roof);
    const auto ridge_is_smooth = [&](const std::string& keys, const PrepareOptions& options = {}) {
        return prepared("[[model]]\nfile = 'roof.obj'\n" + keys, options).meshes.at(0).normals.size() == 6;
    };
    EXPECT_TRUE(ridge_is_smooth(""));  // as the picture's options say
    EXPECT_FALSE(ridge_is_smooth("", {.normals = NormalSource::flat}));
    EXPECT_TRUE(ridge_is_smooth("normals = 'model'\n"));
    EXPECT_FALSE(ridge_is_smooth("normals = 'flat'\n"));
    EXPECT_FALSE(ridge_is_smooth("crease_angle_deg = 5\n"));
    EXPECT_TRUE(ridge_is_smooth("crease_angle_deg = 40\n", {.crease_angle_rad = 0})) << "its own goes before";
    EXPECT_FALSE(ridge_is_smooth("normals = 'model'\n", {.crease_angle_rad = 0})) << "none of its own";
    EXPECT_TRUE(ridge_is_smooth("normals = 'flat'\n", {.normals = NormalSource::model})) << "the picture's for all";
}

/// World normals at the place (0, 0, 0) of all that is drawn, each once.
std::set<std::tuple<long, long, long>> normals_at_origin(const Scene& s) {
    std::set<std::tuple<long, long, long>> found;
    const std::vector<dmat4> world = world_matrices(s);
    for (std::size_t n = 0; n < s.nodes.size(); ++n)
        for (const std::uint32_t m : s.nodes[n].meshes) {
            const Mesh& mesh = s.meshes[m];
            const dmat3 linear = upper_left(world[n]), turn = cofactor(linear);
            for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
                const dvec3 p = transform_point(world[n], cast<double>(mesh.positions[v]));
                if (length(p) > 1e-6) continue;
                const dvec3 normal = normalize_or(
                    turn * cast<double>(mesh.normals[v]) * (determinant(linear) < 0 ? -1.0 : 1.0), dvec3{});
                found.insert({std::lround(1e5 * normal.x), std::lround(1e5 * normal.y), std::lround(1e5 * normal.z)});
            }
        }
    return found;
}

/// Three models that meet at the origin, a and b along +z, a and c along an edge too; b is mirrored.
std::string three_slopes(const std::string& a, const std::string& b, const std::string& c) {
    return "[[model]]\nfile = 'slope.obj'\nname = 'a'\nscale = [2, 0.5, 1]\n" + a +
           "[[model]]\nfile = 'slope.obj'\nname = 'b'\nscale = [-2, 0.25, 1]\n" + b +
           "[[model]]\nfile = 'side.obj'\nname = 'c'\nscale = [2, 0.5, 3]\n" + c;
}
constexpr const char* slope = "v 0 0 0\nv 1 -1 0\nv 1 -1 1\nv 0 0 1\nf 1 4 3 2\n";
constexpr const char* side = "v 0 0 0\nv 1 -1 0\nv 1 -2 -1\nv 0 -1 -1\nf 1 2 3 4\n";

TEST_F(LoadWorld, ModelsThatSayModelAreSmoothedTogether) {
    write("slope.obj", slope);
    write("side.obj", side);
    const std::string model = "normals = 'model'\ncrease_angle_deg = 180\n", object = "normals = 'object'\n";
    const auto unlike = [&](const std::string& text, const PrepareOptions& options = {}) {
        return normals_at_origin(prepared(text, options)).size();
    };
    EXPECT_EQ(unlike(three_slopes(model, model, model)), 1u);
    EXPECT_EQ(normals_at_origin(prepared(three_slopes(model, model, model))),
              normals_at_origin(
                  prepared(three_slopes("", "", ""), {.normals = NormalSource::model, .crease_angle_rad = pi})));
    EXPECT_EQ(unlike(three_slopes(object, object, object)), 3u);
    EXPECT_EQ(unlike(three_slopes(model, object, model)), 2u) << "a and c together, b alone";
    EXPECT_EQ(unlike(three_slopes("normals = 'flat'\n", object, "normals = 'file'\n")), 3u);
    EXPECT_EQ(unlike(three_slopes(model, "", model), {.crease_angle_rad = pi}), 1u) << "b by the picture's options";
    EXPECT_EQ(unlike(three_slopes(model, "", model), {.crease_angle_rad = 0}), 2u)
        << "by its crease angle at its borders";
}

TEST_F(LoadWorld, BetweenModelsTheSmallerCreaseAngleRulesAndItIsSaid) {
    write("slope.obj", slope);
    write("side.obj", side);
    const auto by = [](const char* angle) {
        return "normals = 'model'\ncrease_angle_deg = " + std::string(angle) + "\n";
    };
    EXPECT_EQ(normals_at_origin(prepared(three_slopes(by("180"), by("90"), by("120")))).size(), 1u);
    EXPECT_EQ(normals_at_origin(prepared(three_slopes(by("180"), by("5"), by("120")))).size(), 2u);
    const auto notes = [&](const std::string& angles) {
        std::size_t found = 0;
        for (const ReportEntry& entry : context_.report().entries())
            found +=
                entry.message.find(angles + "): where two of them meet, the smaller angle rules") != std::string::npos;
        return found;
    };
    EXPECT_EQ(notes("(5 to 180 degrees"), 1u);
    prepared(three_slopes(by("180"), "normals = 'model'\n", by("180")), {.crease_angle_rad = radians(60.0)});
    EXPECT_EQ(notes("(60 to 180 degrees"), 1u) << "the picture's angle is one of them";
    prepared(three_slopes(by("180"), by("90"), by("120")), {.normals = NormalSource::model});
    prepared(three_slopes(by("50"), by("50"), by("50")));
    EXPECT_EQ(notes(" degrees"), 3u) << "angles of parts that do not count or are the same";
}

TEST_F(LoadWorld, TangentsFollowTheNormalsOverAllModelsThatSayModel) {
    write("slope.obj", "v 0 0 0\nv 1 -0.1 0\nv 1 -0.1 1\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 4/4 3/3 2/2\n");
    const auto world = [](const std::string& normals) {
        std::string text;
        for (const char* turn : {"0", "20"})
            text += "[[model]]\nfile = 'slope.obj'\nmaterial = 'bumpy'\nrotation_deg = [0, 0, " + std::string(turn) +
                    "]\nnormals = '" + normals + "'\n";
        return text + "[[material]]\nname = 'bumpy'\nnormal_texture = 'n.png'\n";
    };
    Frame blue;
    blue.begin(1, 1, {}, 0);
    blue.color[0] = {0.2f, 0.2f, 1, 1};
    save(blue, (folder_ / "n.png").string());
    const auto turn_deg = [&](const std::string& normals) {  // of the second model's tangent against the first's
        const Scene s = prepared(world(normals));
        const std::vector<dmat4> placed = world_matrices(s);
        dvec3 tangent[2];
        std::size_t found = 0;
        for (std::size_t n = 0; n < s.nodes.size(); ++n)
            for (const std::uint32_t m : s.nodes[n].meshes)
                tangent[found++] = upper_left(placed[n]) * cast<double>(s.meshes[m].tangents[0].xyz());
        return degrees(std::acos(std::min(1.0, dot(tangent[0], tangent[1]))));
    };
    EXPECT_NEAR(turn_deg("model"), 0, 0.01);
    EXPECT_NEAR(turn_deg("object"), 20, 0.01);
}

TEST_F(LoadWorld, FilesStayInTheWorldsFolderUnlessTheCallerAllowsOthers) {
    std::filesystem::create_directories(folder_ / "deep");
    write("deep/w.scene.toml", "[[model]]\nfile = '../b.obj'\n");
    const std::string path = (folder_ / "deep/w.scene.toml").string();
    const Error error = error_of([&] { load(path, {}, context_); });
    EXPECT_EQ(error.code(), ErrorCode::bad_file);
    EXPECT_EQ(error.place(), "line 2, column 8");
    EXPECT_EQ(error.file(), path);
    EXPECT_EQ(load(path, {.allow_outside = true}, context_).meshes.size(), 1u);
}

TEST_F(LoadWorld, AFaultOfAFileThatTheWorldNamesCarriesWorldPlaceAndName) {
    write("bad.obj", "v 0 0 0\nf 1 2 3\n");
    const std::string model = "[[model]]\nfile = 'a.obj'\n", world = (folder_ / "w.scene.toml").string();
    const struct {
        std::string text;
        const char *place, *name;
        ErrorCode code;
    } faults[] = {
        {"[[model]]\nfile = 'bad.obj'\n", "line 2, column 8", "'bad.obj': ", ErrorCode::bad_file},
        {"[[model]]\nfile = 'none.obj'\n", "line 2, column 8", "'none.obj': ", ErrorCode::not_found},
        {model + "[environment]\nfile = 'none.hdr'\n", "line 4, column 8", "'none.hdr': ", ErrorCode::not_found},
        {model + "[[material]]\nname = 'red'\nnormal_texture = 'no.png'\n", "line 5, column 18",
         "'no.png': ", ErrorCode::not_found},
        {model + "[[material]]\nname = 'unused'\nnormal_texture = 'no.png'\n", "line 5, column 18",
         "'no.png': ", ErrorCode::not_found},
        {model + "[environment]\nfile = 'm.mtl'\n", "line 4, column 8", "'m.mtl': is not a picture",
         ErrorCode::bad_file},
        {model + "[render]\ntexture-normal = 'm.mtl'\n", "line 4, column 1", "'m.mtl': is not a picture",
         ErrorCode::bad_file},
        {model + "[render]\nhdri-file = 'no.hdr'\n", "line 4, column 1", "'no.hdr': ", ErrorCode::not_found},
        {model + "[[camera]]\nname = 'front'\nposition = [0, 0, 9]\n[render]\ncamera-index = 'frnt'\n",
         "line 7, column 1", "no camera 'frnt'", ErrorCode::bad_file},
    };
    for (const auto& [text, place, name, code] : faults) {
        const Error error = error_of([&] { load_text(text); });
        EXPECT_EQ(error.file(), world) << text;
        EXPECT_EQ(error.place(), place) << text;
        EXPECT_NE(error.reason().find(name), std::string::npos) << error.what();
        EXPECT_EQ(error.code(), code) << text;
    }
}

TEST_F(LoadWorld, ShadingGoesToThePartThatSaysItAndToNoTwin) {
    const Scene s = load_text(
        "[[model]]\nfile = 'a.obj'\nshading = 'flat'\n[[model]]\nfile = 'a.obj'\nname = 'b'\n[[model]]\nfile = "
        "'a.obj'\nname = 'b'\nshading = 'unlit'\n");
    std::vector<std::optional<Shading>> of_parts;
    for (const Node& node : s.nodes)
        if (node.parent == no_index) of_parts.push_back(node.shading);
    EXPECT_EQ(of_parts, (std::vector<std::optional<Shading>>{Shading::flat, std::nullopt, Shading::unlit}));
}

TEST_F(LoadWorld, ShadingOfAMaterialGoesToThatOfItsModelAlone) {
    const std::string both = "[[model]]\nfile = 'a.obj'\n[[model]]\nfile = 'b.obj'\n";
    const Scene s = load_text(both + "[[material]]\nname = '*'\nmodel = 'b'\nshading = 'gouraud'\n");
    ASSERT_EQ(s.materials.size(), 2u);
    EXPECT_EQ(s.materials[0].shading, std::nullopt);
    EXPECT_EQ(s.materials[1].shading, Shading::gouraud);
}

TEST_F(LoadWorld, WhatRenderNamesNeedNotBeThereWhereOthersTakeItsPlace) {
    for (const std::string key : {"camera-index", "hdri-file", "height-map"}) {
        const std::string text = "[[model]]\nfile = 'a.obj'\n[render]\n" + key + " = 'none.png'\n";
        EXPECT_THROW(load_text(text), Error) << key;
        EXPECT_THROW(load_text(text, {.overridden = {"resolution"}}), Error) << key;
        EXPECT_NO_THROW(load_text(text, {.overridden = {key}})) << key;
    }
}

TEST_F(LoadWorld, WhatHasNoEffectOrIsNotWhatItSeemsIsWarnedOf) {
    const std::string model = "[[model]]\nfile = 'a.obj'\n";
    const struct {
        std::string text;
        const char* words;
    } cases[] = {
        {model + "[[material]]\nname = 'redd'\nunlit = true\n", "did you mean 'red'?"},
        {model + "normals = 'flat'\ncrease_angle_deg = 30\n", "no effect beside normals = \"flat\""},
        {model + "name = 'wall'\nmaterial = 'own'\n[[material]]\nname = 'own'\n[[material]]\nname = '*'\nmodel = "
                 "'wall'\ncolor = [0, 1, 0]\n",
         "no effect: all of 'wall' is of 'own'"},
        {model + "[[material]]\nname = 'red'\ncolor = [255, 0, 0]\n", "'color' is more than 1"},
        {model + "[[camera]]\nname = 'c'\nposition = [0, 0, 9]\n[[camera]]\nname = 'c'\nposition = [0, 0, 8]\n",
         "two cameras are named 'c'"},
        {"[[primitive]]\ntype = 'cone'\nname = 'p'\n[[primitive]]\ntype = 'sphere'\nname = 'p'\n",
         "two primitives are named 'p'"},
    };
    std::size_t count = 0;
    for (const auto& [text, words] : cases) {
        load_text(text);
        ASSERT_EQ(context_.report().entries().size(), ++count) << text;
        EXPECT_NE(context_.report().entries().back().message.find(words), std::string::npos)
            << context_.report().entries().back().message;
    }
    load_text(
        "[[primitive]]\ntype = 'cone'\n[[primitive]]\ntype = 'cone'\n[[camera]]\nposition = [0, 0, 9]\n"
        "[[camera]]\nposition = [0, 0, 8]\n");
    load_text(model + "[[material]]\nname = 'red'\nemission = [5, 5, 5]\n");
    EXPECT_EQ(context_.report().entries().size(), count);
}

TEST_F(LoadWorld, FogAndSurroundingsAreInTheScene) {
    const Scene s = load_text(
        "[[model]]\nfile = 'a.obj'\n[fog]\nkind = 'exp2'\ndensity = 0.25\ncolor = [1, 0, 0]\n[environment]\nintensity "
        "= 2\nlight = false\n");
    EXPECT_EQ(s.fog.kind, FogKind::exponential_squared);
    EXPECT_EQ(s.fog.density, 0.25f);
    ASSERT_TRUE(s.environment);
    EXPECT_EQ(s.environment->intensity, 2);
    EXPECT_FALSE(s.environment->is_light);
    EXPECT_TRUE(s.environment->is_background);
    EXPECT_EQ(s.environment->image, nullptr);
}

TEST_F(LoadWorld, EqualShapesShareTheirArraysAndAreChargedOnce) {
    const std::string sphere = "[[primitive]]\ntype = 'sphere'\ntolerance = 1e-4\n",
                      pot = "[[primitive]]\ntype = 'teapot'\n";
    Scene s = load_text(sphere + pot);
    const std::uint64_t once = context_.memory().charged();
    EXPECT_GT(once, s.meshes.at(0).positions.size() * 32);
    s = load_text(sphere + "position = [3, 0, 0]\n" + sphere + pot + pot + "name = 'other'\n" + sphere);
    EXPECT_EQ(s.meshes.at(0).positions.data(), s.meshes.at(1).positions.data());
    EXPECT_LT(context_.memory().charged(), once + 10'000);
}

TEST_F(LoadWorld, ShapesBeyondTheBudgetAreRefusedWithTheirPlace) {
    std::string text;
    for (int i = 1; i <= 40; ++i)
        text += "[[primitive]]\ntype = 'plane'\ndivisions = 256\nsize = [" + std::to_string(i) + ", 1]\n";
    write("w.scene.toml", text);
    Context small({.threads = 1, .max_memory = 20'000'000});  // a plane has 257^2 * 32 + 256^2 * 24 bytes: five fit
    const Error error = error_of([&] { load((folder_ / "w.scene.toml").string(), {}, small); });
    EXPECT_EQ(error.code(), ErrorCode::bad_file);
    EXPECT_EQ(error.place(), "line 21, column 1");
    EXPECT_NE(error.reason().find("a shape: 3686432 bytes beside "), std::string::npos) << error.what();
}

TEST_F(LoadWorld, ACameraWhoseUpIsAlongItsViewHasAnotherAndSaysSo) {
    const Scene s = load_text(
        "[[model]]\nfile = 'b.obj'\n[[camera]]\nposition = [0, 3, 0]\n"
        "[[camera]]\nposition = [0, -3, 0]\n[[camera]]\nposition = [2, 0, 0]\nup = [1, 0, 0]\n");
    EXPECT_EQ(s.cameras.at(0).to_world[1].xyz(), (dvec3{0, 0, -1}));
    EXPECT_EQ(s.cameras.at(1).to_world[1].xyz(), (dvec3{0, 0, 1}));
    EXPECT_EQ(s.cameras.at(2).to_world[1].xyz(), (dvec3{0, 1, 0}));
    const std::vector<ReportEntry> said = context_.report().entries();
    ASSERT_EQ(said.size(), 3u);
    EXPECT_EQ(said[0].remark, Remark::note) << "nobody named an up";
    EXPECT_EQ(said[0].place, "line 3, column 1");
    EXPECT_NE(said[0].message.find("-Z is up instead"), std::string::npos);
    EXPECT_EQ(said[1].remark, Remark::note);
    EXPECT_EQ(said[2].remark, Remark::warning);
    EXPECT_EQ(said[2].place, "line 9, column 6");
}
