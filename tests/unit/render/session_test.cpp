// SPDX-License-Identifier: Apache-2.0
// A session gives the pictures that render() gives, takes up only what changed, and says what its engine cannot do.
#include <rakelight/render/session.h>
#include <rakelight/scene/scene_queries.h>

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include <rakelight/render/render.h>

#include "render/engines.h"
#include "render/prepared_scene.h"

#include "support/scene_builder.h"
#include "support/thrown_error.h"
#include "unit/raster/drawn.h"
#include "unit/render/fake_engine.h"

namespace rakelight {
namespace {

using test::FakeEngine, test::same_bits;

Scene two_squares() {
    Scene scene;
    scene.materials.push_back(test::matte({0.8f, 0.5f, 0.2f}));
    test::add_object(scene, test::square_mesh(0));
    test::add_object(scene, test::square_mesh(0), translation(dvec3{0.5, 0.2, 0.5}));
    return scene;
}

RenderSettings small() {
    RenderSettings s;
    s.width = 48, s.height = 32;
    return s;
}

Camera from(double x) {
    Camera camera = test::flat_camera();
    camera.to_world = translation(dvec3{x, 0, 0}) * camera.to_world;
    return camera;
}

/// A session of the fake engine, which counts.
struct Counted {
    Session session{std::make_unique<FakeEngine>()};
    const FakeEngine& engine = static_cast<const FakeEngine&>(session.engine());
    Context context{{.threads = 1}};
    Frame frame;

