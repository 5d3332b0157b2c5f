// SPDX-License-Identifier: Apache-2.0
#include "../../../apps/viewer/document.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <rakelight/linear.h>
#include <rakelight/render.h>

#include "../../../apps/viewer/load_model.h"
#include "../../../apps/viewer/overlay.h"
#include "../../../apps/viewer/painter.h"
#include "../../../apps/viewer/save.h"
#include "../../../apps/viewer/studio.h"
#include "support/temporary_folder.h"

namespace rakelight::viewer {
namespace {

constexpr int width = 96, height = 64;

class Looks : public testing::Test {
protected:
    /// Two squares of two materials, one of them with a texture's coordinates, and a lamp.
    std::string write_model() {
        std::ofstream(folder_.path() / "m.mtl")
            << "newmtl red\nKd 1 0 0\nKs 0.4 0.4 0.4\nNs 20\nnewmtl gray\nKd 0.5 0.5 0.5\n";
        std::ofstream(folder_.path() / "model.obj")
            << "mtllib m.mtl\no left\nv -2 -1 0\nv 0 -1 0\nv 0 1 0.6\nv -2 1 0\nusemtl red\nf 1 2 3 4\n"
               "o right\nv 0 -1 0\nv 2 -1 0\nv 2 1 0\nv 0 1 0.6\nusemtl gray\nf 5 6 7 8\n";
        return (folder_.path() / "model.obj").string();
    }
    std::shared_ptr<const Model> model(const std::string& file) {
        Start start;
        start.takes = [](std::string_view) { return true; };
        return load_model(file, start, context_);
    }
    Frame drawn(const std::shared_ptr<const Model>& model, const Look& look) {
        Studio studio;
        Frame frame;
        studio.draw(model, look, request_of(look, width, height), camera_of(look, *model, width, height), 0, frame,
                    context_);
        return frame;
    }
    std::string file(const char* name) { return (folder_.path() / name).string(); }

    test::TemporaryFolder folder_;
    Context context_;
};

/// The picture of what is saved is the picture of what was seen.
#define EXPECT_SAVED_AS_SEEN(look, of)                                                                        \
    do {                                                                                                      \
        save_world(world_of(look, *(of), width, height, file("saved.scene.toml")), file("saved.scene.toml")); \
        const auto saved = model(file("saved.scene.toml"));                                                   \
        const Look back = first_look(*saved);                                                                 \
        const dvec3 moved = camera_of(back, *saved, width, height).to_world[3].xyz() -                        \
                            camera_of(look, *(of), width, height).to_world[3].xyz();                          \
        EXPECT_LT(length(moved), 1e-12);                                                                      \
        EXPECT_TRUE(drawn(saved, back).color == drawn(of, look).color);                                       \
    } while (false)

TEST_F(Looks, AFirstLookIsSavedAsSeen) {
    const auto m = model(write_model());
    EXPECT_SAVED_AS_SEEN(first_look(*m), m);
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
    set_material(look, "red", "color=0,0.7,0.1");
    set_material(look, "red", "color=0,0.7,0.2");
    set_material(look, "red", "shininess=5");
    set_material(look, "gray", "roughness=0.3");
    EXPECT_EQ(look.materials.size(), 2u);
    EXPECT_EQ(look.materials[0].values.size(), 2u);
    EXPECT_FALSE(drawn(m, look).color == before.color);
    EXPECT_SAVED_AS_SEEN(look, m);
    EXPECT_THROW(set_material(look, "red", "no_such_key=1"), Error);
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
    set_material(look, "red", "color=1,1,0");
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

TEST_F(Looks, PicturesComeWhileTheCameraMovesOnAndOn) {
    using Clock = std::chrono::steady_clock;
    const auto m = model("builtin:teapot");
    Look look = first_look(*m);
    Painter painter([] {}, 0, 0);
    std::uint64_t number = 0;
    // Until `count` pictures are there, with a job a millisecond where the camera moves.
    const auto time_of = [&](int count, bool is_moving) {
        const auto begin = Clock::now();
        for (int pictures = 0; pictures < count;) {
            if (is_moving) turn_table(moving_eye(look, *m, 1280, 960), 0.01, 0, look.world_up);
            if (is_moving || number == 0)
                painter.paint({.model = m,
                               .look = look,
                               .width = 1280,
                               .height = 960,
                               .is_moving = is_moving,
                               .number = ++number});
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            const auto painting = painter.take();
            if (painting && (is_moving || painting->is_final)) ++pictures;
        }
        return Clock::now() - begin;
    };
    const auto one = time_of(1, false);
    EXPECT_LT(time_of(5, true), 10 * one);  // were they broken off by the next, few would come at all
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
    painter.look_at_pixel(width / 2 - 8, height / 2, [&](auto hit) { middle = hit, ++answers; });
    painter.look_at_pixel(0, 0, [&](auto hit) { corner = hit, ++answers; });
    while (answers < 2) painter.poll(), std::this_thread::yield();
    ASSERT_TRUE(middle);
    EXPECT_EQ(material_name(m->scene, middle->material), "red");
    EXPECT_LT(middle->position.x, 0);
    EXPECT_FALSE(corner);
}

TEST_F(Looks, DroppedFilesAreToldByTheirEndings) {
    EXPECT_EQ(kind_of_drop("a/B.GLB", false), Dropped::model);
    EXPECT_EQ(kind_of_drop("sky.HDR", false), Dropped::environment);
    EXPECT_EQ(kind_of_drop("wood.png", false), Dropped::picture);
    EXPECT_EQ(kind_of_drop("sky.png", true), Dropped::environment);
    write_model();
    const std::vector<std::string> models = models_in(folder_.path().string());
    ASSERT_EQ(models.size(), 1u);
    EXPECT_TRUE(models[0].ends_with("model.obj"));
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
    studio.draw(m, look, request_of(look, width, height), camera_of(look, *m, width, height), 0, frame, context_);
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
