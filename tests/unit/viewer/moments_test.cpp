// SPDX-License-Identifier: Apache-2.0
// Pictures of a moment are those of render_picture().
#include <filesystem>
#include <thread>

#include <rakelight/render/render.h>

#include "../../../apps/viewer/motion/player.h"
#include "../../../apps/viewer/view/painter.h"
#include "looks.h"
#include "support/shared.h"

namespace rakelight::viewer {
namespace {

class Moments : public Looks {
protected:
    Moments() {
        std::filesystem::copy_file(test::source_dir() / "data/motion/door.gltf", file("door.gltf"));
        model_ = model(file("door.gltf"));
        look_ = first_look(*model_);
    }
    void show(std::optional<int> clip, double time_s) {
        choose_clip(look_, clip);
        set_time(look_, *model_, {}, width, height, time_s);
    }
    /// What render_picture() draws of the look's request, its file read anew.
    std::vector<std::uint32_t> rendered() {
        Pixels pixels;
        render_picture(request_of(look_, width, height), pixels, context_);
        std::vector<std::uint32_t> codes;
        for (int i = 0; i < width * height; ++i) {
            const auto at = [&](int c) { return std::to_integer<std::uint32_t>(pixels.bytes[std::size_t(3 * i + c)]); };
            codes.push_back(0xff000000u | at(0) | at(1) << 8 | at(2) << 16);
        }
        return codes;
    }
    /// By the painter, at rest.
    std::vector<std::uint32_t> painted() {
        painter_.paint({.model = model_, .look = look_, .width = width, .height = height, .number = ++number_});
        for (;;) {
            if (const auto painting = painter_.take(); painting && painting->is_final) return painting->codes;
            if (const auto fault = painter_.take_fault()) throw fault->error;
            std::this_thread::yield();
        }
    }
    std::shared_ptr<const Model> model_;
    Look look_;
    std::uint64_t number_ = 0;
    Painter painter_{[] {}, 1, 0};
};

TEST_F(Moments, ArePaintedAsTheyAreRendered) {
    const std::vector<std::uint32_t> at_rest = painted();
    EXPECT_TRUE(at_rest == rendered());
    std::vector<std::uint32_t> before = at_rest;
    for (const auto& [clip, time_s] : {std::pair(0, 0.4), {0, 0.9}, {1, 1.7}, {-1, 1.1}}) {
        show(clip, time_s);
        const std::vector<std::uint32_t> now = painted();
        EXPECT_TRUE(now == rendered()) << clip << " at " << time_s;
        EXPECT_FALSE(now == before) << clip << " at " << time_s;
        before = now;
    }
    look_ = first_look(*model_);
    EXPECT_TRUE(painted() == at_rest) << "back at rest";
}

TEST_F(Moments, FittedViewsAreFittedToThem) {
    look_.request.view = {.side = "front"};
    look_.request.motion = {.index = 1, .time_s = 2.5};
    EXPECT_TRUE(painted() == rendered());
}

TEST_F(Moments, CamerasOfTheFileAreWhereTheirClipsSay) {
    look_.request.view = {.camera = "fixed"};
    show(2, 0.5);
    const std::vector<std::uint32_t> first = painted();
    EXPECT_TRUE(first == rendered());
    show(2, 2);
    EXPECT_TRUE(painted() == rendered());
    EXPECT_FALSE(painted() == first);
}

TEST_F(Moments, OverridesOfMaterialsStandAboveTheirMotion) {
    Model moving = *model_;
    AnimationChannel color{.element = 0, .path = AnimationPath::material, .property = "base_color"};
    color.times = std::vector<float>{0, 1};
    color.values = std::vector<float>{1, 1, 1, 1, 0, 0, 1, 1};
    moving.scene.animations[0].channels = {color};
    model_ = std::make_shared<const Model>(std::move(moving));
    show(0, 0);
    const std::vector<std::uint32_t> white = painted();
    show(0, 1);
    EXPECT_FALSE(painted() == white);
    look_.request.materials.color = vec3{0.1f, 0.6f, 0.1f};
    const std::vector<std::uint32_t> green = painted();
    show(0, 0);
    EXPECT_TRUE(painted() == green);
}

TEST_F(Moments, PicturesThatPlayAreAsFineAsThereIsTimeFor) {
    show(0, 0.3);
    look_.request.settings.samples = 4;
    painted();  // measures
    std::shared_ptr<const Painting> last;
    for (int i = 0; i < 50 && !(last && last->is_whole); ++i) {
        painter_.paint({.model = model_,
                        .look = look_,
                        .width = 16,
                        .height = 16,
                        .is_moving = true,
                        .is_playing = true,
                        .number = ++number_});
        for (last = nullptr; !last; last = painter_.take()) std::this_thread::yield();
    }
    EXPECT_TRUE(last->is_whole) << "256 pixels are drawn in time";
    EXPECT_EQ(last->number, number_);
}

TEST_F(Moments, AreKeptByASavedScene) {
    show(1, 1.25);
    EXPECT_SAVED_AS_SEEN(look_, model_);
    const auto saved = model(file("saved.scene.toml"));
    EXPECT_EQ(saved->request.motion.index, 1);
    EXPECT_EQ(saved->request.motion.time_s, 1.25);
    const std::string line = command_line_of(look_, *model_, width, height);
    EXPECT_NE(line.find("--animation-index 1 --animation-time 1.25"), std::string::npos) << line;
}

TEST_F(Moments, ShareTheArraysThatNothingMoves) {
    Studio studio;
    const auto meshes_at = [&](double time_s) {
        show(1, time_s);
        studio.prepare(shot(studio, model_, look_), context_);
        return scene_of(*studio.prepared()).meshes;
    };
    const std::vector<Mesh> a = meshes_at(1), b = meshes_at(2);
    ASSERT_EQ(a.size(), 2u);
    EXPECT_NE(a[0].positions.identity(), b[0].positions.identity()) << "the door";
    EXPECT_EQ(a[0].indices.identity(), b[0].indices.identity());
    EXPECT_TRUE(a[1] == b[1]);
    EXPECT_EQ(a[1].positions.identity(), b[1].positions.identity()) << "its post";
}

TEST_F(Moments, AFileWithoutTheClipThatIsAskedForStandsAtRest) {
    Start start;
    start.takes = [](std::string_view) { return true; };
    start.settings = {{.key = "animation-name", .words = {"slide"}}};
    const auto slides = load_model(model_->file, start, context_);
    EXPECT_EQ(chosen_clip(first_look(*slides), *slides), 1);
    const auto rests = load_model(write_model(), start, context_);
    EXPECT_FALSE(rests->request.motion.is_set());
    EXPECT_EQ(rests->remarks.back().remark, Remark::warning);
}

}  // namespace
}  // namespace rakelight::viewer
