// SPDX-License-Identifier: Apache-2.0
// Texture sampling through the engine: what a square that fills the picture shows of its texture.
#include <gtest/gtest.h>

#include <cmath>

#include "engines/raster/raster_engine.h"
#include "math/color.h"
#include "support/scene_builder.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

/// Own color of a square that fills a 64 x 64 picture, textured, with texture coordinates scaled and shifted.
Frame show(const Pixels& pixels, Sampler sampler, vec2 scale = {1, 1}, vec2 offset = {0, 0}, float rotation = 0) {
    Scene scene;
    Material m = matte();
    m.base_color_texture = add_texture(scene, picture(pixels), sampler);
    m.base_color_texture.transform = {offset, scale, rotation};
    scene.materials = {m};
    add_object(scene, square_mesh(0));
    Context context({.threads = 1});
    auto engine = raster::make_engine();
    engine->prepare(scene, context);
    Frame frame;
    engine->render(flat_camera(), {.width = 64, .height = 64, .shading = Shading::unlit}, frame, context);
    return frame;
}

float red(const Frame& f, int x, int y) { return f.color[std::size_t(y * 64 + x)].x; }

/// 4 x 4 texels, red value by position.
Pixels steps() {
    return rgb_pixels(4, 4, [](int x, int y) { return std::array<int, 3>{16 * (4 * y + x), 0, 0}; });
}
float texel(int x, int y) { return linear_from_srgb8(std::uint8_t(16 * (4 * y + x))); }

/// Colors are kept as linear codes of 15 bits: one is off by at most half a step, what is filtered in 2 axes by a step
/// more.
constexpr double half_code = 0.51 / 32767, filtered_code = 1.6 / 32767;

constexpr Sampler nearest{.magnify = Filter::nearest, .minify = Filter::nearest, .mip = MipFilter::none};

}  // namespace

TEST(Sampling, NearestShowsEachTexelInItsPlaceWithTheFirstRowOnTop) {
    const Frame f = show(steps(), nearest);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) EXPECT_NEAR(red(f, x, y), texel(x / 16, y / 16), half_code) << x << ", " << y;
}

TEST(Sampling, BilinearInterpolatesLinearLightBetweenTexelCenters) {
    const Frame f = show(steps(), {});
    // Pixel centers lie at (x + 0.5) / 16 texels; texel centers at n + 0.5.
    for (int x = 8; x < 56; ++x) {
        const double at = (x + 0.5) / 16 - 0.5, t = at - std::floor(at);
        const int i = int(std::floor(at));
        const double expected = texel(i, 0) * (1 - t) + texel(i + 1, 0) * t;
        const double y_at = (8 + 0.5) / 16 - 0.5, row = y_at - std::floor(y_at);
        const double below = texel(i, 1) * (1 - t) + texel(i + 1, 1) * t;
        EXPECT_NEAR(red(f, x, 8), expected * (1 - row) + below * row, filtered_code) << x;
    }
}

TEST(Sampling, WrapModesContinueTheTextureAsTheirNamesSay) {
    const auto across = [](Wrap wrap) {
        Sampler s = nearest;
        s.wrap_u = s.wrap_v = wrap;
        return show(steps(), s, {3, 1}, {-1, 0});  // u from -1 to 2
    };
    const Frame repeat = across(Wrap::repeat), mirrored = across(Wrap::mirrored_repeat),
                clamped = across(Wrap::clamp_to_edge);
    for (int x = 0; x < 64; ++x) {
        const double u = -1 + 3 * (x + 0.5) / 64;
        const double folded = std::fabs(u - 2 * std::floor(u / 2 + 0.5));
        EXPECT_NEAR(red(repeat, x, 2), texel(int((u - std::floor(u)) * 4), 0), half_code) << x;
        EXPECT_NEAR(red(mirrored, x, 2), texel(std::min(3, int(folded * 4)), 0), half_code) << x;
        EXPECT_NEAR(red(clamped, x, 2), texel(int(std::fmin(std::fmax(u, 0), 0.999) * 4), 0), half_code) << x;
    }
}

