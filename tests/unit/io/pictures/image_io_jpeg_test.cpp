// SPDX-License-Identifier: Apache-2.0
// JPEG files that our own writer does not make: inks, and several scans.
#include <gtest/gtest.h>

#include <string_view>

#include "io/pictures/image_formats.h"
#include "io/pictures/image_io.h"
#include "unit/io/pictures/image_io_support.h"

namespace rakelight::io {
namespace {

using test::error_of;

// 8 x 8 pixels of RGB 200, 100, 50 as CMYK with an Adobe marker, and a gray ramp in several scans; made with ImageMagick 6.
constexpr const char* adobe_cmyk =
    "ffd8ffee000e41646f626500640000000002ffdb0043000302020302020303030304030304050805050404050a070706080c0a0c0c0b0a0b0b"
    "0d"
    "0e12100d0e110e0b0b1016101113141515150c0f171816141812141514ffdb00430103040405040509050509140d0b0d141414141414141414"
    "14"
    "14141414141414141414141414141414141414141414141414141414141414141414141414141414ffc0001408000800080401110002110103"
    "11"
    "01041100ffc4001500010100000000000000000000000000000708ffc40014100100000000000000000000000000000000ffc4001401010000"
    "00"
    "00000000000000000000000008ffc40014110100000000000000000000000000000000ffda000e040100021103110400003f002c23447580ff"
    "d9";
constexpr const char* progressive =
    "ffd8ffe000104a46494600010100000100010000ffdb0043000d090a0b0a080d0b0a0b0e0e0d0f13201513121213271c1e17202e2931302e29"
    "2d"
    "2c333a4a3e333646372c2d405741464c4e525352323e5a615a50604a51524fffc2000b080008000801011100ffc40014000100000000000000"
    "00"
    "0000000000000000ffda00080101000000017fffc4001510010100000000000000000000000000000015ffda0008010100010502a0ffc40015"
    "10"
    "010100000000000000000000000000000031ffda0008010100063f02afffc40014100100000000000000000000000000000000ffda00080101"
    "00"
    "013f217fffda00080101000000107fffc4001610000300000000000000000000000000000011f0ffda0008010100013f10867fffd9";

std::vector<std::byte> bytes_of_hex(std::string_view hex) {
    const auto digit = [](char c) { return c <= '9' ? c - '0' : c - 'a' + 10; };
    std::vector<std::byte> bytes;
    for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
        bytes.push_back(std::byte(digit(hex[i]) * 16 + digit(hex[i + 1])));
    return bytes;
}

std::size_t find_marker(const std::vector<std::byte>& bytes, int code) {
    for (std::size_t i = 0; i + 1 < bytes.size(); ++i)
        if (bytes[i] == std::byte(0xff) && bytes[i + 1] == std::byte(code)) return i;
    ADD_FAILURE() << "no such marker";
    return 0;
}

TEST(JpegReading, InksBecomeRgbAndAdobeWritesThemInverted) {
    auto bytes = bytes_of_hex(adobe_cmyk);
    Context context;
    const Pixels pixels = decode_image(bytes, context);
    ASSERT_EQ(pixels.channels, 3);
    ASSERT_EQ(pixels.bytes.size(), 192u);
    const int expected[] = {200, 100, 50};
    for (std::size_t i = 0; i < 192; ++i) EXPECT_NEAR(int(pixels.bytes[i]), expected[i % 3], 2);

    // The same numbers without the marker are inks as they stand, and black ink of 200 leaves at most 55 of 255.
    const std::size_t at = find_marker(bytes, 0xee);
    const std::size_t size = 2 + std::size_t(bytes[at + 2]) * 256 + std::size_t(bytes[at + 3]);
    bytes.erase(bytes.begin() + std::ptrdiff_t(at), bytes.begin() + std::ptrdiff_t(at + size));
    for (const std::byte b : decode_image(bytes, context).bytes) EXPECT_LT(int(b), 60);
}

TEST(JpegReading, SeveralScansAreReadButNotAnyNumberOfThem) {
    auto bytes = bytes_of_hex(progressive);
    Context context;
    const Pixels pixels = decode_image(bytes, context);
    EXPECT_EQ(pixels.channels, 1);
    EXPECT_GT(int(pixels.bytes[0]), 200);
    EXPECT_LT(int(pixels.bytes[63]), 50);
    const std::size_t scan = find_marker(bytes, 0xda), next = [&] {
        std::size_t i = scan + 10;
        while (bytes[i] != std::byte(0xff) || bytes[i + 1] == std::byte(0)) ++i;
        return i;
    }();
    const std::vector<std::byte> first(bytes.begin() + std::ptrdiff_t(scan), bytes.begin() + std::ptrdiff_t(next));
    for (int i = 0; i < 200; ++i) bytes.insert(bytes.end() - 2, first.begin(), first.end());
    EXPECT_NE(error_of([&] { decode_image(bytes, context); }).reason().find("more than 100 scans"), std::string::npos);
}

TEST(JpegReading, AProgressiveFileIsDecodedByItsSeveralScans) {
    Context context;
    const codec::ReadableFormat& jpeg = codec::readable_jpeg;
    const auto work_at_half_size = [&](const std::vector<std::byte>& bytes) {
        return jpeg.work(jpeg.read(bytes, codec::Want::header, context), bytes, 2, context);
    };
    EXPECT_EQ(work_at_half_size(bytes_of_hex(progressive)), 8 * 8) << "all coefficients come before the first pixel";
    EXPECT_EQ(work_at_half_size(bytes_of_hex(adobe_cmyk)), 8 * 8 / 4);
    EXPECT_EQ(error_of([&] { jpeg.work({}, std::vector<std::byte>(4), 2, context); }).code(), ErrorCode::bad_file);
}

}  // namespace
}  // namespace rakelight::io
