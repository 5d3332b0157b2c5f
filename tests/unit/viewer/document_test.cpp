// SPDX-License-Identifier: Apache-2.0
#include "../../../apps/viewer/document/document.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include <rakelight/math/linear.h>
#include <rakelight/render/render.h>

#include "../../../apps/viewer/document/commands.h"
#include "../../../apps/viewer/document/feedback.h"
#include "../../../apps/viewer/document/gather.h"
#include "../../../apps/viewer/view/drop.h"
#include "../../../apps/viewer/view/overlay.h"
#include "../../../apps/viewer/view/painter.h"
#include "looks.h"
#include "support/shared.h"

namespace rakelight::viewer {
namespace {

TEST_F(Looks, AFirstLookIsSavedAsSeen) {
    const auto m = model(write_model());
    EXPECT_SAVED_AS_SEEN(first_look(*m), m);
}

TEST_F(Looks, PointsWithoutASizeGetThatOfTheirSpacing) {
    std::string cloud =
        "ply\nformat ascii 1.0\nelement vertex 400\nproperty float x\nproperty float y\n"
        "property float z\nproperty float nx\nproperty float ny\nproperty float nz\nend_header\n";
    for (int i = 0; i < 400; ++i) cloud += std::to_string(i % 20) + " " + std::to_string(i / 20) + " 0 0 0 1\n";
    std::ofstream(file("cloud.ply")) << cloud;
    Start start{.settings = {}};
    start.takes = [](std::string_view) { return true; };
    const auto m = load_model(file("cloud.ply"), start, context_);
    EXPECT_NE(m->request.settings.point_size, RenderSettings{}.point_size);
    EXPECT_TRUE(std::ranges::find(m->request.given_keys, "point-size") == m->request.given_keys.end());
}

TEST_F(Looks, AMovedCameraIsSavedAsSeen) {
    const auto m = model(write_model());
    Look look = first_look(*m);
    Eye& eye = moving_eye(look, *m, width, height);
    turn_table(eye, 0.7, 0.3, look.world_up);
    dolly(eye, 0.77);
    pan(eye, 3, 5, height);
    eye.fov_deg = 37.123456789;
    EXPECT_SAVED_AS_SEEN(look, m);
    eye.is_orthographic = true;
    EXPECT_SAVED_AS_SEEN(look, m);
}

TEST_F(Looks, AReopenedSceneTurnsAboutTheSameAxis) {
    const auto of = model(write_model());
    Look look = first_look(*of);
    look.world_up = {0, 0, 1};
    turn_table(moving_eye(look, *of, width, height), 0.9, 0.5, look.world_up);
    EXPECT_SAVED_AS_SEEN(look, of);
    EXPECT_EQ(first_look(*model(file("saved.scene.toml"))).world_up, look.world_up);
    roll(*look.eye, 0.4);  // the up of a rolled picture is no axis of the world
    EXPECT_SAVED_AS_SEEN(look, of);
    EXPECT_EQ(first_look(*model(file("saved.scene.toml"))).world_up, (dvec3{0, 1, 0}));
}

TEST_F(Looks, AnEyeThatNoCameraCanHaveIsNotTaken) {
    const auto of = model(write_model());
    Look look = first_look(*of);
    const Look before = look;
    Eye eye = seen_eye(look, *of, width, height);
    EXPECT_TRUE(look == before);
    eye.position.x = 1e300;
    EXPECT_FALSE(set_eye(look, eye, *of, width, height));
    EXPECT_TRUE(look == before);
    eye.position.x = 3;
    EXPECT_TRUE(set_eye(look, eye, *of, width, height));
    EXPECT_EQ(look.eye->position.x, 3);
}

TEST_F(Looks, CamerasOfTheFileFollowEachOther) {
    const auto of = model((test::source_dir() / "data/world/room.scene.toml").string());
    ASSERT_GT(of->box.cameras().size(), 1u);
    Look look = first_look(*of);
    const auto next = [&] { apply(Command::next_camera, look, *of, width, height); };
    EXPECT_EQ(current_camera(look, *of), 0u);
    next();
    EXPECT_EQ(current_camera(look, *of), 1u);
    moving_eye(look, *of, width, height);
    EXPECT_FALSE(current_camera(look, *of));
    next();  // back to where it began
    EXPECT_EQ(current_camera(look, *of), 1u);
}

TEST_F(Looks, SettingsAreSavedAsSeen) {
    const auto m = model(write_model());
    Look look = first_look(*m);
    for (const Command command :
         {Command::shading, Command::lighting, Command::shadows, Command::edges, Command::tone, Command::samples,
          Command::brighter, Command::environment_light, Command::top, Command::orthographic, Command::up_axis})
        ASSERT_TRUE(apply(command, look, *m, width, height)) << int(command);
    look.request.prepare.normals = NormalSource::model;
    look.request.prepare.crease_angle_rad = radians(33.3);
    look.request.settings.background = {linear_from_srgb({0.2f, 0.4f, 0.6f}).x, linear_from_srgb({0.2f, 0.4f, 0.6f}).y,
                                        0, 1};
    EXPECT_SAVED_AS_SEEN(look, m);
}

TEST_F(Looks, LightsAreSavedAsSeen) {
    const auto m = model(write_model());
    Look look = first_look(*m);
    std::vector<LightItem>& lights = changing_lights(look, *m, width, height);
    ASSERT_EQ(lights.size(), 3u);  // the default rig
    lights[1].is_on = false;
    Light lamp{.name = "lamp", .position = {0.5, 1.1, 1.7}, .diffuse = {0.9f, 0.6f, 0.3f}};
    lamp.quadratic = 0.31f;
    lights.push_back({.light = lamp});
    Light spot{.type = LightType::spot,
               .position = {-1, 1, 2},
               .direction = {0.3, -0.4, -0.85},
               .cutoff_rad = 0.4f,
               .exponent = 3};
    lights.push_back({.light = spot});
    EXPECT_SAVED_AS_SEEN(look, m);
    for (LightItem& item : lights) item.is_on = false;
    EXPECT_SAVED_AS_SEEN(look, m);
    EXPECT_EQ(drawn(m, look).color[height / 2 * width + width / 2].x, 0);  // all off is dark, not the default rig
}

TEST_F(Looks, WhereAnEnvironmentGivesLightThereIsNoDefaultRigInTheList) {
    const auto m = model(write_model());
    Look look = first_look(*m);
    apply(Command::environment_light, look, *m, width, height);
    EXPECT_TRUE(changing_lights(look, *m, width, height).empty());
}

TEST_F(Looks, MaterialsAreSavedAsSeen) {
    const auto m = model(write_model());
    Look look = first_look(*m);
    const Frame before = drawn(m, look);
    set_material(look, {.name = "red"}, "color=0,0.7,0.1");
    set_material(look, {.name = "red"}, "color=0,0.7,0.2");
    set_material(look, {.name = "red"}, "shininess=5");
    set_material(look, {.name = "gray"}, "roughness=0.3");
    EXPECT_EQ(look.materials.size(), 2u);
    EXPECT_EQ(look.materials[0].values.size(), 2u);
    EXPECT_FALSE(drawn(m, look).color == before.color);
    EXPECT_SAVED_AS_SEEN(look, m);
    EXPECT_THROW(set_material(look, {.name = "red"}, "no_such_key=1"), Error);
}

TEST_F(Looks, AChangedWorldIsSavedAgainAsSeen) {
    write_model();
    std::ofstream(file("world.scene.toml"))
        << "[[model]]\nfile = \"model.obj\"\nrotation_deg = [0, 30, 0]\n[[primitive]]\ntype = \"sphere\"\nposition = "
           "[0, 2, 0]\n"
           "radius = 0.5\ntolerance = 0.01\n[[light]]\ntype = \"point\"\nposition = [1, 3, 3]\n[[camera]]\nposition = "
           "[0, 1, 6]\ntarget = [0, 0.5, 0]\n"
           "[[material]]\nname = \"red\"\ncolor = [0, 0, 1]\n[render]\nshading = \"flat\"\n";
    const auto m = model(file("world.scene.toml"));
    Look look = first_look(*m);
    EXPECT_EQ(look.request.settings.shading, Shading::flat);
    EXPECT_SAVED_AS_SEEN(look, m);
    set_material(look, {.name = "red"}, "color=1,1,0");
    changing_lights(look, *m, width, height)[0].light.position.x = -2;
    turn_table(moving_eye(look, *m, width, height), 0.5, 0.1, look.world_up);
    EXPECT_SAVED_AS_SEEN(look, m);
}

TEST_F(Looks, TheCommandLineIsTheOneOfThePicture) {
    const auto m = model(write_model());
    Look look = first_look(*m);
    look.request.settings.shadows = true;
    look.request.prepare.crease_angle_rad = radians(30);
    const std::string line = command_line_of(look, *m, width, height);
    EXPECT_NE(line.find("rakelight render " + m->file + " -o model.png"), std::string::npos) << line;
    EXPECT_NE(line.find("--shadows=on"), std::string::npos) << line;
    EXPECT_NE(line.find("--crease-angle 30"), std::string::npos) << line;
    EXPECT_NE(line.find("--resolution 96,64"), std::string::npos) << line;
}

TEST_F(Looks, LightsThatFollowTheCameraGoAsItWent) {
    const auto m = model(write_model());
    Look look = first_look(*m);
    changing_lights(look, *m, width, height) = {{.light = {.position = {0, 0, 5}}, .follows_camera = true},
                                                {.light = {.position = {0, 0, 5}}}};
    Camera from, to;
    from.to_world = look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0});
    to.to_world = look_at({5, 0, 0}, {0, 0, 0}, {0, 1, 0});
    carry_lights(look, from, to);
    EXPECT_NEAR((*look.lights)[0].light.position.x, 5, 1e-9);
    EXPECT_EQ((*look.lights)[1].light.position, (dvec3{0, 0, 5}));
}

