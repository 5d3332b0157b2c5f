// SPDX-License-Identifier: Apache-2.0
// GlView in a context of its caller's: pictures shown, scenes drawn, lines over both. Skipped where there is no OpenGL.
#include <rakelight/render/gl_view.h>
#include <rakelight/render/shot.h>

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include <rakelight/render/render.h>

#include "math/color.h"
#include "support/gl_context.h"
#include "support/scene_builder.h"
#include "support/thrown_error.h"

namespace rakelight {
namespace {

constexpr int width = 60, height = 40;

Scene red_square() {
    Scene scene;
    scene.materials.push_back(test::matte({1, 0, 0}));
    scene.materials[0].classical.ambient = {1, 0, 0};
    test::add_object(scene, test::square_mesh(0, 0.5f));
    Light light;
    light.type = LightType::ambient;
    light.ambient = {1, 1, 1};
    scene.lights = {light};
    return scene;
}

std::shared_ptr<const PreparedScene> prepared(const Scene& scene) {
    Context context({.threads = 1});
    Session session;
    session.set(scene);
    return session.prepared({}, context);
}

class GlViews : public testing::Test {
protected:
    void SetUp() override {
        ::setenv("RAKELIGHT_GL_CACHE", "off", 1);
        std::string why;
        gl = test::GlContext::make(test::GlFlavour::core_33, why);
        if (!gl) GTEST_SKIP() << why;
        GLuint color = 0, frame = 0;
        glGenRenderbuffers(1, &color);
        glBindRenderbuffer(GL_RENDERBUFFER, color);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width + 7, height + 5);
        glGenFramebuffers(1, &frame);
        glBindFramebuffer(GL_FRAMEBUFFER, frame);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
        glViewport(7, 5, width, height);
        settings.width = width, settings.height = height;
    }
    /// Row 0 on top, of the viewport.
    std::vector<std::uint32_t> screen() {
        std::vector<std::uint32_t> rows(width * height), out;
        glReadPixels(7, 5, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
        for (int y = height - 1; y >= 0; --y)
            out.insert(out.end(), rows.begin() + y * width, rows.begin() + (y + 1) * width);
        return out;
    }
    static std::uint32_t at(const std::vector<std::uint32_t>& s, int x, int y) {
        return s[std::size_t(y * width + x)] & 0xFFFFFFu;
    }
    Shot shot_by(const ToneSettings& tone) {
        PictureRequest request;
        request.settings = settings, request.tone = tone;
        return plan_shot(red_square(), request, camera, {}, context);
    }
    void upload(GlView& view, const Scene& scene) {
        const auto ready = prepared(scene);
        while (!view.upload(ready, 5, context)) {
        }
    }

    std::unique_ptr<test::GlContext> gl;
    Context context{{.threads = 1}};
    RenderSettings settings;
    Camera camera = test::flat_camera();
};

TEST_F(GlViews, CodesAreShownAsTheyAre) {
    GlView view;
    std::vector<std::uint32_t> codes;
    for (std::uint32_t i = 0; i < width * height; ++i) codes.push_back(0xFF000000u | i * 2654435761u >> 8);
    view.show(width, height, codes, false);
    EXPECT_EQ(screen(), codes);
    EXPECT_EQ(test::error_of([&] { view.show(width, height + 1, codes); }).code(), ErrorCode::usage);
}

TEST_F(GlViews, ThePictureThatWasShownIsShownAgain) {
    GlView view;
    EXPECT_FALSE(view.show_again()) << "there is none";
    std::vector<std::uint32_t> codes;
    for (std::uint32_t i = 0; i < width * height; ++i) codes.push_back(0xFF000000u | i * 2654435761u >> 8);
    view.show(width, height, codes, false);
    upload(view, red_square());
    view.draw({camera, settings}, {}, context);
    EXPECT_NE(screen(), codes);
    EXPECT_TRUE(view.show_again());
    EXPECT_EQ(screen(), codes);
    const Line behind{.from = {-0.9, 0, -0.5}, .to = {0.9, 0, -0.5}, .color = {1, 1, 1, 1}, .width_px = 3};
    view.lines(camera, {&behind, 1});
    EXPECT_EQ(at(screen(), width / 2, height / 2), 0xFFFFFFu) << "nothing hides lines over a picture";
}

/// A square that follows a joint, which stands at x.
Scene square_on_joint(double x) {
    Scene scene = red_square();
    scene.meshes[0].influences = std::vector<JointInfluence>(4, {{0, 0, 0, 0}, {1, 0, 0, 0}});
    scene.nodes[0].skin = 0;
    scene.nodes.emplace_back();
    scene.skins.push_back({"bone", {1}, {dmat4{}}});
    ScenePose pose;
    for (const Node& node : scene.nodes) pose.local.push_back(node.local), pose.morph_weights.emplace_back();
    pose.local[1].translation = {x, 0, 0};
    scene.pose = pose;
    return scene;
}

TEST_F(GlViews, MeshesThatMoveAreDrawnWhereTheyStand) {
    for (const char* const who : {"gpu", "cpu"}) {
        ::setenv("RAKELIGHT_GL_POSES", who, 1);
        GlView view;
        Session session;
        for (const double x : {0.0, 0.75, -0.75}) {
            session.set(square_on_joint(x));
            const auto ready = session.prepared(settings, context);
            while (!view.upload(ready, 5, context)) {
            }
            view.draw({camera, settings}, {}, context);
            const auto is_red = [&](int column) { return (at(screen(), column, height / 2) & 0xFFu) > 200; };
            EXPECT_EQ(is_red(width / 2), x == 0) << who << x;
            EXPECT_EQ(is_red(width / 2 + 15), x > 0) << who << x;
            EXPECT_EQ(is_red(width / 2 - 15), x < 0) << who << x;
        }
    }
    ::unsetenv("RAKELIGHT_GL_POSES");
}

TEST_F(GlViews, TheBoundFramebufferAndItsViewportStay) {
    GlView view;
    upload(view, red_square());
    view.draw({camera, settings}, {}, context);
    GLint box[4];
    glGetIntegerv(GL_VIEWPORT, box);
    EXPECT_EQ(box[0], 7);
    EXPECT_EQ(box[2], width);
    EXPECT_EQ(at(screen(), width / 2, height / 2), 0x0000FFu);
}

TEST_F(GlViews, ASceneIsDrawnAsTheEngineDrawsIt) {
    GlView view;
    upload(view, red_square());
    settings.background = {0.2f, 0.3f, 0.4f, 1};
    const ToneSettings tone{.mapping = ToneMapping::aces, .exposure_ev = 0.5};
    const Shot shot = shot_by(tone);
    view.draw(shot, tone, context);
    Session session("gl");
    session.set(red_square());
    Frame frame;
    session.render(shot, frame, context);
    const std::vector<std::uint32_t> got = screen(), expected = to_srgb8(frame, tone, shot.behind);
    for (std::size_t i = 0; i < got.size(); ++i)
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(got[i] >> 8 * c & 255, expected[i] >> 8 * c & 255, 1) << "pixel " << i;
}

TEST_F(GlViews, AFrameIsShownOverItsBackgroundAsItsCodesAre) {
    GlView view;
    settings.background = {0.2f, 0.3f, 0.4f, 1};
    const ToneSettings tone{.mapping = ToneMapping::aces, .exposure_ev = 0.5};
    const Shot shot = shot_by(tone);
    Session session;
    session.set(red_square());
    Frame frame;
    session.render(shot, frame, context);
    view.show(frame, tone, shot.behind);
    const std::vector<std::uint32_t> got = screen(), expected = to_srgb8(frame, tone, shot.behind);
    for (std::size_t i = 0; i < got.size(); ++i)
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(got[i] >> 8 * c & 255, expected[i] >> 8 * c & 255, 1) << "pixel " << i;
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(at(got, 0, 0) >> 8 * c & 255, srgb8_from_linear(settings.background[std::size_t(c)]), 1);
}

TEST_F(GlViews, UntilASceneIsWholeTheOneBeforeIsDrawn) {
    GlView view;
    upload(view, red_square());
    Scene other = red_square();
    other.materials[0].classical.ambient = {0, 1, 0};
    const auto next = prepared(other);
    EXPECT_FALSE(view.upload(next, 0, context)) << "no time, nothing done";
    view.draw({camera, settings}, {}, context);
    EXPECT_EQ(at(screen(), width / 2, height / 2), 0x0000FFu);
    while (!view.upload(next, 5, context)) {
    }
    view.draw({camera, settings}, {}, context);
    EXPECT_EQ(at(screen(), width / 2, height / 2), 0x00FF00u);
    EXPECT_TRUE(view.upload(next, 0, context)) << "it is there";
}

TEST_F(GlViews, ASceneThatTakesThePlaceOfOneOnItsWayIsTheOneThatComes) {
    GlView view;
    Scene green = red_square();
    green.materials[0].classical.ambient = {0, 1, 0};
    EXPECT_FALSE(view.upload(prepared(red_square()), 0, context));
    upload(view, green);
    view.draw({camera, settings}, {}, context);
    EXPECT_EQ(at(screen(), width / 2, height / 2), 0x00FF00u);
}

TEST_F(GlViews, AfterAPictureOfAnotherSceneItsCountsAreForgotten) {
    GlView view;
    upload(view, red_square());
    view.draw({camera, settings}, {}, context);
    Scene many = red_square();
    for (int i = 0; i < 100; ++i) test::add_object(many, test::square_mesh(0, 0.1f));
    upload(view, many);
    view.draw({camera, settings}, {}, context);
    view.draw({camera, settings}, {}, context);
    EXPECT_EQ(at(screen(), width / 2, height / 2), 0x0000FFu);
}

TEST_F(GlViews, UploadsThatAreGivenUpLeaveNothingBehind) {
    GlView view;
    for (int i = 0; i < 20; ++i) {  // each at the addresses of the one before
        Scene scene = red_square();
        scene.materials[0].classical.ambient = {0, 0, 1};
        for (int k = 0; k < 5; ++k) test::add_object(scene, test::square_mesh(0, 0.1f + 0.01f * float(i + k)));
        const auto next = prepared(scene);
        for (int k = 0; k < 3; ++k) view.upload(next, k == 0 ? 20 : 0, context);
    }
    upload(view, red_square());
    view.draw({camera, settings}, {}, context);
    const std::vector<std::uint32_t> s = screen();
    GlView fresh;
    upload(fresh, red_square());
    fresh.draw({camera, settings}, {}, context);
    EXPECT_EQ(s, screen());
}

TEST_F(GlViews, WhatTheCallerSetOfTheContextDoesNotMatter) {
    GlView view;
    upload(view, red_square());
    view.draw({camera, settings}, {}, context);
    const std::vector<std::uint32_t> expected = screen();
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 1, 1);
    glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
    glBlendEquation(GL_MAX);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 3);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    GlView other;
    upload(other, red_square());
    other.draw({camera, settings}, {}, context);
    EXPECT_EQ(screen(), expected);
}

