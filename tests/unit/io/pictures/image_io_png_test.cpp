// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "io/pictures/image_io.h"
#include "support/shared.h"
#include "unit/io/pictures/image_io_support.h"

namespace rakelight::io {
namespace {

using test::bytes_of_file;
using test::error_of;
using test::noise_picture;
using test::TemporaryFolder;

/// FNV-1a 64 of the samples, 16-bit ones with the high byte first, as tests/support/png_reference.py makes it.
std::string code_of(const Pixels& pixels) {
    std::uint64_t code = 0xcbf29ce484222325;
    const auto take = [&](std::byte b) { code = (code ^ std::uint64_t(b)) * 0x100000001b3; };
    for (std::size_t i = 0; i < pixels.bytes.size(); ++i)
        take(pixels.bytes[pixels.component == Component::u16 ? i ^ 1 : i]);
    char text[17];
    std::snprintf(text, sizeof(text), "%016llx", static_cast<unsigned long long>(code));
    return text;
}

TEST(PngReading, EveryFileOfPngSuiteGivesThePixelsOfAnIndependentDecoder) {
    RL_NEEDS_SHARED("assets");
    std::ifstream table(test::source_dir() / "tests/unit/io/pictures/pngsuite_expected.txt");
    ASSERT_TRUE(table);
    std::string line;
    int count = 0;
    while (std::getline(table, line)) {
        std::istringstream fields(line);
        std::string name, code;
        int width = 0, height = 0, channels = 0, bits = 0;
        fields >> name >> width >> height >> channels >> bits >> code;
        SCOPED_TRACE(name);
        Context context;
        const Pixels pixels =
            decode_image(bytes_of_file(test::shared_dir() / "assets/textures/pngsuite" / name), context);
        EXPECT_EQ(pixels.width, width);
        EXPECT_EQ(pixels.height, height);
        EXPECT_EQ(pixels.channels, channels);
        EXPECT_EQ(pixels.component, bits == 16 ? Component::u16 : Component::u8);
        EXPECT_FALSE(pixels.is_linear);
        EXPECT_EQ(code_of(pixels), code);
        ++count;
    }
    EXPECT_GT(count, 80);
}

TEST(PngReading, AGammaOf45455CountsAsTheTagOfSrgb) {
    RL_NEEDS_SHARED("assets");
    std::vector<std::byte> bytes = bytes_of_file(test::shared_dir() / "assets/textures/pngsuite/basn2c08.png");
    Context context;
    EXPECT_FALSE(decode_image(bytes, context).is_tagged_srgb) << "its gAMA is 100000: linear";
    ASSERT_EQ(bytes[37], std::byte('g'));
    const int value[] = {0x00, 0x00, 0xB1, 0x8F};  // 45455
    for (std::size_t i = 0; i < 4; ++i) bytes[41 + i] = std::byte(value[i]);
    test::mend_png_checksum(bytes, 33);
    EXPECT_TRUE(decode_image(bytes, context).is_tagged_srgb);
}

TEST(PngReading, EveryCorruptFileOfPngSuiteIsRefusedInOneLine) {
    RL_NEEDS_SHARED("hostile/pngsuite");
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(test::shared_dir() / "hostile/pngsuite")) {
        if (entry.path().extension() != ".png") continue;
        Context context;
        const Error error = error_of([&] { decode_image(bytes_of_file(entry.path()), context); });
        EXPECT_EQ(error.code(), ErrorCode::bad_file) << entry.path();
        ++count;
    }
    EXPECT_GT(count, 5);
}

TEST(PngReading, CutCrippledAndHugeFilesAreRefused) {
    RL_NEEDS_SHARED("hostile/gltf/tex");
    for (const char* name : {"not_an_image.png", "png_65535_header.png", "png_crc.png", "png_cut.png"}) {
        Context context;
        const Error error =
            error_of([&] { decode_image(bytes_of_file(test::shared_dir() / "hostile/gltf/tex" / name), context); });
        EXPECT_EQ(error.code(), ErrorCode::bad_file) << name;
    }
}

class PngRoundTrip : public testing::TestWithParam<std::tuple<int, Component>> {};

TEST_P(PngRoundTrip, GivesTheSamePixelsBack) {
    const auto [channels, component] = GetParam();
    const TemporaryFolder folder;
    for (const auto& [width, height] : {std::pair{1, 1}, {7, 5}, {300, 3}, {3, 200}}) {
        const Pixels pixels = noise_picture(width, height, channels, component);
        write_image(folder.file("a.png"), pixels);
        Context context;
        const Pixels back = decode_image(bytes_of_file(folder.file("a.png")), context);
        EXPECT_EQ(back.width, width);
        EXPECT_EQ(back.height, height);
        EXPECT_EQ(back.channels, channels);
        EXPECT_EQ(back.component, component);
        EXPECT_EQ(back.bytes, pixels.bytes);
    }
}

INSTANTIATE_TEST_SUITE_P(All, PngRoundTrip,
                         testing::Combine(testing::Values(1, 2, 3, 4), testing::Values(Component::u8, Component::u16)));

TEST(PngWriting, NothingAppearsBeforeFinishAndAnUnfinishedPictureLeavesNothing) {
    const TemporaryFolder folder;
    const Pixels pixels = noise_picture(4, 4, 3, Component::u8);
    {
        const auto writer = make_image_writer(folder.file("a.png"), 4, 4, 3, Component::u8);
        for (int y = 0; y < 3; ++y) writer->write_row(pixels.row(y));
        EXPECT_FALSE(std::filesystem::exists(folder.file("a.png")));
        EXPECT_EQ(error_of([&] { writer->finish(); }).code(), ErrorCode::failed);
    }
    EXPECT_TRUE(folder.is_empty());
}

TEST(PngWriting, AFullDiskIsAnError) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    const TemporaryFolder folder;
    std::filesystem::create_symlink("/dev/full", folder.file("a.png"));
    EXPECT_EQ(error_of([&] { write_image(folder.file("a.png"), noise_picture(400, 400, 4, Component::u8)); }).code(),
              ErrorCode::failed);
}