TEST_F(Looks, WhatAKeyDidIsSaidInWords) {
    const auto of = model(write_model());
    Look look = first_look(*of);
    const auto effect = [&](Command command) {
        apply(command, look, *of, width, height);
        return effect_of(command, look, *of);
    };
    EXPECT_EQ(effect(Command::shading), "shading: gouraud");
    EXPECT_EQ(effect(Command::lighting), "lighting: lambert");
    EXPECT_EQ(effect(Command::bump), "bump: none");
    EXPECT_EQ(effect(Command::samples), "samples: 8");
    EXPECT_EQ(effect(Command::engine), "engine: gl");
    EXPECT_EQ(effect(Command::wireframe), "wireframe: on");
    EXPECT_EQ(effect(Command::wireframe), "wireframe: off");
    EXPECT_EQ(effect(Command::brighter), "lights times 1.25");
    EXPECT_EQ(effect(Command::up_axis), "up axis: +Z");
    EXPECT_EQ(effect(Command::orthographic), "orthographic projection");
    EXPECT_EQ(effect(Command::next_camera), "the file has no cameras");
    EXPECT_EQ(effect(Command::front), "");
}

TEST_F(Looks, SeamsAreLookedForInTheNormalsThatAreSeen) {
    Scene scene;
    scene.missing_normals_are_flat = true;
    scene.meshes.resize(1);
    EXPECT_EQ(seam_options(scene, {}).normals, NormalSource::flat);
    EXPECT_EQ(seam_options(scene, {.normals = NormalSource::model}).normals, NormalSource::model);
    EXPECT_EQ(seam_options(scene, {.normals = NormalSource::object}).normals, NormalSource::object);
    scene.missing_normals_are_flat = false;
    EXPECT_EQ(seam_options(scene, {}).normals, NormalSource::model) << "as the picture has them";
    scene.missing_normals_are_flat = true;
    scene.meshes[0].normals = std::vector<vec3>{{0, 0, 1}};
    EXPECT_EQ(seam_options(scene, {}).normals, NormalSource::automatic);
}