TEST_F(GlViews, SettingsThatItCannotDrawAreRefused) {
    GlView view;
    upload(view, red_square());
    settings.visibility = Visibility::painter;
    EXPECT_EQ(test::error_of([&] { view.draw({camera, settings}, {}, context); }).code(), ErrorCode::usage);
    settings.visibility = {};
    settings.width = 0;
    EXPECT_EQ(test::error_of([&] { view.draw({camera, settings}, {}, context); }).code(), ErrorCode::usage);
}

TEST_F(GlViews, LinesAreHiddenBySurfacesUnlessTheyAreAnOverlay) {
    GlView view;
    upload(view, red_square());
    Line line{.from = {-0.9, 0, -0.5}, .to = {0.9, 0, -0.5}, .color = {1, 1, 1, 1}, .width_px = 3};
    const auto middle_with = [&](const Line& l) {
        view.draw({camera, settings}, {}, context);
        view.lines(camera, {&l, 1});
        return at(screen(), width / 2, height / 2);
    };
    EXPECT_EQ(middle_with(line), 0x0000FFu) << "behind the square";
    EXPECT_EQ(at(screen(), width / 2 + 15, height / 2), 0xFFFFFFu) << "beside it";
    line.is_overlay = true;
    EXPECT_EQ(middle_with(line), 0xFFFFFFu);
    line.is_overlay = false;
    line.from.z = line.to.z = 0.5;
    EXPECT_EQ(middle_with(line), 0xFFFFFFu) << "before the square";
}

