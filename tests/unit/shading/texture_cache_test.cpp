// SPDX-License-Identifier: Apache-2.0
#include "shading/texture_cache.h"

#include <gtest/gtest.h>

#include "support/scene_builder.h"
#include "unit/shading/fake_textures.h"

namespace rakelight::shading {
namespace {

using test::FakePacker;
using test::FakeTexture;
using test::picture;
using test::rgb_pixels;

Pixels bluish(int side) {
    return rgb_pixels(side, side, [](int, int) { return std::array{128, 128, 255}; });
}

TextureKey key(const ImageHandle& image, ColorSpace space = ColorSpace::srgb, Wrap wrap = Wrap::repeat) {
    return {image, space, wrap, wrap};
}

TEST(TextureCache, APictureIsPackedOnceForEachColorSpaceAndWrappingAndKeptWhileItIsWished) {
    Context context({.threads = 1});
    const FakePacker packer;
    TextureCache cache;
    const ImageHandle image = picture(bluish(4));
    const TextureKey color = key(image), data = key(image, ColorSpace::linear),
                     ended = key(image, ColorSpace::srgb, Wrap::clamp_to_edge);
    cache.update({{color}, {data}, {color}, {ended}}, packer, context);
    EXPECT_EQ(packer.packed, 3);
    EXPECT_TRUE(static_cast<const FakeTexture&>(*cache.find(color)->packed).is_srgb);
    EXPECT_FALSE(static_cast<const FakeTexture&>(*cache.find(data)->packed).is_srgb);
    EXPECT_EQ(static_cast<const FakeTexture&>(*cache.find(color)->packed).levels, 3);
    cache.update({{color}}, packer, context);
    EXPECT_EQ(packer.packed, 3) << "it was there";
    EXPECT_EQ(cache.find(data), nullptr) << "nobody wishes for it";
    cache.update({{data}}, packer, context);
    EXPECT_EQ(packer.packed, 4);
}

TEST(TextureCache, BumpsAreCheckedAlsoWhenThePictureWasThereAsData) {
    Context context({.threads = 1});
    const FakePacker packer;
    TextureCache cache;
    const TextureKey data = key(picture(bluish(4)), ColorSpace::linear);
    cache.update({{data}}, packer, context);
    EXPECT_FALSE(cache.find(data)->check);
    cache.update({{data}, {data, true}}, packer, context);
    ASSERT_TRUE(cache.find(data)->check);
    EXPECT_EQ(cache.find(data)->check->texels, 16u);
    cache.update({{data, true}}, packer, context);
    EXPECT_EQ(packer.packed, 2) << "it was there with its check";
}

TEST(TextureCache, MeansArePaidForWhetherThePictureIsMeasuredBeforeOrNot) {
    Context context({.threads = 1});
    const FakePacker packer;
    for (const bool is_measured : {false, true}) {
        auto image = std::make_shared<EncodedImage>(*picture(bluish(64)));
        if (is_measured)
            image->measure = [](const EncodedImage&, Context&) {
                return Pixels{.width = 64, .height = 64, .channels = 3};
            };
        TextureCache cache;
        const TextureKey color = key(image);
        cache.update({{color}}, packer, context);
        EXPECT_FALSE(cache.find(color)->means);
        cache.update({{color}, {color, false, true}}, packer, context);
        ASSERT_TRUE(cache.find(color)->means);
        EXPECT_EQ(cache.find(color)->means_charge.bytes(), MeanMap::bytes_for(64, 64)) << is_measured;
        EXPECT_EQ(context.memory().charged(), MeanMap::bytes_for(64, 64)) << is_measured;
        cache.update({}, packer, context);
        EXPECT_EQ(context.memory().charged(), 0u);
    }
}

/// Keeps the levels as they are given.
class LevelsPacker final : public TexturePacker {
public:
    struct Levels final : PackedTexture {
        std::vector<MipLevel> levels;
    };
    std::uint64_t packed_bytes(int, int, bool, bool) const override { return 0; }
    std::shared_ptr<const PackedTexture> pack(const MipChain& chain, const TextureKey&, MemoryCharge) const override {
        auto out = std::make_shared<Levels>();
        out->levels = chain.levels;
        return out;
    }
};

TEST(TextureCache, ACutoffThatMovedGivesTheLevelsOfOneThatDidNot) {
    Pixels leaf{.width = 64, .height = 64, .channels = 4};
    for (int i = 0; i < 64 * 64; ++i)
        for (const int c : {90, 160, 50, std::max(0, 255 - 3 * (i * 37 % 100))}) leaf.bytes.push_back(std::byte(c));
    const ImageHandle image = picture(leaf);
    const LevelsPacker packer;
    Context context({.threads = 1});
    const auto with_cutoff = [&](float cutoff) {
        TextureKey k = key(image);
        k.test = {cutoff, 3, true};
        return k;
    };
    TextureCache moved;
    for (const float cutoff : {0.2f, 0.35f, 0.5f, 0.35f, 0.7f}) {
        TextureCache still;
        moved.update({{with_cutoff(cutoff)}}, packer, context);
        still.update({{with_cutoff(cutoff)}}, packer, context);
        const auto levels = [&](const TextureCache& cache) -> const std::vector<MipLevel>& {
            return static_cast<const LevelsPacker::Levels&>(*cache.find(with_cutoff(cutoff))->packed).levels;
        };
        ASSERT_EQ(levels(moved).size(), levels(still).size());
        for (std::size_t l = 0; l < levels(still).size(); ++l)
            EXPECT_EQ(levels(moved)[l].rgba8, levels(still)[l].rgba8) << cutoff << " " << l;
    }
    EXPECT_TRUE(moved.find(with_cutoff(0.7f))->plain);
}

TEST(TextureCache, WhatCannotBeDecodedIsAWarningAndTheOthersAreThere) {
    Context context({.threads = 2});
    const FakePacker packer;
    TextureCache cache;
    auto broken = std::make_shared<EncodedImage>();
    broken->name = "broken.png", broken->file = "model.gltf";
    broken->decode = [](const EncodedImage&, Context&) -> Pixels { throw Error(ErrorCode::bad_file, "cut off"); };
    const TextureKey bad = key(broken), good = key(picture(bluish(2)));
    cache.update({{bad}, {good}}, packer, context);
    EXPECT_EQ(cache.find(bad), nullptr);
    EXPECT_NE(cache.find(good), nullptr);
    const auto entries = context.report().entries();
    ASSERT_EQ(entries.size(), 1u);
    EXPECT_EQ(entries[0].message, "texture left out: cut off");
    EXPECT_EQ(entries[0].place, "broken.png");
}

}  // namespace
}  // namespace rakelight::shading
