// SPDX-License-Identifier: Apache-2.0
// Pictures on the GPU without a window: a context of EGL stands for the hidden window's. Skipped where there is no OpenGL.
#include "../../../apps/viewer/view/gl_painter.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include <rakelight/render/render.h>

#include "../../../apps/viewer/background/load_model.h"
#include "../../../apps/viewer/view/painter.h"
#include "support/gl_context.h"

namespace rakelight::viewer {
namespace {

constexpr int across = 96, down = 64;

class HeadlessContext final : public SharedContext {
public:
    void make_current() override {
        std::string why;
        context_ = test::GlContext::make(test::GlFlavour::core_33, why);
        if (!context_) throw Error(ErrorCode::failed, why);
    }
    void release() override { context_.reset(); }

private:
    std::unique_ptr<test::GlContext> context_;
};

class BrokenContext final : public SharedContext {
public:
    void make_current() override { throw Error(ErrorCode::failed, "the context is lost"); }
    void release() override {}
};

class GlPainters : public testing::Test {
protected:
    void SetUp() override {
        ::setenv("RAKELIGHT_GL_CACHE", "off", 1);
        std::string why;
        if (!test::GlContext::make(test::GlFlavour::core_33, why)) GTEST_SKIP() << why;
        Start start;
        start.takes = [](std::string_view) { return true; };
        model_ = load_model("builtin:teapot", start, context_);
        look_ = first_look(*model_);
        look_.request.engine = "gl";
    }
    PaintJob job(const std::shared_ptr<GlPainter>& gl, std::uint64_t number = 1) const {
        return {.model = model_, .look = look_, .width = across, .height = down, .number = number, .gl = gl};
    }
    /// The last picture of a job, null where a fault comes first.
    std::shared_ptr<const Painting> painted(Painter& painter, PaintJob wanted) {
        painter.paint(std::move(wanted));
        for (;;) {
            if (auto painting = painter.take(); painting && painting->is_final) return painting;
            if ((fault_ = painter.take_fault())) return nullptr;
            std::this_thread::yield();
        }
    }

    Context context_{{.threads = 1}};
    std::shared_ptr<const Model> model_;
    Look look_;
    std::optional<Painter::Fault> fault_;
};

TEST_F(GlPainters, DrawThePictureOfTheEngineIntoATexture) {
    Session session("gl");
    session.set(model_->scene);
    const Camera camera = camera_of(look_, *model_, across, down);
    const RenderSettings settings = request_of(look_, across, down).settings;
    Frame frame;
    session.render(camera, settings, frame, context_);
    const std::vector<std::uint32_t> expected = to_srgb8(frame, {});
    GlPainter painter(std::make_unique<HeadlessContext>());
    const auto scene = session.prepared(settings, context_);
    while (!painter.upload(scene, 5, context_)) {
    }
    EXPECT_EQ(painter.scene(), scene);
    for (int repeat = 0; repeat < 6; ++repeat) {  // the textures of those let go are drawn into again
        const GlPainter::Drawn drawn = painter.draw({camera, settings}, {}, {}, context_);
        ASSERT_EQ(drawn.picture->width, across);
        const int stride = drawn.picture->texture_width;
        ASSERT_GE(drawn.picture->texture_height, down);
        std::vector<std::uint32_t> got(std::size_t(stride) * std::size_t(drawn.picture->texture_height));
        glBindTexture(GL_TEXTURE_2D, drawn.picture->texture);
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, got.data());  // lowest row first
        for (int y = 0; y < down; ++y)
            for (int x = 0; x < across; ++x)
                for (int c = 0; c < 24; c += 8)
                    ASSERT_NEAR(got[std::size_t((down - 1 - y) * stride + x)] >> c & 255,
                                expected[std::size_t(y * across + x)] >> c & 255, 1)
                        << x << ", " << y;
    }
    painter.end();
}

TEST_F(GlPainters, MakePicturesInThePaintersThread) {
    const auto gl = std::make_shared<GlPainter>(std::make_unique<HeadlessContext>());
    Painter painter([] {}, 0, 0);
    look_.request.settings.samples = 4;
    const auto painting = painted(painter, job(gl));
    ASSERT_TRUE(painting);
    EXPECT_TRUE(painting->picture && painting->codes.empty());
    EXPECT_EQ(painting->width, across);
}

TEST_F(GlPainters, LeaveToASessionWhatTheyCannotDo) {
    const auto gl = std::make_shared<GlPainter>(std::make_unique<HeadlessContext>());
    Painter painter([] {}, 0, 0);
    look_.channel = channel_normal;
    const auto painting = painted(painter, job(gl));
    ASSERT_TRUE(painting);
    EXPECT_FALSE(painting->picture);
    EXPECT_EQ(painting->codes.size(), std::size_t(across * down));
    look_.channel = 0;
    look_.request.settings.visibility = Visibility::painter;
    look_.request.settings.samples = 1;
    EXPECT_FALSE(painted(painter, job(gl, 2)));
    EXPECT_EQ(fault_->error.code(), ErrorCode::usage);
    EXPECT_FALSE(fault_->is_of_gl);
    look_.request.engine = "auto";
    const auto by_soft = painted(painter, job(gl, 3));
    EXPECT_TRUE(by_soft && !by_soft->picture);
}

TEST_F(GlPainters, TellWhatOfALightingModelDoesNotCompileAndGoOn) {
    const auto gl = std::make_shared<GlPainter>(std::make_unique<HeadlessContext>());
    Painter painter([] {}, 0, 0);
    look_.request.settings.lighting_name = "mine.glsl";
    look_.request.settings.lighting_text = "user_terms\n";
    EXPECT_FALSE(painted(painter, job(gl)));
    EXPECT_NE(std::string(fault_->error.what()).find("mine.glsl"), std::string::npos) << fault_->error.what();
    EXPECT_FALSE(fault_->is_of_gl);
    look_.request.settings.lighting_text.clear();
    EXPECT_TRUE(painted(painter, job(gl, 2)));
}

TEST_F(GlPainters, ThatFailAreToldApartFromFaultsOfAJob) {
    const auto gl = std::make_shared<GlPainter>(std::make_unique<BrokenContext>());
    Painter painter([] {}, 0, 0);
    EXPECT_FALSE(painted(painter, job(gl)));
    EXPECT_TRUE(fault_->is_of_gl);
    EXPECT_EQ(fault_->error.reason(), "the context is lost");
    look_.request.engine = "soft";
    EXPECT_TRUE(painted(painter, job(nullptr, 2)));
}

}  // namespace
}  // namespace rakelight::viewer
