// SPDX-License-Identifier: Apache-2.0
// What a document keeps while its engine changes.
#include <gtest/gtest.h>

#include <rakelight/math/linear.h>
#include <rakelight/render/render.h>

#include "../../../apps/viewer/document/commands.h"
#include "looks.h"

namespace rakelight::viewer {
namespace {

/// Documents of every engine and method; R until it is back where it was.
TEST_F(Looks, EnginesOneAfterTheOtherLeaveTheDocumentAsItWas) {
    const auto of = model(write_model());
    for (const char* engine : {"soft", "gl", "trace", "auto"})
        for (const RayMethod method :
             {RayMethod::automatic, RayMethod::cast, RayMethod::whitted, RayMethod::path, RayMethod::radiosity})
            for (const int samples : {1, 4, 8})
                for (const bool shadows : {false, true}) {
                    const bool is_trace = std::string_view(engine) == "trace";
                    if (!is_trace && method != RayMethod::automatic && method != RayMethod::radiosity) continue;
                    Look look = first_look(*of);
                    look.request.engine = engine;
                    RenderSettings& s = look.request.settings;
                    s.method = method, s.shadows = shadows;
                    s.samples = method == RayMethod::path ? 100 * samples : samples;
                    const Look before = look;
                    for (int presses = 0; presses < 5; ++presses) {
                        apply(Command::engine, look, *of, width, height);
                        EXPECT_EQ(s.samples > 8, s.method == RayMethod::path) << "a number that the method takes";
                        if (!is_trace) {
                            EXPECT_EQ(s.shadows, shadows || look.request.engine == "trace")
                                << "rays have them by nature";
                        }
                    }
                    // A document of trace without shadows has them when its engine is chosen again.
                    if (is_trace && !shadows) look.request.settings.shadows = look.shadows_by_nature = false;
                    EXPECT_TRUE(look == before) << engine << " " << int(method) << " " << samples << " " << shadows;
                }
}

TEST_F(Looks, WhatIsChangedWhileAnEngineDrawsIsOfTheDocument) {
    const auto of = model(write_model());
    Look look = first_look(*of);
    RenderSettings& s = look.request.settings;
    s.samples = 4;
    choose_engine("trace", look);
    apply(Command::shadows, look, *of, width, height);  // off
    choose_method(RayMethod::path, look);
    EXPECT_EQ(s.samples, 256);
    s.samples = 1024;
    choose_engine("soft", look);
    EXPECT_EQ(s.samples, 4);
    EXPECT_FALSE(s.shadows);
    s.samples = 8, s.shadows = true;
    choose_engine("trace", look);
    EXPECT_EQ(s.samples, 8);
    choose_method(RayMethod::path, look);
    EXPECT_EQ(s.samples, 1024);
    choose_engine("gl", look);
    EXPECT_EQ(s.samples, 8);
    EXPECT_TRUE(s.shadows);
}

TEST_F(Looks, ShadowsOfRaysThatAreTurnedOffAndOnAreOfTheDocument) {
    const auto of = model(write_model());
    Look look = first_look(*of);
    choose_engine("trace", look);
    apply(Command::shadows, look, *of, width, height);
    apply(Command::shadows, look, *of, width, height);
    choose_engine("soft", look);
    EXPECT_TRUE(look.request.settings.shadows);
}

/// Shadows that rays have by nature go with them, those that the document names stay; however the document came to trace.
TEST_F(Looks, ADocumentThatStartsWithRaysIsOneThatSwitchedToThem) {
    for (const bool names_shadows : {false, true}) {
        Start start;
        start.takes = [](std::string_view) { return true; };
        start.settings = {{.key = "look", .words = {"plain"}}};
        if (names_shadows) start.settings.push_back({.key = "shadows", .words = {"on"}});
        Look switched = first_look(*load_model(write_model(), start, context_));
        choose_engine("trace", switched);
        start.settings.push_back({.key = "engine", .words = {"trace"}});
        const auto of = load_model(write_model(), start, context_);
        Look started = first_look(*of);
        EXPECT_EQ(started.shadows_by_nature, switched.shadows_by_nature);
        EXPECT_TRUE(started.request.settings.shadows);
        EXPECT_SAVED_AS_SEEN(started, of);
        Look saved = first_look(*model(file("saved.scene.toml")));
        for (Look* const look : {&switched, &started, &saved}) {
            choose_engine("soft", *look);
            EXPECT_EQ(look->request.settings.shadows, names_shadows);
            choose_engine("trace", *look);
            EXPECT_TRUE(look->request.settings.shadows);
        }
    }
}

}  // namespace
}  // namespace rakelight::viewer