TEST_F(GlViews, LinesThatLeadBehindTheEyeEndThere) {
    GlView view;
    Camera perspective;
    perspective.to_world = translation(dvec3{0, 0, 1});
    view.show(1, 1, std::vector<std::uint32_t>{0xFF000000u});
    const Line line{.from = {0, -0.2, -1}, .to = {0, -0.2, 30}, .color = {1, 1, 1, 1}, .width_px = 3};
    view.lines(perspective, {&line, 1});
    const std::vector<std::uint32_t> s = screen();
    EXPECT_EQ(at(s, width / 2, height - 1), 0xFFFFFFu) << "down to the lower edge";
    EXPECT_EQ(at(s, width / 2, 2), 0u) << "and not over the horizon";
}

TEST_F(GlViews, LinesBeforeTheNearPlaneAreSeen) {
    GlView view;
    Camera perspective;
    perspective.to_world = translation(dvec3{0, 0, 10});
    perspective.z_near = 9, perspective.z_far = 11;
    view.show(1, 1, std::vector<std::uint32_t>{0xFF000000u});
    const Line line{.from = {-9, 0, 5}, .to = {9, 0, 5}, .color = {1, 1, 1, 1}, .width_px = 3};
    view.lines(perspective, {&line, 1});
    EXPECT_EQ(at(screen(), width / 2, height / 2), 0xFFFFFFu);
}

}  // namespace
}  // namespace rakelight