    void draw(const Camera& camera = from(0), const RenderSettings& settings = small()) {
        session.render(camera, settings, frame, context);
    }
};

TEST(Session, GivesThePicturesOfRender) {
    Context context({.threads = 1});
    Session session;
    session.set(two_squares());
    for (const double x : {0.0, 0.7, -0.4}) {
        Frame frame;
        session.render(from(x), small(), frame, context);
        EXPECT_TRUE(same_bits(frame, render(two_squares(), from(x), small(), context))) << x;
    }
}

TEST(Session, TheDefaultRigStandsWithTheCamera) {
    Counted c;
    c.session.set(two_squares());
    c.draw();
    EXPECT_EQ(c.engine.prepared.lights, default_lights(from(0).to_world));
    c.draw(from(0.5));
    EXPECT_EQ(c.engine.prepared.lights, default_lights(from(0.5).to_world));
    EXPECT_EQ(c.engine.times_prepared, 1) << "other lights are no other scene";
}

TEST(Session, TheSameSceneIsTakenUpOnce) {
    Counted c;
    Scene scene = two_squares();
    scene.lights = {test::directional({0, 0, -1})};
    c.session.set(scene);
    for (const double x : {0.0, 0.5, 1.0}) c.draw(from(x));
    EXPECT_EQ(c.engine.times_prepared, 1);
    EXPECT_EQ(c.engine.lights_set, 0);
}

TEST(Session, OtherLightsFogAndEnvironmentMakeNothingAnew) {
    Counted c;
    Scene scene = two_squares();
    scene.lights = {test::directional({0, 0, -1})};
    c.session.set(scene);
    c.draw();
    const Scene before = c.engine.prepared;
    scene.lights[0].diffuse = {0.5f, 0.5f, 0.5f};
    scene.fog.kind = FogKind::exponential;
    c.session.set(scene);
    c.draw();
    EXPECT_EQ(c.engine.prepared.meshes, before.meshes) << "the made normals stay";
    EXPECT_EQ(c.engine.prepared.lights, scene.lights);
    EXPECT_EQ(c.engine.prepared.fog, scene.fog);
}

TEST(Session, AnEditedSceneIsDrawnAsIfItHadAlwaysBeenSo) {
    Context context({.threads = 1});
    Session session;
    Scene scene = two_squares();
    session.set(scene);
    Frame frame;
    session.render(from(0), small(), frame, context);
    scene.materials[0].base_color = {0.1f, 0.9f, 0.3f, 1};
    scene.nodes[1].local.translation = {-0.5, 0, 0.5};
    session.set(scene);
    session.render(from(0), small(), frame, context);
    EXPECT_TRUE(same_bits(frame, render(scene, from(0), small(), context)));
}

TEST(Session, SettingsThatNeedAnotherPreparationGetIt) {
    Context context({.threads = 1});
    Session session;
    session.set(two_squares());
    const auto first = session.prepared(small(), context);
    EXPECT_EQ(session.prepared(small(), context), first);
    RenderSettings clockwise = small();
    clockwise.front_face = FrontFace::clockwise;
    EXPECT_NE(session.prepared(clockwise, context), first);
    Frame frame;
    session.render(from(0), clockwise, frame, context);
    EXPECT_TRUE(same_bits(frame, render(two_squares(), from(0), clockwise, context)));
}

/// Rays are there.
bool has_radiosity() {
    const std::vector<std::string> names = engine_names();
    return std::find(names.begin(), names.end(), "trace") != names.end();
}

RenderSettings by_radiosity() {
    RenderSettings s = small();
    s.method = RayMethod::radiosity, s.radiosity.elements = 200;
    return s;
}

TEST(Session, RadiosityIsWorkedOutOnceForASceneAndItsLights) {
    if (!has_radiosity()) GTEST_SKIP();
    Counted c;
    Scene scene = two_squares();
    scene.lights = {test::directional({0, 0, -1})};
    c.session.set(scene);
    const auto lit = c.session.prepared(by_radiosity(), c.context);
    for (const double x : {0.0, 0.5, 1.0}) c.draw(from(x), by_radiosity());
    EXPECT_EQ(c.engine.times_prepared, 1);
    EXPECT_EQ(c.session.prepared(by_radiosity(), c.context), lit);
    EXPECT_TRUE(c.engine.prepared.lights.empty()) << "the light is in the colors";
    EXPECT_FALSE(c.engine.prepared.meshes[0].colors.empty());
    scene.lights[0].diffuse = {0.5f, 0.5f, 0.5f};
    c.session.set(scene);
    EXPECT_NE(c.session.prepared(by_radiosity(), c.context), lit);
    c.draw(from(0), small());
    EXPECT_EQ(c.engine.prepared.lights, scene.lights) << "another method has the lights again";
    EXPECT_TRUE(c.engine.prepared.meshes[0].colors.empty());
}

TEST(Session, EveryEngineDrawsRadiosityAlike) {
    if (!has_radiosity()) GTEST_SKIP();
    Frame frames[2];
    for (int i = 0; i < 2; ++i) {
        Context context({.threads = 1});
        Session session(i == 0 ? "soft" : "trace");
        Scene scene = two_squares();
        scene.lights = {test::directional({0.3, 0.2, -1})};
        session.set(scene);
        session.render(from(0), by_radiosity(), frames[i], context);
    }
    ASSERT_EQ(frames[0].color.size(), frames[1].color.size());
    double difference = 0, sum = 0;
    for (std::size_t i = 0; i < frames[0].color.size(); ++i) {
        difference += std::fabs(double(frames[0].color[i].x) - double(frames[1].color[i].x));
        sum += double(frames[0].color[i].x);
    }
    EXPECT_LT(difference, 0.01 * sum);
    EXPECT_GT(sum / double(frames[0].color.size()), 0.3);
}

TEST(Session, APreparedSceneIsSharedAndDrawnAsItIs) {
    Context context({.threads = 1});
    Session maker;
    Scene lit = two_squares();
    lit.lights = {test::directional({0, 0, -1})};
    maker.set(lit);
    const auto prepared = maker.prepared(small(), context);
    Counted other;
    other.session.set(prepared);
    other.draw();
    EXPECT_EQ(other.engine.prepared.meshes, scene_of(*prepared).meshes);
    EXPECT_EQ(other.engine.prepared.lights, lit.lights);
}

TEST(Session, APreparedSceneWithoutLightsGetsTheDefaultRigWhereverItIsDrawn) {
    Context context({.threads = 1});
    Session maker, other;
    maker.set(two_squares());
    other.set(maker.prepared(small(), context));
    Frame by_maker, by_other;
    maker.render(from(0.2), small(), by_maker, context);
    other.render(from(0.2), small(), by_other, context);
    EXPECT_TRUE(same_bits(by_maker, by_other));
}

/// Squares of which the first goes to the right, and a camera and a lamp that a second clip moves.
std::shared_ptr<const Scene> moving_squares() {
    Scene scene = two_squares();
    scene.source = "moving";
    scene.nodes[0].local = {};
    scene.lights = {test::directional({0, 0, -1})};
    scene.cameras = {Camera{}};
    const auto channel = [](AnimationPath path, const char* property, std::vector<float> values) {
        AnimationChannel c{.element = 0, .path = path, .property = property};
        c.times = std::vector<float>{0, 1};
        c.values = std::move(values);
        return c;
    };
    scene.animations = {{.name = "slide", .channels = {channel(AnimationPath::translation, "", {0, 0, 0, 1, 0, 0})}},
                        {.name = "dim", .channels = {channel(AnimationPath::light, "diffuse", {1, 1, 1, 0, 0, 0})}}};
    return std::make_shared<const Scene>(std::move(scene));
}

TEST(Session, ShowsALoadedSceneAtMomentsAndMakesAnewWhatMoves) {
    Counted c;
    const std::shared_ptr<const Scene> loaded = moving_squares();
    const PictureRequest request;
    const auto show = [&](std::vector<ClipTime> clips, double x = 0) {
        const Scene& scene = c.session.show(loaded, request, clips, c.context);
        c.session.render({from(x), small(), scene.lights}, c.frame, c.context);
    };
    show({});
    const auto posts = [&] { return c.engine.prepared.meshes.at(1).positions.identity(); };
    const void* const post = posts();
    for (const double x : {0.5, 1.0}) show({}, x);
    EXPECT_EQ(c.engine.times_prepared, 1) << "the camera alone has moved";
    show({{0, 0.5}});
    EXPECT_EQ(c.engine.times_prepared, 2);
    EXPECT_EQ(posts(), post) << "what does not move is not made anew, also where it was at rest before";
    show({{0, 0.5}, {1, 0.5}});
    const int prepared = c.engine.times_prepared;
    EXPECT_FLOAT_EQ(c.engine.prepared.lights.at(0).diffuse.x, 0.5f);
    show({{0, 0.5}, {1, 1.0}});
    EXPECT_EQ(c.engine.times_prepared, prepared) << "lights alone have changed";
    EXPECT_FLOAT_EQ(c.engine.prepared.lights.at(0).diffuse.x, 0);
}

TEST(Session, WhatCannotBeShownIsSaidAndLeavesTheSceneBefore) {
    Counted c;
    const std::shared_ptr<const Scene> loaded = moving_squares();
    PictureRequest plain, red, missing;
    red.materials.color = vec3{1, 0, 0};
    missing.materials.base_color = "no such picture.png";
    const auto code_of = [&](const std::shared_ptr<const Scene>& scene, const PictureRequest& request, ClipTime clip) {
        return test::error_of([&] { c.session.show(scene, request, {&clip, 1}, c.context); }).code();
    };
    c.session.show(loaded, plain, {}, c.context);
    for (const PictureRequest& request : {plain, red}) {
        EXPECT_EQ(code_of(loaded, request, {7, 0}), ErrorCode::usage);
        EXPECT_EQ(code_of(loaded, request, {0, std::nan("")}), ErrorCode::usage);
    }
    EXPECT_EQ(code_of(nullptr, plain, {0, 0}), ErrorCode::usage);
    EXPECT_EQ(code_of(loaded, missing, {0, 0}), ErrorCode::not_found);
    c.draw();
    EXPECT_EQ(c.engine.prepared.materials.at(0).base_color, loaded->materials[0].base_color);
    c.session.show(loaded, red, {}, c.context);
    c.draw();
    EXPECT_EQ(c.engine.prepared.materials.at(0).base_color, (vec4{1, 0, 0, 1}));
}

TEST(Session, LightsOfAShotAreAllItsLights) {
    Counted c;
    c.session.set(two_squares());
    c.session.render({from(0), small(), {}}, c.frame, c.context);
    EXPECT_EQ(c.engine.prepared.lights, default_lights(from(0).to_world)) << "absent: the default rig";
    c.session.render({from(0), small(), std::vector<Light>()}, c.frame, c.context);
    EXPECT_TRUE(c.engine.prepared.lights.empty()) << "none";
    const std::vector<Light> lamp = {test::directional({0, 0, -1})};
    c.session.render({from(0), small(), lamp}, c.frame, c.context);
    EXPECT_EQ(c.engine.prepared.lights, lamp);
    Light on_no_node = lamp[0];
    on_no_node.node = 9;
    const Shot wrong{from(0), small(), std::vector{on_no_node}};
    EXPECT_EQ(test::error_of([&] { c.session.render(wrong, c.frame, c.context); }).code(), ErrorCode::bad_file);
    EXPECT_EQ(c.engine.times_prepared, 1);
}

TEST(Session, TheSceneOfASinglePictureGoesToTheEngineUncopied) {
    Counted c;
    const Scene copy = two_squares();
    c.session.set_single(copy, {});
    c.draw();
    c.draw(from(0.4));
    EXPECT_EQ(c.engine.times_prepared, 1);
    const std::vector<Light> lamp = {test::directional({0, 0, -1})};
    c.session.render({from(0), small(), lamp}, c.frame, c.context);
    EXPECT_EQ(c.engine.prepared.lights, lamp);
    EXPECT_EQ(c.engine.prepared.nodes, copy.nodes);
    EXPECT_EQ(scene_of(*c.session.prepared(small(), c.context)).nodes, copy.nodes);
    c.session.set(two_squares());
    c.draw();
    EXPECT_EQ(c.engine.times_prepared, 2);
}

TEST(Session, LightsOfASinglePictureAreThoseOfEachShot) {
    Counted c;
    Scene dark = two_squares();
    dark.lights.clear();
    c.session.set_single(dark, {});
    const std::vector<Light> lamp = {test::directional({0, 0, -1})};
    c.session.render({from(0), small(), lamp}, c.frame, c.context);
    EXPECT_EQ(c.engine.prepared.lights, lamp);
    c.draw(from(0));
    EXPECT_EQ(c.engine.prepared.lights, default_lights(from(0).to_world)) << "the scene has no lights";
    Camera beside = from(0);
    beside.to_world = look_at({9, 0, 0}, {0, 0, 0}, {0, 1, 0});
    c.draw(beside);
    EXPECT_EQ(c.engine.prepared.lights, default_lights(beside.to_world));
    EXPECT_NE(c.engine.prepared.lights, default_lights(from(0).to_world));
    EXPECT_EQ(c.engine.times_prepared, 1);
}

TEST(Session, AWrongLightLeavesTheSceneOfASinglePicture) {
    Counted c;
    c.session.set_single(two_squares(), {});
    Light on_no_node = test::directional({0, 0, -1});
    on_no_node.node = 9;
    const Shot wrong{from(0), small(), std::vector{on_no_node}};
    EXPECT_EQ(test::error_of([&] { c.session.render(wrong, c.frame, c.context); }).code(), ErrorCode::bad_file);
    EXPECT_NO_THROW(c.draw());
}

TEST(Session, AnEngineThatFailsToTakeItsSceneUpLeavesNone) {
    Counted c;
    FakeEngine& engine = const_cast<FakeEngine&>(c.engine);
    c.session.set_single(two_squares(), {});
    engine.fails = true;
    EXPECT_EQ(test::error_of([&] { c.draw(); }).reason(), "it fails");
    engine.fails = false;
    EXPECT_EQ(test::error_of([&] { c.draw(); }).reason(), "the session has no scene");
    c.session.set(two_squares());
    engine.fails = true;
    EXPECT_EQ(test::error_of([&] { c.draw(); }).reason(), "it fails");
    engine.fails = false;
    EXPECT_NO_THROW(c.draw()) << "its own scene is still there";
}

TEST(Session, RadiosityThatIsCancelledLeavesNoSinglePicture) {
    Counted c;
    Shot shot{from(0), small(), std::vector{test::directional({0, 0, -1})}};
    shot.settings.method = RayMethod::radiosity;
    c.session.set_single(two_squares(), {});
    c.context.cancel();
    EXPECT_EQ(test::error_of([&] { c.session.prepared_for(shot, c.context); }).reason(), "cancelled");
    c.context.reset_cancel();
    EXPECT_EQ(test::error_of([&] { c.session.prepared_for(shot, c.context); }).reason(), "the session has no scene");
    EXPECT_EQ(c.engine.times_prepared, 0);
}

TEST(Session, NeedsAnEngineAndAScene) {
    EXPECT_EQ(test::error_of([] { Session(std::unique_ptr<Engine>()); }).code(), ErrorCode::usage);
    Counted c;
    EXPECT_EQ(test::error_of([&] { c.draw(); }).reason(), "the session has no scene");
    EXPECT_EQ(test::error_of([&] { c.session.prepared(small(), c.context); }).reason(), "the session has no scene");
    EXPECT_EQ(test::error_of([&] { c.session.set(std::shared_ptr<const PreparedScene>()); }).code(), ErrorCode::usage);
}

TEST(Session, ReliefIsPreparedAnewOnlyWhereItDisplaces) {
    Counted c;
    c.session.set(two_squares());
    RenderSettings deeper = small();
    deeper.relief.depth = 0.07f;
    c.draw();
    c.draw(from(0), deeper);
    EXPECT_EQ(c.engine.times_prepared, 1);
}

TEST(Session, ACameraOfTheSceneMayHangFromANode) {
    Context context({.threads = 1});
    Scene scene = two_squares();
    scene.nodes.push_back({.name = "eye"});
    scene.nodes.back().local.translation = {0.3, 0, 5};
    Camera camera;
    camera.node = 2;
    scene.cameras = {camera};
    Session session;
    session.set(scene);
    Frame frame;
    session.render(scene.cameras[0], small(), frame, context);
    EXPECT_TRUE(same_bits(frame, render(scene, scene.cameras[0], small(), context)));
}

TEST(Session, WhatIsWrongLeavesTheSceneBefore) {
    Counted c;
    EXPECT_EQ(test::error_of([&] { c.draw(); }).reason(), "the session has no scene");
    c.session.set(two_squares());
    Scene broken = two_squares();
    broken.nodes[0].meshes = {7};
    EXPECT_EQ(test::error_of([&] { c.session.set(broken); }).code(), ErrorCode::bad_file);
    EXPECT_EQ(test::error_of([&] { c.session.set(Scene{}); }).code(), ErrorCode::bad_file);
    EXPECT_EQ(test::error_of([&] { c.session.set(std::shared_ptr<const PreparedScene>()); }).code(), ErrorCode::usage);
    c.draw();
    EXPECT_EQ(c.engine.prepared.nodes.size(), 2u);
    EXPECT_EQ(test::error_of([] { Session("none of these"); }).code(), ErrorCode::usage);
}

TEST(Session, WhatAnEngineCannotDoIsRefusedByName) {
    auto engine = std::make_unique<FakeEngine>();
    engine->can = {.channels = channel_depth};
    Session session(std::move(engine));
    session.set(two_squares());
    Context context({.threads = 1});
    Frame frame;
    const auto reason_of = [&](const auto& change) {
        RenderSettings s = small();
        change(s);
        return test::error_of([&] { session.render(from(0), s, frame, context); }).reason();
    };
    EXPECT_EQ(reason_of([](RenderSettings& s) { s.channels = channel_depth | channel_overdraw; }),
              "engine fake cannot give the data channel overdraw");
    EXPECT_EQ(reason_of([](RenderSettings& s) { s.samples = 4; }),
              "engine fake cannot take 4 samples per pixel, only 1");
    EXPECT_EQ(reason_of([](RenderSettings& s) { s.visibility = Visibility::painter; }),
              "engine fake cannot use another method of hidden-surface removal than its own: engine soft does");
    EXPECT_EQ(reason_of([](RenderSettings& s) { s.interpolation = AttributeInterpolation::screen; }),
              "engine fake cannot interpolate attributes on the screen");
    EXPECT_EQ(reason_of([](RenderSettings& s) { s.edges = true; }), "engine fake cannot draw edges and vertices");
    EXPECT_EQ(reason_of([](RenderSettings& s) { s.shadows = true; }), "engine fake cannot draw shadows");
    RenderSettings s = small();
    s.channels = channel_depth;
    EXPECT_NO_THROW(session.render(from(0), s, frame, context));
}

/// [bytes] Resident memory of this process.
std::int64_t resident() {
    std::int64_t pages = 0, of_them = 0;
    std::ifstream("/proc/self/statm") >> pages >> of_them;
    return of_them * ::sysconf(_SC_PAGESIZE);
}

TEST(Session, MemoryIsFlatOverTwoThousandPictures) {
    Context context({.threads = 1});
    Session session;
    session.set(two_squares());
    Frame frame;
    const auto draw = [&](int n) {
        for (int i = 0; i < n; ++i) session.render(from(0.01 * (i % 50)), small(), frame, context);
        return context.memory().charged();
    };
    const auto after_few = draw(400);
    const std::int64_t before = resident();
    EXPECT_EQ(draw(1600), after_few);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    EXPECT_LT(resident() - before, 1 << 20);
#else
    static_cast<void>(before);  // a sanitizer keeps what is freed
#endif
}

}  // namespace
}  // namespace rakelight