TEST_F(Looks, PicturesOutsideOfASavedSceneAreCopied) {
    namespace fs = std::filesystem;
    const fs::path scene = folder_.path() / "in" / "a.scene.toml", files = folder_.path() / "in" / "a-files";
    fs::create_directories(folder_.path() / "in");
    fs::create_directories(folder_.path() / "other");
    std::ofstream(folder_.path() / "p.png") << "first";
    std::ofstream(folder_.path() / "other" / "p.png") << "second";
    WorldFile world;
    world.primitives = {{.type = "sphere"}};
    world.materials = {{.name = "*",
                        .values = {{.key = "color_texture", .words = {"../p.png"}},
                                   {.key = "normal_texture", .words = {"../other/p.png"}},
                                   {.key = "emission_texture", .words = {"../p.png"}},
                                   {.key = "occlusion_texture", .words = {"near.png"}}}}};
    EXPECT_EQ(save_with_files(world, scene.string()), 2u);
    const WorldFile saved = read_world(scene.string(), context_);
    const std::vector<WorldValue>& v = saved.materials.at(0).values;
    ASSERT_EQ(v.size(), 4u);
    EXPECT_EQ(v[0].words[0], "a-files/p.png");
    EXPECT_EQ(v[1].words[0], "a-files/p-2.png");
    EXPECT_EQ(v[2].words[0], "a-files/p.png");
    EXPECT_EQ(v[3].words[0], "near.png");
    EXPECT_EQ(fs::file_size(files / "p.png"), 5u);
    EXPECT_EQ(fs::file_size(files / "p-2.png"), 6u);
}

