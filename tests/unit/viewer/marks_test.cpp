// SPDX-License-Identifier: Apache-2.0
#include "../../../apps/viewer/view/marks.h"

#include <gtest/gtest.h>

#include "../../../apps/viewer/background/load_model.h"

namespace rakelight::viewer {
namespace {

TEST(Marks, AreTheLinesOfEachThatIsWanted) {
    Context context({.threads = 1});
    Start start;
    start.takes = [](std::string_view) { return true; };
    const auto model = load_model("builtin:plane", start, context);
    const Look look = first_look(*model);
    Session session;
    session.set(model->scene);
    const auto prepared = session.prepared({}, context);
    MarkLines made;
    const auto count = [&](const Marks& marks) {
        return made.lines(marks, look, *model, prepared, camera_of(look, *model, 64, 64), 64, 64).size();
    };
    EXPECT_EQ(count({}), 0u);
    EXPECT_EQ(count({.axes = true}), 3u);
    const std::size_t normals = count({.vectors = {true}});
    EXPECT_EQ(normals, model->vertices);
    EXPECT_EQ(count({.axes = true, .vectors = {true}}), 3 + normals);
    EXPECT_EQ(count({}), 0u);
    const auto seams = std::make_shared<const Seams>(Seams{.drawn = std::vector<SeamLine>(7)});
    EXPECT_EQ(count({.seams = seams}), 7u);
    const std::size_t lights = count({.lights = true});
    EXPECT_GT(lights, 0u);
    EXPECT_EQ(count({.lights = true, .light = 0}), lights);
    EXPECT_GT(count({.lights = true, .light = 0, .has_handles = true}), lights);
}

TEST(Marks, TheWorstSeamsAreDrawn) {
    std::vector<SeamLine> all(100);
    for (std::size_t i = 0; i < all.size(); ++i) (i % 2 ? all[i].deg_a : all[i].deg_b) = float(i * 37 % 100);
    const Seams few = worst_seams(all, 10), whole = worst_seams(all, 100);
    EXPECT_EQ(few.count, 100u);
    EXPECT_EQ(few.worst_deg, 99);
    ASSERT_EQ(few.drawn.size(), 10u);
    for (const SeamLine& s : few.drawn) EXPECT_GE(std::max(s.deg_a, s.deg_b), 90);
    EXPECT_EQ(whole.drawn.size(), 100u);
}

}  // namespace
}  // namespace rakelight::viewer
