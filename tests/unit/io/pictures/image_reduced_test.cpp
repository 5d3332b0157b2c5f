// SPDX-License-Identifier: Apache-2.0
// Pictures at a fraction of their size.
#include <gtest/gtest.h>

#include <algorithm>

#include "image/decode.h"
#include "io/pictures/image_io.h"
#include "io/pictures/reduced_image.h"
#include "support/shared.h"
#include "unit/io/pictures/image_io_support.h"

namespace rakelight::io {
namespace {

using codec::Want;
using test::bytes_of_file;
using test::error_of;
using test::noise_picture;

std::vector<std::byte> encoded(const Pixels& pixels, const std::string& name) {
    std::vector<std::byte> bytes;
    write_image({name, bytes}, pixels);
    return bytes;
}

/// The means of blocks, in the straightforward way.
template <class Value>
double block_mean(const Pixels& p, int factor, int x, int y, int channel) {
    double sum = 0;
    int count = 0;
    for (int v = y * factor; v < std::min(p.height, (y + 1) * factor); ++v)
        for (int u = x * factor; u < std::min(p.width, (x + 1) * factor); ++u, ++count)
            sum += double(reinterpret_cast<const Value*>(p.row(v))[u * p.channels + channel]);
    return sum / count;
}

template <class Value>
void expect_means(const Pixels& whole, const Pixels& reduced, int factor, double tolerance) {
    ASSERT_EQ(reduced.width, (whole.width + factor - 1) / factor);
    ASSERT_EQ(reduced.height, (whole.height + factor - 1) / factor);
    ASSERT_EQ(reduced.channels, whole.channels);
    ASSERT_EQ(reduced.component, whole.component);
    for (int y = 0; y < reduced.height; ++y)
        for (int x = 0; x < reduced.width; ++x)
            for (int c = 0; c < reduced.channels; ++c)
                ASSERT_NEAR(double(reinterpret_cast<const Value*>(reduced.row(y))[x * reduced.channels + c]),
                            block_mean<Value>(whole, factor, x, y, c), tolerance)
                    << x << ", " << y << ", channel " << c;
}

TEST(ReducedImage, PngIsTheMeanOfBlocksWithFewerPixelsAtTheBorder) {
    Context context;
    for (const int channels : {1, 3, 4}) {
        const Pixels whole = noise_picture(37, 21, channels, Component::u8);
        const auto bytes = encoded(whole, "a.png");
        expect_means<std::uint8_t>(whole, codec::read_reduced(bytes, 10, Want::pixels, context), 4, 0.5001);
        expect_means<std::uint8_t>(whole, codec::read_reduced(bytes, 1, Want::pixels, context), 64, 0.5001);
    }
    const Pixels deep = noise_picture(37, 21, 3, Component::u16);
    expect_means<std::uint16_t>(deep, codec::read_reduced(encoded(deep, "a.png"), 20, Want::pixels, context), 2,
                                0.5001);
}

TEST(ReducedImage, FormatsThatAreReadAsAWholeAreReducedToo) {
    Context context;
    const Pixels light = noise_picture(20, 12, 3, Component::f32);
    const auto bytes = encoded(light, "a.hdr");
    const Pixels whole = decode_image(bytes, context), reduced = codec::read_reduced(bytes, 5, Want::pixels, context);
    expect_means<float>(whole, reduced, 4, 1e-4);
    EXPECT_TRUE(reduced.is_linear);
}

TEST(ReducedImage, JpegIsNearTheMeanOfBlocks) {
    Context context;
    Pixels ramp{200, 100, 3, Component::u8, false, std::vector<std::byte>(200 * 100 * 3)};
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 200 * 3; ++x) ramp.row(y)[x] = std::byte(x / 5 + y);
    const auto bytes = encoded(ramp, "a.jpg");
    const Pixels whole = decode_image(bytes, context);
    for (const int factor : {2, 4, 8, 16})
        expect_means<std::uint8_t>(whole, codec::read_reduced(bytes, 200 / factor + 1, Want::pixels, context), factor,
                                   4);
}

TEST(ReducedImage, APictureThatIsSmallEnoughKeepsItsPixels) {
    Context context;
    for (const char* const name : {"a.png", "a.jpg"}) {
        const auto bytes = encoded(noise_picture(16, 8, 3, Component::u8), name);
        EXPECT_EQ(codec::read_reduced(bytes, 16, Want::pixels, context).bytes, decode_image(bytes, context).bytes);
    }
}

TEST(ReducedImage, TheHeaderHasTheReducedSize) {
    Context context;
    for (const char* const name : {"a.png", "a.jpg"}) {
        const auto bytes = encoded(noise_picture(37, 21, 3, Component::u8), name);
        const Pixels header = codec::read_reduced(bytes, 10, Want::header, context);
        EXPECT_EQ(header.width, 10);
        EXPECT_EQ(header.height, 6);
        EXPECT_TRUE(header.bytes.empty());
    }
}

TEST(ReducedImage, AnInterlacedPngIsReducedToo) {
    const auto folder = test::shared_dir() / "assets/textures/pngsuite";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
    Context context;
    const auto colors = bytes_of_file(folder / "basi2c16.png"), palette = bytes_of_file(folder / "basi3p08.png");
    expect_means<std::uint16_t>(decode_image(colors, context), codec::read_reduced(colors, 8, Want::pixels, context), 4,
                                0.5001);
    expect_means<std::uint8_t>(decode_image(palette, context), codec::read_reduced(palette, 8, Want::pixels, context),
                               4, 0.5001);
}

TEST(ReducedImage, ACutFileIsAnError) {
    Context context;
    for (const char* const name : {"a.png", "a.jpg"}) {
        auto bytes = encoded(noise_picture(64, 64, 3, Component::u8), name);
        bytes.resize(bytes.size() / 2);
        EXPECT_EQ(error_of([&] { codec::read_reduced(bytes, 8, Want::pixels, context); }).code(), ErrorCode::bad_file);
    }
    EXPECT_EQ(error_of([&] { codec::read_reduced({}, 8, Want::header, context); }).code(), ErrorCode::bad_file);
}

TEST(ReducedImage, TheWorkIsThatOfAPngAndOthersAreWeighedByFormatAndDepth) {
    Context context;
    const std::uint64_t pixels = 64 * 32, reduced = 16 * 8;
    const auto work = [&](const Pixels& picture, const std::string& name) {
        return codec::reduced_work(encoded(picture, name), 16, context) - reduced;
    };
    const Pixels picture = noise_picture(64, 32, 3, Component::u8), light = noise_picture(64, 32, 3, Component::f32);
    EXPECT_EQ(work(picture, "a.png"), pixels);
    EXPECT_EQ(work(noise_picture(64, 32, 1, Component::u8), "a.png"), pixels / 3);
    EXPECT_EQ(work(noise_picture(64, 32, 4, Component::u16), "a.png"), pixels * 4);
    EXPECT_EQ(work(picture, "a.jpg"), pixels / 4);
    EXPECT_EQ(work(picture, "a.webp"), pixels * 3 / 2);
    EXPECT_EQ(work(light, "a.hdr"), pixels * 3 / 2);
    EXPECT_EQ(codec::reduced_work(encoded(picture, "a.jpg"), 64, context), pixels / 2 + pixels) << "not reduced";
    EXPECT_EQ(error_of([&] { codec::reduced_work({}, 16, context); }).code(), ErrorCode::bad_file);
    const ImageHandle missing = image_from_file("a", "model.gltf", "/nowhere/a.png");
    EXPECT_EQ(decoding_work(*missing, 16, context), 0u);
}

TEST(ReducedImage, AHandleDecodesAndMeasuresTheReducedPicture) {
    Context context;
    const auto bytes =
        std::make_shared<const std::vector<std::byte>>(encoded(noise_picture(64, 32, 4, Component::u8), "a.png"));
    const ImageHandle whole = image_from_bytes("texture", "model.glb", bytes, "image/png");
    const ImageHandle reduced = reduced_image(whole, 16);
    EXPECT_EQ(decode(*reduced, context).width, 16);
    EXPECT_EQ(reduced->measure(*reduced, context).width, 16);
    EXPECT_EQ(decode(*whole, context).width, 64);
    EXPECT_EQ(reduced->name, "texture");
    const auto own = std::make_shared<const EncodedImage>(EncodedImage{.name = "own", .decode = nullptr});
    EXPECT_EQ(reduced_image(own, 16), own);
}

}  // namespace
}  // namespace rakelight::io