TEST_F(Looks, OfASceneThatCannotBeSavedNothingIsLeft) {
    namespace fs = std::filesystem;
    const fs::path scene = folder_.path() / "in" / "a.scene.toml", files = folder_.path() / "in" / "a-files";
    fs::create_directories(folder_.path() / "in");
    std::ofstream(folder_.path() / "p.png") << "first";
    WorldFile world;
    world.primitives = {{.type = "sphere"}};
    world.materials = {{.name = "*", .values = {{.key = "color_texture", .words = {"../p.png"}}}}};
    world.render = {{.key = "hdri-file", .words = {"../nowhere.hdr"}}};
    EXPECT_THROW(save_with_files(world, scene.string()), Error);
    EXPECT_FALSE(fs::exists(scene) || fs::exists(files));
    world.render = {{.key = "samples", .words = {"10000000"}}};
    EXPECT_THROW(save_with_files(world, scene.string()), Error);
    EXPECT_FALSE(fs::exists(scene) || fs::exists(files));
    fs::create_directories(scene);  // cannot be written
    fs::create_directories(files);
    std::ofstream(files / "p.png") << "mine";
    world.render.clear();
    EXPECT_THROW(save_with_files(world, scene.string()), Error);
    EXPECT_EQ(std::distance(fs::directory_iterator(files), {}), 1);
    EXPECT_EQ(fs::file_size(files / "p.png"), 4u);
}

TEST_F(Looks, CommandsStepThroughAllChannelsAndBack) {
    const auto m = model(write_model());
    Look look = first_look(*m);
    std::uint32_t seen = 0;
    for (int i = 0; i < 18; ++i) apply(Command::channel, look, *m, width, height), seen |= look.channel;
    EXPECT_EQ(seen, channels_all);
    apply(Command::channel, look, *m, width, height);
    EXPECT_EQ(look.channel, 0u);
    apply(Command::previous_channel, look, *m, width, height);
    EXPECT_EQ(look.channel, std::uint32_t(channel_emission));
}

TEST_F(Looks, ThePainterEndsWithThePictureOfRender) {
    const auto m = model(write_model());
    Look look = first_look(*m);
    look.request.settings.samples = 4;
    Painter painter([] {}, 0, 0);
    painter.paint({.model = m, .look = look, .width = width, .height = height, .number = 1});
    std::shared_ptr<const Painting> last;
    while (!last || !last->is_final) {
        if (auto next = painter.take()) last = next;
        ASSERT_FALSE(painter.take_fault());
        std::this_thread::yield();
    }
    EXPECT_TRUE(last->codes == to_srgb8(drawn(m, look), {}));
    EXPECT_EQ(last->number, 1u);
}

TEST_F(Looks, PicturesInMotionAreNotBrokenOffByTheNext) {
    const auto m = model("builtin:teapot");
    Look look = first_look(*m);
    std::atomic<std::uint64_t> newest = 0, count = 0;
    Painter* painting_of = nullptr;
    Painter painter(
        [&] {  // in the painter's thread, behind each picture: none is missed
            if (const auto painting = painting_of->take()) newest = painting->number, ++count;
        },
        0, 0);
    painting_of = &painter;
    const auto paint = [&](std::uint64_t number) {
        turn_table(moving_eye(look, *m, 640, 480), 0.01, 0, look.world_up);
        painter.paint({.model = m, .look = look, .width = 640, .height = 480, .is_moving = true, .number = number});
    };
    const auto has_begun = [&](std::uint64_t number) {
        std::string stage;
        double fraction = 0;
        painter.progress().get(stage, fraction);
        return !stage.empty() || newest == number;
    };
    for (std::uint64_t number = 2; number <= 20; number += 2) {
        paint(number - 1);
        while (!has_begun(number - 1)) std::this_thread::yield();
        paint(number);
        while (newest != number) std::this_thread::yield();
        EXPECT_EQ(count, number);  // the first one came, too
        std::string stage = "any";
        for (double fraction = 0; !stage.empty(); painter.progress().get(stage, fraction)) std::this_thread::yield();
    }
}

TEST_F(Looks, ThePainterTellsWhatIsWrong) {
    const auto m = model(write_model());
    Look look = first_look(*m);
    look.request.settings.samples = 3;
    Painter painter([] {}, 0, 0);
    painter.paint({.model = m, .look = look, .width = width, .height = height, .number = 7});
    std::optional<Painter::Fault> fault;
    while (!(fault = painter.take_fault())) std::this_thread::yield();
    EXPECT_EQ(fault->number, 7u);
    EXPECT_EQ(fault->error.code(), ErrorCode::usage);
    EXPECT_FALSE(fault->is_of_gl);
}

