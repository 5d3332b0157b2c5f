// SPDX-License-Identifier: Apache-2.0
// Names of saved files, and what a saved scene does not hold.
#include "../../../apps/viewer/document/commands.h"
#include "../../../apps/viewer/document/gather.h"
#include "../../../apps/viewer/motion/recorded_keys.h"
#include "looks.h"

namespace rakelight::viewer {
namespace {

TEST_F(Looks, SeamlessModelsGetANameThatIsFree) {
    EXPECT_EQ(free_seamless_name(file("helmet.gltf")), file("helmet-seamless.gltf"));
    folder_.write("helmet-seamless.gltf", "mine");
    folder_.write("helmet-seamless-2.gltf", "mine, too");
    EXPECT_EQ(free_seamless_name(file("helmet.gltf")), file("helmet-seamless-3.gltf"));
    EXPECT_EQ(free_seamless_name(file("part.stl")), file("part-seamless.glb"));
    EXPECT_EQ(free_seamless_name("builtin:teapot"), "teapot-seamless.glb");
    EXPECT_EQ(free_seamless_name("builtin:sphere:tolerance=0.1"), "sphere-tolerance-0.1-seamless.glb");
}

TEST_F(Looks, WhatIsNotSavedIsSaid) {
    const auto m = model(write_model());
    Look look = first_look(*m);
    EXPECT_EQ(not_saved(look), "");
    std::vector<LightItem>& lights = changing_lights(look, *m, width, height);
    EXPECT_EQ(not_saved(look), "");
    lights[0].is_on = false;
    EXPECT_EQ(not_saved(look), "1 light that is off");
    lights[1].is_on = false;
    lights[2].follows_camera = true;
    look.channel = channel_depth;
    EXPECT_EQ(not_saved(look), "2 lights that are off, that 1 light follows the camera, the data channel shown");
}

TEST_F(Looks, RecordedKeysAreSavedAsPaths) {
    const auto m = model(write_model());
    Look look = first_look(*m);
    std::vector<LightItem>& lights = changing_lights(look, *m, width, height);
    lights.assign(2, {.light = {.type = LightType::point, .position = {0, 3, 0}}});
    lights[0].is_on = false;
    Eye& eye = moving_eye(look, *m, width, height);
    eye.position = {0, 1, 8}, eye.focal = {0, 0, 0};
    set_key(look, *m, width, height, 0);
    moving_eye(look, *m, width, height).position = {8, 1, 0};
    (*look.lights)[1].light.position = {4, 3, 0};
    set_key(look, *m, width, height, 2);
    EXPECT_EQ(not_saved(look), "1 light that is off");
    save_with_files(world_of(look, *m, width, height, file("saved.scene.toml")), file("saved.scene.toml"));
    const auto saved = model(file("saved.scene.toml"));
    ASSERT_EQ(saved->scene.cameras.size(), 1u);
    EXPECT_EQ(saved->request.view.camera, "recorded");
    const std::vector<ClipTime> clips = clips_of(saved->scene, {.time_s = 1});
    const Scene half = scene_at(saved->scene, clips);
    const dvec3 seen_from = half.cameras[0].to_world[3].xyz();
    EXPECT_LT(length(seen_from - dvec3{4, 1, 4}), 1e-5);
    EXPECT_LT(length(normalize_or(dvec3{4, 1, 4}, dvec3{}) - half.cameras[0].to_world[2].xyz()), 1e-5);
    ASSERT_EQ(half.lights.size(), 1u);
    EXPECT_LT(length(half.lights[0].position - dvec3{2, 3, 0}), 1e-5);
}

TEST_F(Looks, TheBorderDistanceIsSavedAndCopied) {
    const auto m = model(write_model());
    Look look = first_look(*m);
    EXPECT_EQ(command_line_of(look, *m, width, height).find("border-distance"), std::string::npos);
    look.request.prepare.border_distance = 0.0025;
    EXPECT_NE(command_line_of(look, *m, width, height).find("--border-distance 0.0025"), std::string::npos);
    save_with_files(world_of(look, *m, width, height, file("saved.scene.toml")), file("saved.scene.toml"));
    EXPECT_EQ(model(file("saved.scene.toml"))->request.prepare.border_distance, 0.0025);
}

TEST_F(Looks, NamesOfPicturesAreFreeWithTheirChannels) {
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(folder_.path());
    EXPECT_EQ(free_name("a.b.obj", "", ".png"), "a.b-1.png");
    folder_.write("a.b-1.depth.png", "kept");
    folder_.write("a.b-2.png", "kept");
    folder_.write("a.b-30.png", "kept");
    EXPECT_EQ(free_name("a.b.obj", "", ".png"), "a.b-3.png");
    EXPECT_EQ(free_name("a.b.obj", "-turn", ""), "a.b-turn-1");
    std::filesystem::current_path(before);
}

TEST_F(Looks, FilesAreNamedAsTheirLinksAre) {
    namespace fs = std::filesystem;
    fs::create_directories(folder_.path() / "store");
    fs::rename(write_model(), folder_.path() / "store" / "h1.obj");
    fs::create_symlink("store/h1.obj", folder_.path() / "model.obj");
    const auto m = model(file("model.obj"));
    const WorldFile world = world_of(first_look(*m), *m, width, height, file("saved.scene.toml"));
    EXPECT_EQ(world.models.at(0).file, "model.obj");
}

/// A world in a folder beside that of its model, with settings of its own.
std::string world_with(const test::TemporaryFolder& folder, const std::string& render) {
    return folder.write("world.scene.toml", "[[model]]\nfile = 'model.obj'\n[render]\n" + render);
}

TEST_F(Looks, LightingFilesOfSavedScenesAreFoundFromAnywhere) {
    write_model();
    std::filesystem::create_directories(folder_.path() / "text");
    folder_.write("text/steps.glsl", "user_terms");
    const auto m = model(world_with(folder_, "lighting = 'text/steps.glsl'\n"));
    save_with_files(world_of(first_look(*m), *m, width, height, file("saved.scene.toml")), file("saved.scene.toml"));
    const auto saved = model(file("saved.scene.toml"));
    EXPECT_EQ(saved->request.settings.lighting_text, "user_terms");
    Look look = first_look(*m);
    std::filesystem::create_directories(folder_.path() / "other");
    save_with_files(world_of(look, *m, width, height, file("other/b.scene.toml")), file("other/b.scene.toml"));
    EXPECT_TRUE(std::filesystem::is_regular_file(file("other/b-files/steps.glsl")));
    apply(Command::lighting, look, *m, width, height);
    EXPECT_TRUE(look.request.settings.lighting_text.empty()) << "another lighting model takes its place";
}

TEST_F(Looks, AWorldThatNamesGlslOpensOnlyWhereThatIsAllowed) {
    write_model();
    folder_.write("steps.glsl", "user_terms");
    const std::string world = world_with(folder_, "lighting = 'steps.glsl'\n");
    try {
        load_model(world, {}, context_);
        ADD_FAILURE() << "it is opened";
    } catch (const Error& error) {
        EXPECT_EQ(error.place(), "line 4, column 1");
        EXPECT_EQ(error.related(), std::vector<std::string>{"allow-shaders"});
    }
    const auto m = model(world);
    EXPECT_NE(command_line_of(first_look(*m), *m, width, height).find(" --allow-shaders"), std::string::npos);
}

TEST_F(Looks, ChangedLightsGoOverTheDefaultOnes) {
    write_model();
    const auto m = model(world_with(folder_, "light = 'default'\n"));
    Look look = first_look(*m);
    changing_lights(look, *m, width, height) = {{.light = {.type = LightType::point, .position = {1, 2, 3}}}};
    EXPECT_SAVED_AS_SEEN(look, m);
    const std::string line = command_line_of(look, *m, width, height);
    EXPECT_EQ(line.find("default"), line.npos) << line;
    EXPECT_NE(line.find("--light"), line.npos) << line;
}

TEST_F(Looks, WhatAWorldSetsIsTakenBackOnTheCommandLine) {
    write_model();
    const auto m = model(world_with(folder_, "shadows = true\nsamples = 8\nview = 'top'\n"));
    Look look = first_look(*m);
    EXPECT_EQ(not_on_command_line(look, *m), "");
    look.request.settings.shadows = false;
    look.request.settings.samples = 1;
    moving_eye(look, *m, width, height);
    const std::string line = command_line_of(look, *m, width, height);
    EXPECT_NE(line.find(" --shadows=off"), line.npos) << line;
    EXPECT_EQ(line.find(" --view"), line.npos) << line;
    EXPECT_EQ(not_on_command_line(look, *m), "samples");
}

TEST_F(Looks, AWorldIsSavedAsItWasLoaded) {
    write_model();
    const std::string path = world_with(folder_, "samples = 4\n");
    const auto m = model(path);
    std::filesystem::remove(path);
    const WorldFile world = world_of(first_look(*m), *m, width, height, file("saved.scene.toml"));
    EXPECT_EQ(world.models.at(0).file, "model.obj");
}

TEST_F(Looks, MaterialsOfTheCommandLineAreSavedAsSeen) {
    Start start;
    start.takes = [](std::string_view) { return true; };
    start.settings = {{.key = "material", .words = {"roughness=0.2"}}};
    write_model();
    folder_.write("m.mtl", "newmtl red\nKd 1 0 0\nnewmtl gray\nKd 0.5 0.5 0.5\n");  // no Ks
    folder_.write("world.scene.toml",
                  "[[model]]\nfile = 'model.obj'\n[[primitive]]\ntype = 'sphere'\nmaterial = 'clay'\n"
                  "[[material]]\nname = '*'\nmetallic = 0.1\n[[material]]\nname = 'red'\nroughness = 0.9\n"
                  "[[material]]\nname = 'clay'\nroughness = 0.8\n");
    for (const char* name : {"model.obj", "world.scene.toml"}) {
        const auto m = load_model(file(name), start, context_);
        const Look look = first_look(*m);
        EXPECT_SAVED_AS_SEEN(look, m);
    }
}

}  // namespace
}  // namespace rakelight::viewer