TEST(PngReading, EveryTruncationIsRefusedOrWhole) {
    const TemporaryFolder folder;
    const Pixels pixels = noise_picture(16, 16, 3, Component::u8);
    write_image(folder.file("a.png"), pixels);
    const auto bytes = bytes_of_file(folder.file("a.png"));
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        Context context;
        try {
            const Pixels back = decode_image(std::span(bytes).first(size), context);
            EXPECT_EQ(back.bytes, pixels.bytes) << size;
            EXPECT_GT(size, bytes.size() - 20);  // only the end mark and a checksum may be missing
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::bad_file);
        }
    }
}

TEST(PngReading, ASmallFileThatClaimsToBeHugeIsRefusedBeforeMemoryIsAskedFor) {
    const TemporaryFolder folder;
    write_image(folder.file("a.png"), noise_picture(4, 4, 1, Component::u8));
    auto bytes = bytes_of_file(folder.file("a.png"));
    const std::byte header[] = {std::byte(0), std::byte(0), std::byte(0x40), std::byte(0),
                                std::byte(0), std::byte(0), std::byte(0x40), std::byte(0)};
    std::copy(std::begin(header), std::end(header), bytes.begin() + 16);
    test::mend_png_checksum(bytes, 8);
    Context context;
    const Error error = error_of([&] { decode_image(bytes, context); });
    EXPECT_NE(error.reason().find("too short"), std::string::npos) << error.what();
}

TEST(PngReading, APictureLargerThanTheMemoryLimitIsRefused) {
    const TemporaryFolder folder;
    write_image(folder.file("a.png"), noise_picture(100, 100, 3, Component::u8));
    Context small({.max_memory = 29999}), enough({.max_memory = 30000});
    const auto bytes = bytes_of_file(folder.file("a.png"));
    EXPECT_EQ(error_of([&] { decode_image(bytes, small); }).code(), ErrorCode::bad_file);
    EXPECT_EQ(decode_image(bytes, enough).bytes.size(), 30000u);
}

}  // namespace
}  // namespace rakelight::io
