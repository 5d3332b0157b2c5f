// SPDX-License-Identifier: Apache-2.0
// Every format by writing and reading it, and what the dispatcher says to files that are none.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string_view>

#include "image/compare/compare.h"
#include "io/pictures/image_io.h"
#include "support/shared.h"
#include "unit/io/pictures/image_io_support.h"

namespace rakelight::io {
namespace {

using test::bytes_of_file;
using test::error_of;
using test::noise_picture;
using test::TemporaryFolder;

std::vector<std::byte> bytes_of(std::string_view text) {
    const auto bytes = std::as_bytes(std::span(text.data(), text.size()));
    return {bytes.begin(), bytes.end()};
}

Pixels floats(int width, int height, int channels, const std::vector<float>& values) {
    Pixels pixels{width, height, channels, Component::f32, true, {}};
    pixels.bytes.resize(values.size() * 4);
    std::memcpy(pixels.bytes.data(), values.data(), pixels.bytes.size());
    return pixels;
}

std::vector<float> values_of(const Pixels& pixels) {
    std::vector<float> values(pixels.bytes.size() / 4);
    std::memcpy(values.data(), pixels.bytes.data(), pixels.bytes.size());
    return values;
}

Pixels round_trip(const std::string& name, const Pixels& pixels) {
    const TemporaryFolder folder;
    write_image(folder.file(name), pixels);
    Context context;
    return decode_image(bytes_of_file(folder.file(name)), context);
}

/// A picture without hard edges, which lossy formats keep well.
Pixels ramp_picture(int width, int height, int channels) {
    Pixels pixels{width, height, channels, Component::u8, false, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < channels; ++c)
                pixels.bytes.push_back(std::byte(40 + 100 * x / width + 80 * y / height + 10 * c));
    return pixels;
}

TEST(JpegRoundTrip, StaysCloseInColorAndGray) {
    for (const int channels : {1, 3}) {
        const Pixels pixels = ramp_picture(61, 33, channels), back = round_trip("a.jpg", pixels);
        EXPECT_EQ(back.channels, channels);
        EXPECT_LT(compare_pictures(pixels, back).max_absolute, 6.0 / 255);
        EXPECT_GT(compare_pictures(pixels, back).psnr_db, 45);
    }
}

TEST(JpegRoundTrip, AFourthChannelIsDroppedAndThinColorsKeepTheirPlace) {
    Pixels pixels = ramp_picture(32, 16, 4);
    EXPECT_EQ(round_trip("a.jpeg", pixels).channels, 3);
    Pixels lines{32,    16, 3, Component::u8,
                 false, {}};  // red and blue columns in turn: chroma subsampling would make them purple
    for (int i = 0; i < 32 * 16; ++i)
        for (const int v : {i % 2 * 200, 0, (1 - i % 2) * 200}) lines.bytes.push_back(std::byte(v));
    EXPECT_GT(compare_pictures(lines, round_trip("a.jpg", lines)).psnr_db, 30);
}

TEST(JpegReading, EveryTruncationOfABaselineAndAProgressiveFileIsRefusedOrWhole) {
    RL_NEEDS_SHARED("assets");
    const auto bytes = bytes_of_file(test::shared_dir() / "hostile/gltf-validator/image/cyan.jpg");
    Context context;
    const Pixels whole = decode_image(bytes, context);
    for (std::size_t size = 0; size < bytes.size(); ++size) try {
            EXPECT_EQ(decode_image(std::span(bytes).first(size), context).bytes, whole.bytes) << size;
            EXPECT_GT(size + 8, bytes.size());
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::bad_file);
        }
}

TEST(WebpRoundTrip, IsExactWithColorsUnderZeroAlpha) {
    for (const int channels : {3, 4}) {
        Pixels pixels = noise_picture(37, 19, channels, Component::u8);
        if (channels == 4) pixels.bytes[3] = pixels.bytes[7] = std::byte(0);
        const Pixels back = round_trip("a.webp", pixels);
        EXPECT_EQ(back.channels, channels);
        EXPECT_EQ(back.bytes, pixels.bytes);
    }
}

TEST(WebpRoundTrip, GrayBecomesRgb) {
    const Pixels pixels = noise_picture(5, 3, 1, Component::u8), back = round_trip("a.webp", pixels);
    ASSERT_EQ(back.channels, 3);
    for (std::size_t i = 0; i < 15; ++i)
        for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(back.bytes[3 * i + c], pixels.bytes[i]);
}

TEST(ExrRoundTrip, FloatsComeBackToTheBit) {
    for (const int channels : {1, 3}) {
        for (const auto& [width, height] : {std::pair{1, 1}, {40, 37}, {300, 2}}) {
            const Pixels pixels = noise_picture(width, height, channels, Component::f32),
                         back = round_trip("a.exr", pixels);
            EXPECT_EQ(back.width, width);
            EXPECT_EQ(back.height, height);
            EXPECT_EQ(back.channels, channels);
            EXPECT_EQ(back.component, Component::f32);
            EXPECT_TRUE(back.is_linear);
            EXPECT_EQ(back.bytes, pixels.bytes);
        }
    }
}

TEST(ExrRoundTrip, AlphaIsMultipliedInTheFileAndComesBackApart) {
    const std::vector<float> values{0.5f, 2, 8, 0.5f, 1, 1, 1, 1, 4, 4, 4, 0};
    EXPECT_EQ(values_of(round_trip("a.exr", floats(3, 1, 4, values))),
              (std::vector<float>{0.5f, 2, 8, 0.5f, 1, 1, 1, 1, 0, 0, 0, 0}));
}

TEST(ExrRoundTrip, InfinitiesAndNanSurvive) {
    const float infinity = std::numeric_limits<float>::infinity();
    const std::vector<float> back =
        values_of(round_trip("a.exr", floats(3, 1, 1, {infinity, -infinity, std::nanf("")})));
    EXPECT_EQ(back[0], infinity);
    EXPECT_EQ(back[1], -infinity);
    EXPECT_TRUE(std::isnan(back[2]));
}

TEST(PpmWriting, IsAHeaderAndTheColorsWithoutAlpha) {
    for (const int channels : {1, 2, 3, 4}) {
        const Pixels pixels = ramp_picture(5, 2, channels);
        std::vector<std::byte> file;
        write_image({"a.ppm", file}, pixels);
        const std::size_t colors = channels < 3 ? 1 : 3;
        const std::string header = channels < 3 ? "P5\n5 2\n255\n" : "P6\n5 2\n255\n";
        ASSERT_EQ(file.size(), header.size() + 10 * colors);
        EXPECT_TRUE(std::equal(header.begin(), header.end(), file.begin(),
                               [](char c, std::byte b) { return b == std::byte(c); }));
        for (std::size_t i = 0; i < 10 * colors; ++i)
            EXPECT_EQ(file[header.size() + i], pixels.bytes[i / colors * std::size_t(channels) + i % colors]);
    }
}

TEST(HdrRoundTrip, KeepsEightBitsOfTheBrightestComponent) {
    for (const int width : {1, 7, 8, 9, 300, 1000}) {
        const Pixels pixels = noise_picture(width, 5, 3, Component::f32), back = round_trip("a.hdr", pixels);
        ASSERT_EQ(back.width, width);
        EXPECT_TRUE(back.is_linear);
        const std::vector<float> a = values_of(pixels), b = values_of(back);
        for (std::size_t i = 0; i < a.size(); i += 3) {
            const float largest = std::max({a[i], a[i + 1], a[i + 2]});
            for (std::size_t c = 0; c < 3; ++c) ASSERT_NEAR(a[i + c], b[i + c], largest / 255) << width << " " << i;
        }
    }
}

TEST(HdrRoundTrip, RunsOfEveryLengthComeBack) {
    std::vector<float> values;
    for (int run = 1; run <= 300; ++run)
        for (int i = 0; i < run; ++i) values.insert(values.end(), {float(run % 2), 0.5f, float(i % 2)});
    const int width = int(values.size() / 3);
    EXPECT_EQ(values_of(round_trip(
                  "a.hdr", floats(width <= 32767 ? width : 32767, 1, 3,
                                  std::vector<float>(values.begin(), values.begin() + std::min(width, 32767) * 3)))),
              std::vector<float>(values.begin(), values.begin() + std::min(width, 32767) * 3));
}

TEST(HdrRoundTrip, WhatTheFormatCannotHoldIsBroughtIntoIt) {
    const float infinity = std::numeric_limits<float>::infinity(), largest = std::numeric_limits<float>::max();
    const std::vector<float> back = values_of(round_trip(
        "a.hdr",
        floats(4, 1, 3, {-1, std::nanf(""), 1, infinity, 0, 0, largest, 0, 1e-45f, 1e-39f, 6e-39f, 255.9f / 256.0f})));
    EXPECT_EQ((std::vector<float>(back.begin(), back.begin() + 3)), (std::vector<float>{0, 0, 1}));
    EXPECT_EQ(back[3], 255.0f * 0x1p119f);
    EXPECT_EQ(back[6], 255.0f * 0x1p119f);
    EXPECT_EQ(back[11], 1.0f);  // rounded up over the end of its octave
}

TEST(HdrReading, KnowsPlainAndOldRunLengthLinesAndBottomUpPictures) {
    using namespace std::string_view_literals;
    const auto file = bytes_of(
        "#?RADIANCE\n# made by hand\nEXPOSURE=1\nFORMAT=32-bit_rle_rgbe\n\n+Y 2 +X 3\n"
        "\x80\x40\x00\x81\x01\x01\x01\x02"
        "\x80\x00\x00\x80\x00\x80\x00\x80\x00\x00\x80\x80"sv);
    Context context;
    EXPECT_EQ(values_of(decode_image(file, context)),
              (std::vector<float>{0.5f, 0, 0, 0, 0.5f, 0, 0, 0, 0.5f, 1, 0.5f, 0, 1, 0.5f, 0, 1, 0.5f, 0}));
}

TEST(TgaReading, UnderstandsOrderOfRowsColumnsAndComponents) {
    // 2 x 2, 24 bits BGR; the descriptor's bits 4 and 5 say right to left and top to bottom.
    std::vector<std::byte> file(18 + 12);
    file[2] = std::byte(2);
    file[12] = file[14] = std::byte(2);
    file[16] = std::byte(24);
    for (std::size_t i = 0; i < 12; ++i) file[18 + i] = std::byte(i);
    const auto first_red = [&](int descriptor) {
        file[17] = std::byte(descriptor);
        Context context;
        const Pixels pixels = decode_image(file, context);
        EXPECT_EQ(pixels.channels, 3);
        return int(pixels.bytes[0]);
    };
    EXPECT_EQ(first_red(0x20), 2);
    EXPECT_EQ(first_red(0x30), 5);
    EXPECT_EQ(first_red(0x00), 8);
    EXPECT_EQ(first_red(0x10), 11);
}

TEST(TgaReading, RunLengthsAreReadAndCutFilesRefused) {
    std::vector<std::byte> file(18);
    file[2] = std::byte(11);  // gray, run lengths
    file[12] = std::byte(5);
    file[14] = std::byte(1);
    file[16] = std::byte(8);
    file[17] = std::byte(0x20);
    for (const int b : {0x82, 9, 0x01, 7, 8}) file.push_back(std::byte(b));
    Context context;
    const Pixels pixels = decode_image(file, context);
    EXPECT_EQ(pixels.bytes,
              (std::vector<std::byte>{std::byte(9), std::byte(9), std::byte(9), std::byte(7), std::byte(8)}));
    for (std::size_t size = 18; size < file.size(); ++size)
        EXPECT_THROW(decode_image(std::span(file).first(size), context), Error);
}

TEST(BmpReading, ReadsRowsFromBelowAndRefusesCutFiles) {
    std::vector<std::byte> file(54);
    file[0] = std::byte('B');
    file[1] = std::byte('M');
    file[10] = std::byte(54);
    file[14] = std::byte(40);
    file[18] = std::byte(1);
    file[22] = std::byte(2);
    file[26] = std::byte(1);
    file[28] = std::byte(24);
    for (const int b : {1, 2, 3, 0, 4, 5, 6, 0}) file.push_back(std::byte(b));
    Context context;
    EXPECT_EQ(decode_image(file, context).bytes, (std::vector<std::byte>{std::byte(6), std::byte(5), std::byte(4),
                                                                         std::byte(3), std::byte(2), std::byte(1)}));
    for (std::size_t size = 2; size < file.size(); ++size)
        EXPECT_THROW(decode_image(std::span(file).first(size), context), Error) << size;
    file[25] = std::byte(0x80);  // a height of about -2^31
    EXPECT_THROW(decode_image(file, context), Error);
    file[25] = file[28] = std::byte(0);
    EXPECT_THROW(decode_image(file, context), Error);
}

TEST(FloatReading, EveryTruncationIsRefused) {
    const TemporaryFolder folder;
    for (const char* name : {"a.exr", "a.hdr", "b.webp"}) {
        const Component component = component_for(name);
        write_image(folder.file(name), noise_picture(20, 20, 3, component));
        const auto bytes = bytes_of_file(folder.file(name));
        Context context;
        for (std::size_t size = 0; size < bytes.size(); size += 7)
            EXPECT_EQ(error_of([&] { decode_image(std::span(bytes).first(size), context); }).code(),
                      ErrorCode::bad_file)
                << name << size;
    }
}

TEST(DecodeImage, SaysWhatItCannotRead) {
    Context context;
    for (const auto& [content, word] : {std::pair{"", "empty"},
                                        {"hello", "not a picture"},
                                        {"GIF89a...", "GIF"},
                                        {"DDS ....", "DDS"},
                                        {"\xabKTX 20\xbb", "KTX"},
                                        {"#?RADIANCE\n\n-X 3 +Y 3\n", "rotated"},
                                        {"BM", "too early"},
                                        {"\xff\xd8\xff\xe0", "JPEG"},
                                        {"\x89PNG\r\n\x1a\n", "PNG"},
                                        {"RIFFxxxxWEBP", "WebP"},
                                        {"\x76\x2f\x31\x01", "EXR"},
                                        {"#?", "HDR"}}) {
        const Error error = error_of([&] { decode_image(bytes_of(content), context); });
        EXPECT_EQ(error.code(), ErrorCode::bad_file);
        EXPECT_NE(error.reason().find(word), std::string::npos) << error.what();
    }
}

TEST(DecodeImage, GoesByContentAndNotByName) {
    const TemporaryFolder folder;
    const Pixels pixels = noise_picture(3, 3, 3, Component::u8);
    write_image(folder.file("a.png"), pixels);
    std::filesystem::rename(folder.file("a.png"), folder.file("a.jpg"));
    const ImageHandle image = image_from_file("a", "m.gltf", folder.file("a.jpg"));
    Context context;
    EXPECT_EQ(image->decode(*image, context).bytes, pixels.bytes);
}

TEST(EncodedImages, NameTheirFileAndPlaceInErrors) {
    Context context;
    const ImageHandle absent = image_from_file("a", "m.gltf", "absent.png");
    const Error not_found = error_of([&] { absent->decode(*absent, context); });
    EXPECT_EQ(not_found.code(), ErrorCode::not_found);
    EXPECT_EQ(not_found.file(), "absent.png");
    const auto text = std::make_shared<const std::vector<std::byte>>(bytes_of("hello"));
    const ImageHandle embedded = image_from_bytes("image 3", "m.glb", text, "image/png");
    const Error broken = error_of([&] { embedded->decode(*embedded, context); });
    EXPECT_EQ(broken.file(), "m.glb");
    EXPECT_EQ(broken.place(), "image 3");
    const ImageHandle nothing = image_from_bytes("image 4", "m.glb", nullptr, "");
    EXPECT_EQ(error_of([&] { nothing->decode(*nothing, context); }).code(), ErrorCode::bad_file);
}

TEST(EncodedImages, AreMeasuredAsTheyWillBeDecodedWithoutMemory) {
    const TemporaryFolder folder;
    for (const char* name : {"a.png", "a.jpg", "a.webp", "a.exr", "a.hdr"})
        for (const int channels : {1, 3}) {
            if (channels == 1 && std::string_view(name) == "a.hdr") continue;
            write_image(folder.file(name), noise_picture(37, 21, channels, component_for(name)));
            const ImageHandle image = image_from_file("a", "m.gltf", folder.file(name));
            Context context;
            const Pixels decoded = image->decode(*image, context);
            // What the EXR library takes beside the pixels is asked for with the header.
            const bool is_exr = std::string_view(name) == "a.exr";
            Context small({.max_memory = is_exr ? 1 << 20 : std::filesystem::file_size(folder.file(name))});
            const Pixels measured = image->measure(*image, small);
            EXPECT_TRUE(measured.bytes.empty()) << name;
            EXPECT_EQ(measured.width, decoded.width) << name;
            EXPECT_EQ(measured.height, decoded.height) << name;
            EXPECT_EQ(measured.channels, decoded.channels) << name;
            EXPECT_EQ(measured.component, decoded.component) << name;
            EXPECT_EQ(small.memory().charged(), 0u) << name;
            EXPECT_EQ(context.memory().charged(), decoded.bytes.size()) << name;
        }
    std::ofstream(folder.file("b.bmp")) << "BM";
    const ImageHandle broken = image_from_file("b", "m.gltf", folder.file("b.bmp"));
    Context context;
    EXPECT_EQ(error_of([&] { broken->measure(*broken, context); }).file(), folder.file("b.bmp"));
}

TEST(ImageWriting, EndingsSayTheComponentAndUnknownOnesAreAnErrorOfUsage) {
    EXPECT_EQ(component_for("a.PNG"), Component::u8);
    EXPECT_EQ(component_for("x/b.jpeg"), Component::u8);
    EXPECT_EQ(component_for("b.exr"), Component::f32);
    EXPECT_EQ(component_for("b.hdr"), Component::f32);
    for (const char* path : {"a", "a.", "a.gif", "png", "a.png/b", "", ".d/png"})
        EXPECT_EQ(error_of([&] { component_for(path); }).code(), ErrorCode::usage) << path;
}

TEST(ImageWriting, ImpossiblePicturesAreAnErrorOfUsageAndLeaveNothing) {
    const TemporaryFolder folder;
    const auto code = [&](const char* name, int width, int height, int channels, Component component) {
        return error_of([&] { make_image_writer(folder.file(name), width, height, channels, component); }).code();
    };
    EXPECT_EQ(code("a.png", 0, 1, 3, Component::u8), ErrorCode::usage);
    EXPECT_EQ(code("a.png", 1, 65537, 3, Component::u8), ErrorCode::usage);
    EXPECT_EQ(code("a.png", 1, 1, 5, Component::u8), ErrorCode::usage);
    EXPECT_EQ(code("a.png", 1, 1, 3, Component::f32), ErrorCode::usage);
    EXPECT_EQ(code("a.exr", 1, 1, 3, Component::u8), ErrorCode::usage);
    EXPECT_EQ(code("a.webp", 16384, 1, 3, Component::u8), ErrorCode::usage);
    EXPECT_EQ(code("a.jpg", 65536, 1, 3, Component::u8), ErrorCode::usage);
    EXPECT_TRUE(folder.is_empty());
}

class EveryEnding : public testing::TestWithParam<const char*> {};

TEST_P(EveryEnding, AFullDiskIsAnErrorAndAnUnfinishedPictureLeavesNothing) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    const TemporaryFolder folder;
    const std::string name = std::string("a.") + GetParam();
    const Pixels pixels = noise_picture(300, 300, 3, component_for(name));
    {
        const auto writer = make_image_writer(folder.file(name), 300, 300, 3, pixels.component);
        for (int y = 0; y < 299; ++y) writer->write_row(pixels.row(y));
        EXPECT_EQ(error_of([&] { writer->finish(); }).code(), ErrorCode::failed);
    }
    EXPECT_TRUE(folder.is_empty());
    std::filesystem::create_symlink("/dev/full", folder.file(name));
    EXPECT_EQ(error_of([&] { write_image(folder.file(name), pixels); }).code(), ErrorCode::failed);
}

INSTANTIATE_TEST_SUITE_P(All, EveryEnding, testing::Values("png", "jpg", "webp", "exr", "hdr"));

}  // namespace
}  // namespace rakelight::io
