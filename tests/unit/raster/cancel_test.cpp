// SPDX-License-Identifier: Apache-2.0
// A cancelled run ends within a tile: the tile's many triangles are not gone through, and what was cut is not
// delivered.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

#include "engines/raster/multisample.h"
#include "engines/raster/raster_engine.h"
#include "engines/raster/shade/blend_tile.h"
#include "engines/raster/shade/channels_tile.h"
#include "engines/raster/shade/shade_tile.h"
#include "support/thrown_error.h"
#include "unit/raster/busy_scene.h"
#include "unit/raster/drawn.h"
#include "unit/raster/geometry/one_tile.h"

using namespace rakelight;
using namespace rakelight::test;
using namespace rakelight::raster;

namespace {

/// One mesh of `count` triangles that fill the picture left of `right` [units at distance 10], each nearer than the
/// last.
Scene many_screens(std::uint32_t count, AlphaMode mode, float right = 100) {
    Scene scene;
    Mesh mesh;
    mesh.material = add_unlit(scene, {1, 0, 0, 0.5f}, mode);
    std::vector<vec3> positions;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < count; ++i) {
        const float z = -10 + 5 * float(i) / float(count);
        positions.insert(positions.end(), {{-300, -100, z}, {right, -100, z}, {right, 300, z}});
        indices.insert(indices.end(), {3 * i, 3 * i + 1, 3 * i + 2});
    }
    mesh.normals = std::vector<vec3>(positions.size(), vec3{0, 0, 1});
    mesh.positions = std::move(positions);
    mesh.indices = std::move(indices);
    add_object(scene, std::move(mesh));
    return scene;
}

/// Cancels with the first tile that comes.
class CancellingSink final : public Sink {
public:
    explicit CancellingSink(Context& context) : context_(context) {}
    void begin(int, int, Window, std::uint32_t) override {}
    void tile(const Tile&) override {
        ++tiles;
        context_.cancel();
    }
    void end_pass(int) override {}
    std::atomic<int> tiles{0};

private:
    Context& context_;
};

/// Fails, or cancels the run, in the middle of the picture.
class BadSink final : public Sink {
public:
    explicit BadSink(Context* to_cancel) : to_cancel_(to_cancel) {}
    void begin(int, int, Window, std::uint32_t) override {}
    void tile(const Tile&) override {
        if (++tiles_ != 5) return;
        if (!to_cancel_) throw Error(ErrorCode::failed, "disk full");
        to_cancel_->cancel();
    }
    void end_pass(int) override { has_ended = true; }
    bool has_ended = false;

private:
    Context* to_cancel_;
    std::atomic<int> tiles_{0};
};

}  // namespace

TEST(Cancel, VisibilityOfATileLooksAtItByEveryMethodAndAtEverySample) {
    for (const Visibility method : {Visibility::z_reversed, Visibility::painter, Visibility::z24})
        for (const AlphaMode mode : {AlphaMode::opaque, AlphaMode::mask})
            for (const int samples : {1, 4}) {
                if (samples > 1 && method != Visibility::z_reversed) continue;  // refused together
                RenderSettings settings = one_tile;
                settings.visibility = method;
                settings.samples = samples;
                OneTile t(many_screens(500, mode), settings);
                const auto find = [&] {
                    t.scratch.depth_passes = 0;
                    samples > 1 ? find_visible_samples(t.job, 0, t.scratch) : find_visible(t.job, 0, t.scratch);
                    return t.scratch.depth_passes;
                };
                EXPECT_GT(find(), 0u);
                t.run.cancel();
                EXPECT_EQ(find(), 0u) << int(method) << ' ' << samples;
            }
}

TEST(Cancel, NoBlendedLayerIsLaidAfterIt) {
    OneTile t(many_screens(500, AlphaMode::blend), one_tile);
    std::size_t laid = 0;
    t.scratch.on_layer = [&](std::size_t, std::uint32_t, float) {
        if (++laid == 7 * std::size_t(tile_pixels)) t.run.cancel();
    };
    find_visible(t.job, 0, t.scratch);
    ASSERT_TRUE(shade_opaque(t.job, 0, t.scratch));
    blend_transparent(t.job, 0, t.scratch);
    EXPECT_EQ(laid, 7 * std::size_t(tile_pixels));
}

TEST(Cancel, NoBlendedLayerIsLaidAtSamplesAfterIt) {
    RenderSettings settings = one_tile;
    settings.samples = 4;
    OneTile t(many_screens(500, AlphaMode::blend), settings);
    find_visible_samples(t.job, 0, t.scratch);
    shade_samples(t.job, 0, t.scratch);
    t.run.cancel();
    finish_samples(t.job, 0, t.scratch);
    EXPECT_EQ(t.scratch.shaded, 0u);
}

TEST(Cancel, OverdrawIsNotCountedAfterIt) {
    RenderSettings settings = one_tile;
    settings.channels = channel_overdraw;
    OneTile t(many_screens(500, AlphaMode::opaque), settings);
    t.scratch.overdraw.assign(tile_pixels, 0);
    t.run.cancel();
    count_overdraw(t.job, 0, t.scratch);
    EXPECT_EQ(std::count(t.scratch.overdraw.begin(), t.scratch.overdraw.end(), 0u), tile_pixels);
}

// Two tiles, of which the left one has all the layers: the other is done while it is drawn, or not begun.
TEST(Cancel, ATileThatWasCutIsNotDelivered) {
    Context context({.threads = 2});
    auto engine = make_engine();
    engine->prepare(many_screens(20000, AlphaMode::blend, -1), context);
    CancellingSink sink(context);
    const auto error =
        error_of([&] { engine->render(camera_at_origin(), {.width = 128, .height = 64}, sink, context); });
    EXPECT_EQ(error.reason(), "cancelled");
    EXPECT_EQ(sink.tiles, 1);
}

TEST(Cancel, AnErrorOfTheSinkAndACancelComeOutAndLeaveTheEngineUsable) {
    const Scene scene = busy_scene();
    const RenderSettings settings{.width = 512, .height = 512};
    const Frame reference = draw(scene, busy_view(), settings);
    for (const int threads : {1, 4})
        for (const bool cancels : {false, true}) {
            Context first({.threads = threads}), second({.threads = threads});
            auto engine = raster::make_engine();
            engine->prepare(scene, first);
            BadSink bad(cancels ? &first : nullptr);
            try {
                engine->render(busy_view(), settings, bad, first);
                FAIL() << "nothing was thrown";
            } catch (const Error& error) {
                EXPECT_EQ(error.reason(), cancels ? "cancelled" : "disk full");
            }
            EXPECT_FALSE(bad.has_ended);
            Frame frame;
            engine->render(busy_view(), settings, frame, second);
            EXPECT_TRUE(same_bits(frame, reference));
        }
}
