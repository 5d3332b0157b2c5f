// SPDX-License-Identifier: Apache-2.0
// The engine auto draws by gl or by soft, and says which.
#include "render/auto_engine.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <rakelight/render.h>
#include <rakelight/session.h>

#include "support/scene_builder.h"
#include "support/thrown_error.h"
#include "unit/raster/drawn.h"

namespace rakelight {
namespace {

Scene square() {
    Scene scene;
    scene.materials.push_back(test::matte({0.8f, 0.5f, 0.2f}));
    test::add_object(scene, test::square_mesh(0));
    return scene;
}

RenderSettings small() {
    RenderSettings s;
    s.width = 40, s.height = 30;
    return s;
}

bool says(Context& context, const char* words) {
    const std::vector<ReportEntry> entries = context.report().entries();
    return std::ranges::any_of(entries,
                               [&](const ReportEntry& e) { return e.message.find(words) != std::string::npos; });
}

TEST(AutoEngine, DrawsByOneOfTheTwo) {
    Context context({.threads = 1});
    Session session("auto");
    session.set(square());
    Frame frame;
    session.render(test::flat_camera(), small(), frame, context);
    const std::string by = session.engine().name();
    ASSERT_TRUE(by == "soft" || by == "gl") << by;
    EXPECT_EQ(says(context, "engine auto: it uses engine soft"), by == "soft");
    if (by == "soft") {
        EXPECT_TRUE(test::same_bits(frame, render(square(), test::flat_camera(), small(), context)));
    }
}

/// Draws as soft does, until it is told to fail.
class FakeGpu final : public Engine {
public:
    enum class Fails { never, at_prepare, before_the_sink, in_the_sink };
    explicit FakeGpu(Fails fails, ErrorCode code = ErrorCode::failed) : fails_(fails), code_(code) {}

    std::string name() const override { return "gl"; }
    EngineCapabilities capabilities() const override {
        EngineCapabilities can;
        can.user_lighting = true;
        return can;
    }
    void prepare(Scene scene, Context& context) override {
        if (fails_ == Fails::at_prepare) fail();
        soft_->prepare(std::move(scene), context);
    }
    const Scene& scene() const override { return soft_->scene(); }
    void set_lights(std::vector<Light> lights) override { soft_->set_lights(std::move(lights)); }
    RenderStats render(const Camera& camera, const RenderSettings& settings, Sink& sink, Context& context) override {
        if (fails_ == Fails::before_the_sink) fail();
        if (fails_ == Fails::in_the_sink) {
            sink.begin(settings.width, settings.height, {0, 0, settings.width, settings.height}, 0);
            fail();
        }
        return soft_->render(camera, settings, sink, context);
    }

private:
    [[noreturn]] void fail() const { throw Error(code_, "the context is lost"); }
    const std::unique_ptr<Engine> soft_ = make_engine("soft");
    const Fails fails_;
    const ErrorCode code_;
};

class AutoEngineWithGpu : public testing::Test {
protected:
    std::unique_ptr<Engine> engine(FakeGpu::Fails fails, ErrorCode code = ErrorCode::failed) {
        return make_auto_engine(std::make_unique<FakeGpu>(fails, code), {});
    }
    Context context{{.threads = 1}};
    Frame frame;
};

TEST_F(AutoEngineWithGpu, DrawsByItInSilence) {
    const auto e = engine(FakeGpu::Fails::never);
    e->prepare(square(), context);
    e->render(test::flat_camera(), small(), frame, context);
    EXPECT_EQ(e->name(), "gl");
    EXPECT_TRUE(context.report().entries().empty());
}

TEST_F(AutoEngineWithGpu, GoesOnWithSoftWhereItFails) {
    for (const auto fails : {FakeGpu::Fails::at_prepare, FakeGpu::Fails::before_the_sink}) {
        Context own({.threads = 1});
        const auto e = engine(fails);
        e->prepare(square(), own);
        e->render(test::flat_camera(), small(), frame, own);
        EXPECT_EQ(e->name(), "soft");
        EXPECT_TRUE(says(own, "it continues with engine soft: the context is lost"));
        const auto soft = make_engine("soft");
        Frame expected;
        soft->prepare(square(), own);
        soft->render(test::flat_camera(), small(), expected, own);
        EXPECT_TRUE(test::same_bits(frame, expected));
    }
}

TEST_F(AutoEngineWithGpu, APictureThatWasBegunIsNotBegunAgain) {
    const auto e = engine(FakeGpu::Fails::in_the_sink);
    e->prepare(square(), context);
    EXPECT_EQ(test::error_of([&] { e->render(test::flat_camera(), small(), frame, context); }).code(),
              ErrorCode::failed);
}

TEST_F(AutoEngineWithGpu, WhatIsWrongForBothIsSaid) {
    const auto e = engine(FakeGpu::Fails::at_prepare, ErrorCode::bad_file);
    EXPECT_EQ(test::error_of([&] { e->prepare(square(), context); }).code(), ErrorCode::bad_file);
}

TEST_F(AutoEngineWithGpu, WhatNeitherCanDoAloneIsRefused) {
    const auto e = engine(FakeGpu::Fails::never);
    e->prepare(square(), context);
    RenderSettings settings = small();
    settings.lighting_name = "mine.glsl", settings.lighting_text = "user_terms";
    settings.visibility = Visibility::painter;
    EXPECT_EQ(test::error_of([&] { e->render(test::flat_camera(), settings, frame, context); }).code(),
              ErrorCode::usage);
}

TEST(AutoEngine, WhatSoftAloneCanDoIsDrawn) {
    Context context({.threads = 1});
    Session session("auto");
    session.set(square());
    RenderSettings settings = small();
    settings.visibility = Visibility::painter;
    Frame frame;
    session.render(test::flat_camera(), settings, frame, context);
    EXPECT_EQ(session.engine().name(), "soft");
    EXPECT_TRUE(test::same_bits(frame, render(square(), test::flat_camera(), settings, context)));
}

}  // namespace
}  // namespace rakelight
