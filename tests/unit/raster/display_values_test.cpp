// SPDX-License-Identifier: Apache-2.0
// Display values: those of the linear colors, whether they come tile by tile or are made in the sink's own memory.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <random>

#include "engines/raster/kernels/geometry_types.h"
#include "engines/raster/raster_engine.h"
#include "image/tone.h"
#include "math/isa.h"
#include "unit/raster/busy_scene.h"
#include "unit/raster/geometry/every_geometry_kernels.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

constexpr std::uint32_t untouched = 0x12345678;
constexpr std::size_t margin = 5;  ///< [px] of the sink's memory on all sides of the picture

/// Takes display values of a window, with or without memory that engines may write to.
class DisplaySink final : public Sink {
public:
    explicit DisplaySink(bool has_memory) : has_memory_(has_memory) {}
    void begin(int width, int height, Window window, std::uint32_t) override {
        window_ = window.width == 0 ? Window{0, 0, width, height} : window;
        stride_ = std::size_t(window_.width) + 2 * margin;
        values_.assign(stride_ * (std::size_t(window_.height) + 2 * margin), untouched);
    }
    bool wants_srgb8() const override { return true; }
    DisplayRows display_rows(const Window& area) override {
        return has_memory_ ? DisplayRows{at(area.x - window_.x, area.y - window_.y), stride_} : DisplayRows{};
    }
    void tile(const Tile&) override { ADD_FAILURE() << "a tile of linear colors"; }
    void display_tile(const Tile& tile, std::span<const std::uint32_t> srgb8) override {
        EXPECT_TRUE(tile.color.empty());
        const auto width = std::size_t(tile.area.width);
        for (int y = 0; y < tile.area.height && !srgb8.empty(); ++y)
            std::copy_n(srgb8.data() + std::size_t(y) * width, width,
                        at(tile.area.x - window_.x, tile.area.y - window_.y + y));
        from_memory += srgb8.empty();
    }
    void end_pass(int) override {}

    std::vector<std::uint32_t> picture() {
        std::vector<std::uint32_t> out;
        for (int y = 0; y < window_.height; ++y) out.insert(out.end(), at(0, y), at(0, y) + window_.width);
        return out;
    }
    std::size_t touched() const {
        return values_.size() - std::size_t(std::count(values_.begin(), values_.end(), untouched));
    }
    std::atomic<int> from_memory{0};  ///< tiles that came without values

private:
    std::uint32_t* at(int x, int y) {
        return values_.data() + (std::size_t(y) + margin) * stride_ + std::size_t(x) + margin;
    }
    bool has_memory_;
    Window window_;
    std::size_t stride_ = 0;
    std::vector<std::uint32_t> values_;
};

std::vector<std::uint32_t> encoded(const Frame& frame) {
    std::vector<std::uint32_t> out(frame.color.size());
    to_srgb8(frame.color, 4, {reinterpret_cast<std::uint8_t*>(out.data()), 4 * out.size()});
    return out;
}

class DisplayValues : public ::testing::TestWithParam<Isa> {
protected:
    void SetUp() override {
        if (!is_available(GetParam())) GTEST_SKIP();
        setenv("RAKELIGHT_ISA", name(GetParam()), 1);
    }
    void TearDown() override { unsetenv("RAKELIGHT_ISA"); }

    /// @return tiles that were made in the sink's memory
    static int expect_those_of_the_colors(const Scene& scene, const RenderSettings& settings) {
        Context context({.threads = 2});
        const auto engine = raster::make_engine();
        engine->prepare(scene, context);
        Frame frame;
        engine->render(busy_view(), settings, frame, context);
        DisplaySink by_tiles(false), in_memory(true);
        engine->render(busy_view(), settings, by_tiles, context);
        engine->render(busy_view(), settings, in_memory, context);
        EXPECT_TRUE(by_tiles.picture() == encoded(frame));
        EXPECT_TRUE(in_memory.picture() == encoded(frame));
        EXPECT_EQ(in_memory.touched(), frame.color.size()) << "beside the picture, or by chance";
        EXPECT_EQ(by_tiles.from_memory, 0);
        return in_memory.from_memory;
    }
};

Scene opaque_scene() {
    Scene scene = busy_scene();
    for (Material& m : scene.materials) m.alpha_mode = AlphaMode::opaque;
    return scene;
}

/// 4 x 3 tiles, those at the right and at the bottom in parts.
const RenderSettings whole = {.width = 230, .height = 150, .background = {0.1f, 0.2f, 0.3f, 0.5f}};

TEST_P(DisplayValues, OfOpaqueScenesAreThoseOfTheColors) {
    EXPECT_EQ(expect_those_of_the_colors(opaque_scene(), whole), 3 * 2);  // whole tiles only
}