TEST(Sampling, ARepeatedTextureHasNoSeamAtItsBorder) {
    const Pixels even = rgb_pixels(4, 4, [](int, int) { return std::array<int, 3>{200, 0, 0}; });
    const Frame f = show(even, {}, {2, 2}, {0.37f, 0.81f});
    for (const vec4& c : f.color) EXPECT_NEAR(c.x, linear_from_srgb8(200), half_code);
}

TEST(Sampling, AMinifiedCheckerboardIsItsMeanInLinearLight) {
    const Pixels checks = rgb_pixels(256, 256, [](int x, int y) {
        const int v = (x + y) & 1 ? 255 : 0;
        return std::array<int, 3>{v, v, v};
    });
    const Frame f = show(checks, {}, {4, 4});  // 16 texels a pixel
    for (const vec4& c : f.color) EXPECT_NEAR(c.x, 0.5f, 0.01f);
}

TEST(Sampling, TheLevelOfDetailIsTheLogarithmOfTexelsAPixel) {
    // A texture that is bright only in its even columns of 2^k texels turns gray exactly when levels above k are read.
    const Pixels stripes = rgb_pixels(256, 256, [](int x, int) {
        const int v = (x / 4) & 1 ? 255 : 0;
        return std::array<int, 3>{v, v, v};
    });
    Sampler level_nearest{.magnify = Filter::nearest, .minify = Filter::nearest, .mip = MipFilter::nearest};
    const auto is_gray = [](const Frame& f) {
        for (const vec4& c : f.color)
            if (c.x > 0.1f && c.x < 0.9f) return true;
        return false;
    };
    EXPECT_FALSE(is_gray(show(stripes, level_nearest, {0.25f, 0.25f}))) << "one texel a pixel: level 0";
    EXPECT_FALSE(is_gray(show(stripes, level_nearest, {0.5f, 0.5f}))) << "two texels a pixel: level 1, stripes of 2";
    EXPECT_FALSE(is_gray(show(stripes, level_nearest, {1, 1}))) << "four: level 2, stripes of 1";
    EXPECT_TRUE(is_gray(show(stripes, level_nearest, {2, 2}))) << "eight: level 3, stripes are gone";
}

TEST(Sampling, TheNearestMipLevelIsTheOneWhoseTexelsAreNearestToAPixel) {
    // Columns of one texel are gray from level 1 on, columns of two from level 2.
    const Sampler s{.magnify = Filter::nearest, .minify = Filter::nearest, .mip = MipFilter::nearest};
    for (const int width : {1, 2}) {
        const Pixels columns = rgb_pixels(256, 256, [width](int x, int) {
            const int v = (x / width) & 1 ? 255 : 0;
            return std::array<int, 3>{v, v, v};
        });
        for (const double above : {0.05, 0.4, 0.45, 0.55, 0.6, 0.95}) {
            const double lod = width - 1 + above;  // of the level that is read, and the next one, which is gray
            const float scale = float(0.25 * std::exp2(lod));
            for (const vec4& c : show(columns, s, {scale, scale}).color)
                ASSERT_EQ(c.x > 0.1f && c.x<0.9f, above> 0.5) << width << ", " << lod;
        }
    }
}

TEST(Sampling, TextureTransformsScaleTurnAndShiftAsTheExtensionSays) {
    // A quarter turn: u' = v, v' = -u (plus 1 to come back into 0..1).
    const Frame f = show(steps(), nearest, {1, 1}, {0, 1}, float(pi / 2));
    for (const auto& [x, y] : {std::pair(5, 5), std::pair(60, 10), std::pair(20, 50)}) {
        const double u = (x + 0.5) / 64, v = (y + 0.5) / 64;
        EXPECT_NEAR(red(f, x, y), texel(int(v * 4), int((1 - u) * 4)), half_code) << x << ", " << y;
    }
}