TEST_F(Looks, APixelIsFoundOnItsMaterial) {
    const auto m = model(write_model());
    const Look look = first_look(*m);
    Painter painter([] {}, 0, 0);
    painter.paint({.model = m, .look = look, .width = width, .height = height, .number = 1});
    int answers = 0;
    std::optional<Painter::Hit> middle, corner;
    painter.look_at_pixel(width / 2 - 12, height / 2, [&](auto hit) { middle = hit, ++answers; });
    painter.look_at_pixel(0, 0, [&](auto hit) { corner = hit, ++answers; });
    while (answers < 2) painter.poll(), std::this_thread::yield();
    ASSERT_TRUE(middle);
    EXPECT_EQ(material_name(m->scene, middle->material), "red");
    EXPECT_LT(middle->position.x, 0);
    EXPECT_FALSE(corner);
}

TEST_F(Looks, AModelKnowsTheFilesThatItIsMadeOf) {
    folder_.write("m.mtl", "newmtl red\nmap_Kd red.png\n");
    std::filesystem::copy_file(test::source_dir() / "data/bricks/normal.png", folder_.file("red.png"));
    folder_.write("model.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl red\nf 1/1 2/1 3/1\n");
    folder_.write("one.scene.toml", "[[model]]\nfile = \"model.obj\"\n");
    const auto m = model(file("one.scene.toml"));
    for (const char* name : {"one.scene.toml", "model.obj", "m.mtl", "red.png"})
        EXPECT_NE(std::ranges::find(m->files, file(name)), m->files.end()) << name;
}

TEST_F(Looks, DroppedFilesAreToldByTheirEndings) {
    const auto plan = [](std::vector<std::string> files, bool is_shift_down = false) {
        return plan_of_drop(files, is_shift_down);
    };
    EXPECT_EQ(plan({"a/B.GLB", "c.obj"}).models, (std::vector<std::string>{"a/B.GLB", "c.obj"}));
    EXPECT_EQ(plan({"sky.HDR"}).environment, "sky.HDR");
    EXPECT_EQ(plan({"wood.png"}).picture, "wood.png");
    EXPECT_EQ(plan({"sky.png"}, true).environment, "sky.png");
    EXPECT_EQ(plan({"notes.txt"}).models.size(), 1u);  // loading it says what is wrong
    const DropPlan beside = plan({"m.mtl", "a.png", "a.obj", "sky.hdr"});
    EXPECT_EQ(beside.models, std::vector<std::string>{"a.obj"});
    EXPECT_TRUE(beside.picture.empty() && beside.environment.empty());
}

TEST_F(Looks, ADroppedFolderIsItsModels) {
    EXPECT_TRUE(plan_of_drop({folder_.path().string()}, false).is_empty_folder);
    write_model();
    std::ofstream(folder_.path() / "settings.toml") << "no world\n";
    const DropPlan plan = plan_of_drop({folder_.path().string()}, false);
    EXPECT_FALSE(plan.is_empty_folder);
    ASSERT_EQ(plan.models.size(), 1u);
    EXPECT_TRUE(plan.models[0].ends_with("model.obj"));
}

TEST(Overlay, SurfacesHideLinesBehindThem) {
    Camera camera;  // at the origin, along -Z
    const std::vector<float> depth(16, 5.0f);
    const std::vector<Line> lines = {
        {{0, 0, -4}, {0, 0.1, -4}}, {{0, 0, -6}, {0, 0.1, -6}}, {{0, 0, -6}, {0, 0.1, -6}, {1, 1, 1, 1}, 1, true}};
    const std::vector<Line> seen = visible_lines(lines, camera, depth, 4, 4, 0.01);
    ASSERT_EQ(seen.size(), 2u);
    EXPECT_EQ(seen[0].from.z, -4);
    EXPECT_TRUE(seen[1].is_overlay);
}

TEST_F(Looks, VectorsStandOnTheirVertices) {
    const auto m = model("builtin:sphere:tolerance=0.05");
    Studio studio;
    Frame frame;
    const Look look = first_look(*m);
    studio.draw(shot(studio, m, look), 0, frame, context_);
    const std::vector<Line> lines = vertex_lines(scene_of(*studio.prepared()), VertexVector::normal, m->box.bounds());
    ASSERT_GT(lines.size(), 20u);
    for (const Line& line : lines) {
        EXPECT_NEAR(length(line.from), 1, 1e-5);
        EXPECT_GT(length(line.to), 1.02);  // out of the sphere
    }
    EXPECT_LE(vertex_lines(scene_of(*studio.prepared()), VertexVector::normal, m->box.bounds(), 10).size(), 10u);
}

}  // namespace
}  // namespace rakelight::viewer
