// SPDX-License-Identifier: Apache-2.0
// Frames, sinks, engines and inspections in wrong hands.
#include <filesystem>

#include <rakelight/tools/rows.h>

#include "support/thrown_error.h"
#include "unit/tools/misuse_support.h"

namespace rakelight {
namespace {

using namespace test;

TEST(MisusedFrame, TilesThatDoNotFitAreRefused) {
    Frame frame;
    expect_usage("a size", "a size below 0", [&] { frame.begin(-1, 5, {}, 0); });
    expect_usage("a window", "a size below 0", [&] { frame.begin(5, 5, {0, 0, -2, 3}, 0); });
    frame.begin(8, 8, {2, 2, 4, 4}, channel_depth);
    const std::vector<vec4> color(16);
    const std::vector<float> depth(3);
    for (const Window area :
         {Window{0, 0, 4, 4}, Window{3, 2, 4, 4}, Window{2, 2, 4, 5}, Window{2, 2, -1, 4}, Window{most, 2, most, 1}})
        expect_usage("a tile", "beyond the window", [&] { frame.tile({.area = area, .color = color}); });
    expect_usage("a tile", "16 entries for 2 x 2 pixels", [&] { frame.tile({.area = {2, 2, 2, 2}, .color = color}); });
    expect_usage("a tile", "3 entries for 4 x 4 pixels", [&] {
        frame.tile({.area = {2, 2, 4, 4}, .color = color, .depth = depth});
    });
    EXPECT_NO_THROW(frame.tile({.area = {2, 2, 4, 4}, .color = color}));
}

TEST(MisusedFrame, OneWhoseColorsDoNotFitIsNotSaved) {
    Frame frame;
    expect_usage("an empty frame", "0 x 0 pixels", [&] { save(frame, unwritten()); });
    frame.begin(4, 4, {}, 0);
    frame.color.resize(15);
    expect_usage("a short frame", "15 colors for 4 x 4 pixels", [&] { save(frame, unwritten()); });
    frame.window = {0, 0, most, most};
    expect_usage("a large window", "15 colors", [&] { save(frame, unwritten()); });
    EXPECT_FALSE(std::filesystem::exists(unwritten()));
}

/// Gives way, throws, or says strange things of itself.
struct OddSink final : Sink {
    int rows = 0;
    bool throws = false;
    void begin(int, int, Window, std::uint32_t) override {}
    void tile(const Tile&) override {
        if (throws) throw Error(ErrorCode::failed, "the sink is full");
    }
    int rows_at_once() const override { return rows; }
    void end_pass(int) override {}
};

TEST(MisusedSink, WhatASinkThrowsComesOutAndTheEngineGoesOn) {
    Context context;
    const std::unique_ptr<Engine> engine = make_engine("soft");
    engine->prepare(triangle_scene(), context);
    const Camera camera = triangle_scene().cameras[0];
    OddSink sink;
    sink.throws = true;
    EXPECT_EQ(error_of([&] { engine->render(camera, small_settings(), sink, context); }).reason(), "the sink is full");
    Frame frame;
    EXPECT_NO_THROW(engine->render(camera, small_settings(), frame, context));
    EXPECT_EQ(frame.color, render(triangle_scene(), camera, small_settings(), context).color);
    for (const int rows : {-5, 1, 63, most}) {
        sink = {};
        sink.rows = rows;
        EXPECT_NO_THROW(engine->render(camera, small_settings(), sink, context)) << rows;
    }
}

TEST(MisusedEngine, OneThatHoldsNoSceneDrawsTheBackground) {
    Context context;
    Frame frame;
    make_engine("soft")->render(Camera{}, small_settings(), frame, context);
    EXPECT_EQ(frame.color, std::vector<vec4>(24 * 16, small_settings().background));
}

TEST(MisusedEngine, ARefusedSceneLeavesTheOneBefore) {
    Context context;
    const std::unique_ptr<Engine> engine = make_engine("soft");
    const Scene good = triangle_scene();
    engine->prepare(good, context);
    Scene bad = good;
    bad.meshes[0].indices = Numbers{0, 1, 77};
    EXPECT_EQ(error_of([&] { engine->prepare(bad, context); }).code(), ErrorCode::bad_file);
    bad = good;
    bad.meshes[0].positions = Points(2);  // the same block of indices, which no longer fits
    bad.meshes[0].texcoords.clear();
    EXPECT_EQ(error_of([&] { engine->prepare(bad, context); }).code(), ErrorCode::bad_file);
    Frame frame;
    engine->render(good.cameras[0], small_settings(), frame, context);
    EXPECT_EQ(frame.color, render(good, good.cameras[0], small_settings(), context).color);
}

TEST(MisusedInspection, OneThatDoesNotHoldTogetherIsRefused) {
    const std::function<void(Inspection&)> faults[] = {
        [](Inspection& i) { i.borders.push_back({.object_a = 0, .object_b = 9}); },
        [](Inspection& i) {
            i.t_junction_places.push_back({{}, 9, 0}), i.t_junctions = 1;
        },
        [](Inspection& i) { i.t_junctions = 0, i.t_junction_places.resize(3); },
        [](Inspection& i) {
            i.inside_out.push_back({1, {}});
        },
        [](Inspection& i) {
            i.inside_out.push_back({1, {4}});
        },
        [](Inspection& i) { i.surfaces.resize(7); },
        [](Inspection& i) { i.surfaces[0].t_junctions = 5; },
        [](Inspection& i) { i.material_objects.clear(); },
        [](Inspection& i) { i.seams.seam_deg = 50; },
        [](Inspection& i) { i.matched.pairs.push_back({.object_a = 0, .object_b = 9}); },
        [](Inspection& i) { i.matched.before.max_deg = 50; },
    };
    Context context;
    const Inspection good = inspect(triangle_scene(), {}, context);
    EXPECT_NO_THROW((void)to_text(good));
    for (const auto& spoil : faults) {
        InspectionRow row{.file = "a"};
        row.inspection = good;
        spoil(*row.inspection);
        expect_usage("to_text", "is inconsistent", [&] { (void)to_text(*row.inspection); });
        expect_usage("to_json", "is inconsistent", [&] { (void)to_json(std::span(&row, 1)); });
        expect_usage("check_limits", "is inconsistent",
                     [&] { (void)check_limits(*row.inspection, {.no_t_junctions = true, .no_inside_out = true}); });
    }
}

TEST(MisusedInspection, SeamLinesThatAreNoNumbersAreNotDrawn) {
    Context context;
    Inspection inspection;
    inspection.seam_lines.push_back({{nan_d, 0, 0}, {1, inf_d, 0}, nan_f, 5});
    inspection.seam_lines.push_back({{1e300, -1e300, 0}, {-1e300, 1e300, 0}, 50, inf_f});
    EXPECT_EQ(draw_seams(triangle_scene(), inspection, {}, {}, small_settings(), context).color,
              draw_seams(triangle_scene(), {}, {}, {}, small_settings(), context).color);
}

}  // namespace
}  // namespace rakelight