TEST(Sampling, NotFiniteAndHugeCoordinatesGiveAFinitePicture) {
    for (const float offset : {1e20f, -1e20f, 3e38f})
        for (const vec4& c : show(steps(), {}, {1, 1}, {offset, offset}).color) EXPECT_TRUE(std::isfinite(c.x));
}

TEST(Sampling, BilinearAtTheBorderMixesWhatTheWrapModeSays) {
    const auto left_edge = [](Wrap wrap) {
        Sampler s;
        s.wrap_u = s.wrap_v = wrap;
        return red(show(steps(), s), 0, 8);
    };
    // Pixel (0, 8): 1/32 of a texel from the left border, so 15/32 of the share is the neighbor's; rows 0 and 1 share 31 : 1.
    const auto row = [](int x) { return texel(x, 0) * 31 / 32 + texel(x, 1) / 32; };
    EXPECT_NEAR(left_edge(Wrap::clamp_to_edge), row(0), filtered_code);
    EXPECT_NEAR(left_edge(Wrap::mirrored_repeat), row(0), filtered_code);
    EXPECT_NEAR(left_edge(Wrap::repeat), row(0) * 17 / 32 + row(3) * 15 / 32, filtered_code);
}

TEST(Sampling, ATextureOfOneTexelIsThatColorEverywhere) {
    const Pixels one = rgb_pixels(1, 1, [](int, int) { return std::array<int, 3>{100, 0, 0}; });
    for (const Wrap wrap : {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge}) {
        Sampler s;
        s.wrap_u = s.wrap_v = wrap;
        for (const vec4& c : show(one, s, {7, 5}, {-3, 2}).color) EXPECT_NEAR(c.x, linear_from_srgb8(100), half_code);
    }
}

TEST(Sampling, APictureWithoutPixelsIsLeftOut) {
    const Frame f = show(Pixels{0, 0, 3, Component::u8, false, {}}, {});
    for (const vec4& c : f.color) EXPECT_EQ(c.x, 1.0f);
}

TEST(Sampling, TexturesWithUnsupportedCoordinateSetsAreLeftOutAndSaid) {
    Scene scene;
    Material m = matte();
    m.base_color_texture = add_texture(scene, picture(steps()));
    m.base_color_texture.texcoord_set = 2;
    scene.materials = {m};
    add_object(scene, square_mesh(0));
    Context context({.threads = 1});
    auto engine = raster::make_engine();
    engine->prepare(scene, context);
    ASSERT_EQ(context.report().entries().size(), 1u);
    EXPECT_EQ(context.report().entries()[0].remark, Remark::dropped);
    Frame frame;
    engine->render(flat_camera(), {.width = 64, .height = 64, .shading = Shading::unlit}, frame, context);
    EXPECT_EQ(red(frame, 9, 9), 1.0f);
}

TEST(Sampling, BrokenPicturesAreReportedInTheOrderOfTheirUseForAnyNumberOfThreads) {
    Scene scene;
    for (int i = 0; i < 40; ++i) {
        auto broken = std::make_shared<EncodedImage>();
        broken->name = std::to_string(i * 7 % 40);
        broken->decode = [](const EncodedImage& e, Context&) -> Pixels {
            throw Error(ErrorCode::bad_file, "broken " + e.name);
        };
        Material m = matte();
        m.base_color_texture = add_texture(scene, broken);
        scene.materials.push_back(m);
        add_object(scene, square_mesh(std::uint32_t(i)));
    }
    for (const int threads : {1, 4}) {
        Context context({.threads = threads});
        raster::make_engine()->prepare(scene, context);
        const std::vector<ReportEntry> entries = context.report().entries();
        ASSERT_EQ(entries.size(), 40u);
        for (std::size_t i = 0; i < 40; ++i) EXPECT_EQ(entries[i].place, std::to_string(i * 7 % 40));
    }
}