TEST_P(DisplayValues, UnderGlassAreThoseOfTheColors) {
    EXPECT_EQ(expect_those_of_the_colors(busy_scene(), whole), 3 * 2);
}

TEST_P(DisplayValues, OfSamplesAreThoseOfTheColors) {
    RenderSettings settings = whole;
    settings.samples = 4;
    expect_those_of_the_colors(opaque_scene(), settings);
    expect_those_of_the_colors(busy_scene(), settings);
}

TEST_P(DisplayValues, OfWindowsThatCutTilesAreThoseOfTheColors) {
    RenderSettings settings = whole;
    for (const Window window : {Window{3, 5, 200, 140}, Window{64, 64, 64, 64}, Window{127, 1, 2, 99}}) {
        settings.window = window;
        expect_those_of_the_colors(opaque_scene(), settings);
    }
}

TEST_P(DisplayValues, OfObjectsOfAFewPixelsAreThoseOfTheColors) {
    // Vectors that are not full: what their last lanes repeat must not be taken for a block.
    for (unsigned seed = 1; seed <= 4; ++seed) {
        Scene scene = opaque_scene();
        scene.meshes.clear(), scene.nodes.clear();
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> at(-2, 2), size(0.02f, 0.3f);
        for (std::uint32_t n = 0; n < 1000; ++n) {
            Mesh mesh = square_mesh(n % 5);
            const float x = at(random), y = at(random), r = size(random), turn = at(random);
            mesh.positions = std::vector<vec3>{
                {x - r, y - r * turn, 0}, {x + r, y - r, 0}, {x + r * turn, y + r, 0}, {x - r, y + r, 0}};
            add_object(scene, std::move(mesh), dmat4{});
        }
        expect_those_of_the_colors(scene, whole);
    }
}

TEST_P(DisplayValues, OfAnEmptySceneAreTheBackground) { EXPECT_EQ(expect_those_of_the_colors(Scene{}, whole), 3 * 2); }

INSTANTIATE_TEST_SUITE_P(EachInstructionSet, DisplayValues,
                         ::testing::Values(Isa::scalar, Isa::sse2, Isa::avx2, Isa::avx512),
                         [](const auto& isa) { return std::string(name(isa.param)); });

/// What a tile shows: draws 0..7 in patches of several sizes, -1 in between.
std::vector<std::int32_t> patches(std::mt19937& random) {
    std::vector<std::int32_t> visible(raster::tile_size * raster::tile_size, -1);
    for (int n = 0; n < 40; ++n) {
        const int left = int(random() % 64), top = int(random() % 64), width = int(random() % 30);
        for (int y = top; y < std::min(top + width, 64); ++y)
            for (int x = left; x < std::min(left + width, 64); ++x) visible[std::size_t(y * 64 + x)] = n % 8;
    }
    return visible;
}

TEST(CollectKernel, ListsEachPixelOfADrawOnce) {
    std::mt19937 random(3);
    for (int round = 0; round < 20; ++round) {
        const std::vector<std::int32_t> visible = patches(random);
        for (const raster::GeometryKernels* kernels : raster::every_geometry_kernels()) {
            std::vector<std::int32_t> pixel(visible.size() + 32), shown(pixel);
            const auto count = std::size_t(kernels->collect(visible.data(), 2, 5, pixel.data(), shown.data()));
            for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(shown[i], visible[std::size_t(pixel[i])]);
            pixel.resize(count);
            std::sort(pixel.begin(), pixel.end());
            std::vector<std::int32_t> wanted;
            for (std::size_t p = 0; p < visible.size(); ++p)
                if (visible[p] >= 2 && visible[p] < 5) wanted.push_back(std::int32_t(p));
            ASSERT_TRUE(pixel == wanted);
        }
    }
}

TEST(FillEmptyKernel, WritesWhereNothingIsVisibleAndNowhereElse) {
    std::mt19937 random(4);
    constexpr std::size_t stride = 70;
    for (int round = 0; round < 20; ++round) {
        const std::vector<std::int32_t> visible = patches(random);
        for (const raster::GeometryKernels* kernels : raster::every_geometry_kernels()) {
            std::vector<std::uint32_t> out(stride * 64, untouched);
            kernels->fill_empty(visible.data(), 7, out.data(), stride);
            for (std::size_t y = 0; y < 64; ++y)
                for (std::size_t x = 0; x < stride; ++x)
                    ASSERT_EQ(out[y * stride + x], x < 64 && visible[y * 64 + x] < 0 ? 7 : untouched);
        }
    }
}

}  // namespace
