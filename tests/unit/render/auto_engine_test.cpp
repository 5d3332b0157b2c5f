// SPDX-License-Identifier: Apache-2.0
// The engine auto draws by gl or by soft, and says which.
#include "render/auto_engine.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <rakelight/render.h>
#include <rakelight/session.h>

#include "support/scene_builder.h"
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
    EXPECT_EQ(says(context, "engine auto: it takes engine soft"), by == "soft");
    if (by == "soft") {
        EXPECT_TRUE(test::same_bits(frame, render(square(), test::flat_camera(), small(), context)));
    }
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