TEST(Sampling, PicturesThatDoNotFitAreLeftOutBeforeTheyAreDecoded) {
    Scene scene;
    int decoded = 0;
    for (int i = 0; i < 8; ++i) {
        auto image = std::make_shared<EncodedImage>();
        const int side = i == 0 ? 16000 : 64;
        image->name = std::to_string(i);
        image->measure = [side](const EncodedImage&, Context&) {
            return Pixels{side, side, 1, Component::u8, false, {}};
        };
        image->decode = [side, &decoded](const EncodedImage&, Context&) {
            ++decoded;
            return Pixels{side,          side,  1,
                          Component::u8, false, std::vector<std::byte>(std::size_t(side) * std::size_t(side))};
        };
        Material m = matte();
        m.base_color_texture = add_texture(scene, image);
        scene.materials.push_back(m);
        add_object(scene, square_mesh(std::uint32_t(i)));
    }
    Context context({.threads = 1, .max_memory = 200'000});  // a small one is kept as 48 kB
    raster::make_engine()->prepare(scene, context);
    EXPECT_EQ(decoded, 3);
    const std::vector<ReportEntry> entries = context.report().entries();
    ASSERT_EQ(entries.size(), 2u);  // equal messages are one entry
    EXPECT_EQ(entries[0].place, "0");
    EXPECT_EQ(entries[1].place, "4");
    EXPECT_EQ(entries[1].count, 4u);
}

/// Which textures are left out when memory is short is a matter of their order, never of threads; what only decoding needed
/// is given back.
TEST(Sampling, ShortMemoryLeavesOutTheSameTexturesForAnyNumberOfThreads) {
    Scene scene;
    for (int i = 0; i < 24; ++i) {
        auto image = std::make_shared<EncodedImage>();
        image->name = std::to_string(i);
        const int side = 32 << (i * 5 % 3);
        image->decode = [side](const EncodedImage&, Context& context) {
            MemoryCharge charge(context.memory(), std::uint64_t(3) * std::uint64_t(side * side), "the picture");
            Pixels pixels = rgb_pixels(side, side, [](int, int) { return std::array<int, 3>{200, 100, 50}; });
            pixels.charge = share(std::move(charge));
            return pixels;
        };
        if (i % 4 != 0)
            image->measure = [side](const EncodedImage&, Context&) {
                return Pixels{side, side, 3, Component::u8, false, {}};
            };
        Material m = matte();
        m.base_color_texture = add_texture(scene, image);
        scene.materials.push_back(m);
        add_object(scene, square_mesh(std::uint32_t(i)));
    }
    const auto left_out = [&](int threads, std::uint64_t max_memory) {
        Context context({.threads = threads, .max_memory = max_memory});
        raster::make_engine()->prepare(scene, context);
        EXPECT_LE(context.memory().charged(), max_memory);
        std::vector<std::string> names;
        for (const ReportEntry& e : context.report().entries()) names.push_back(e.place + e.message);
        return names;
    };
    const std::vector<std::string> reference = left_out(1, 400'000);
    EXPECT_GT(reference.size(), 3u);
    EXPECT_LT(reference.size(), 21u);
    for (int round = 0; round < 20; ++round) EXPECT_EQ(left_out(4, 400'000), reference);
    // 24 textures with their smaller versions: 8 (32^2 + 64^2 + 128^2) 4 / 3 texels of 8 bytes, 1835 kB; decoding adds
    // 516 kB.
    EXPECT_TRUE(left_out(4, 2'250'000).empty()) << "room for the textures and one more while it is decoded";
    EXPECT_TRUE(left_out(1, 2'250'000).empty());
}

TEST(Sampling, APictureThatCannotBeDecodedBecomesAWarning) {
    Scene scene;
    Material m = matte();
    auto broken = std::make_shared<EncodedImage>();
    broken->name = "broken.png";
    broken->decode = [](const EncodedImage&, Context&) -> Pixels { throw Error(ErrorCode::bad_file, "not a picture"); };
    m.base_color_texture = add_texture(scene, broken);
    scene.materials = {m};
    add_object(scene, square_mesh(0));
    Context context({.threads = 1});
    raster::make_engine()->prepare(scene, context);
    ASSERT_EQ(context.report().entries().size(), 1u);
    EXPECT_EQ(context.report().entries()[0].message, "texture left out: not a picture");
}
