// SPDX-License-Identifier: Apache-2.0
// The engine auto draws by gl or by soft, and says which.
#include "render/auto_engine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

#include <rakelight/render/render.h>
#include <rakelight/render/session.h>

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
    const Error error = test::error_of([&] { e->render(test::flat_camera(), settings, frame, context); });
    EXPECT_EQ(error.code(), ErrorCode::usage);
    EXPECT_NE(error.reason().find("engine soft cannot use lighting"), std::string::npos) << error.reason();
}

/// A picture file's: asks for display values in rows of its own, strip by strip.
class Strips final : public Sink {
public:
    void begin(int width, int height, Window, std::uint32_t) override {
        width_ = width, rows.resize(std::size_t(width) * std::size_t(height));
    }
    void tile(const Tile&) override { ++linear_tiles; }
    void end_pass(int) override {}
    int rows_at_once() const override { return 64; }
    void rows_done(int, int count) override { done += count; }
    bool wants_partial() const override { return ++asked_partial, true; }
    bool wants_srgb8() const override { return true; }
    DisplayRows display_rows(const Window& area) override {
        return {rows.data() + std::size_t(area.y) * std::size_t(width_) + std::size_t(area.x), std::size_t(width_)};
    }
    void display_tile(const Tile& tile, std::span<const std::uint32_t> srgb8) override {
        for (std::size_t i = 0; i < srgb8.size(); ++i) {
            const Window& w = tile.area;
            const std::size_t x = std::size_t(w.x) + i % std::size_t(w.width),
                              y = std::size_t(w.y) + i / std::size_t(w.width);
            rows[y * std::size_t(width_) + x] = srgb8[i];
        }
        ++display_tiles;
    }
    std::vector<std::uint32_t> rows;
    std::atomic<int> linear_tiles{0}, display_tiles{0}, done{0};
    mutable std::atomic<int> asked_partial{0};

private:
    int width_ = 0;
};

TEST_F(AutoEngineWithGpu, ASinkThatIsWatchedIsAskedForEverything) {
    RenderSettings settings = small();
    settings.height = 150;  // strips
    Strips watched, plain;
    const auto e = engine(FakeGpu::Fails::never), soft = make_engine("soft");
    e->prepare(square(), context), soft->prepare(square(), context);
    e->render(test::flat_camera(), settings, watched, context);
    soft->render(test::flat_camera(), settings, plain, context);
    EXPECT_EQ(watched.rows, plain.rows);
    EXPECT_EQ(watched.linear_tiles, 0);
    EXPECT_EQ(watched.display_tiles, plain.display_tiles);
    EXPECT_EQ(watched.done, plain.done);
    EXPECT_GT(plain.done, 0);
    EXPECT_EQ(watched.asked_partial > 0, plain.asked_partial > 0);
}

/// Asks what the engine of a GPU may ask of any sink.
class AskingGpu final : public Engine {
public:
    explicit AskingGpu(bool& wants_partial) : wants_partial_(wants_partial) {}
    std::string name() const override { return "gl"; }
    EngineCapabilities capabilities() const override { return {}; }
    void prepare(Scene scene, Context&) override { scene_ = std::move(scene); }
    const Scene& scene() const override { return scene_; }
    void set_lights(std::vector<Light>) override {}
    RenderStats render(const Camera&, const RenderSettings&, Sink& sink, Context&) override {
        wants_partial_ = sink.wants_partial();
        return {};
    }

private:
    Scene scene_;
    bool& wants_partial_;
};

TEST(AutoEngine, ASinkSaysWhetherItWantsAPictureInPart) {
    Context context({.threads = 1});
    bool wants_partial = false;
    const auto e = make_auto_engine(std::make_unique<AskingGpu>(wants_partial), {});
    e->prepare(square(), context);
    Strips strips;
    e->render(test::flat_camera(), small(), strips, context);
    EXPECT_TRUE(wants_partial);
    Frame frame;
    e->render(test::flat_camera(), small(), frame, context);
    EXPECT_FALSE(wants_partial);
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
