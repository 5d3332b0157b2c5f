// SPDX-License-Identifier: Apache-2.0
// Windows put together: which window gives which columns, and what is refused.
#include <gtest/gtest.h>
#include <rakelight_internal/tools/join_windows.h>

#include "io/pictures/image_io.h"
#include "support/thrown_error.h"
#include "tools/window_bands.h"
#include "unit/io/pictures/image_io_support.h"

namespace rakelight {
namespace {

using test::bytes_of_file;
using test::error_of;
using test::noise_picture;
using test::TemporaryFolder;

constexpr int width = 61, height = 47;

std::vector<std::vector<int>> pieces_of(const Band& band) {
    std::vector<std::vector<int>> list;
    for (const BandPiece& p : band.pieces) list.push_back({int(p.window), p.begin, p.own, p.end});
    return list;
}

TEST(WindowBands, HaveTheWindowsThatMeetTheirRowsFromLeftToRight) {
    const std::vector<Window> windows{{4, 0, 6, 3}, {0, 0, 6, 8}, {6, 3, 4, 5}, {6, 2, 4, 2}};
    const Band first = band_at(windows, 0, 10, 8), second = band_at(windows, first.end, 10, 8);
    EXPECT_EQ(first.end, 2);
    EXPECT_EQ(pieces_of(first), (std::vector<std::vector<int>>{{1, 0, 0, 6}, {0, 4, 6, 10}}));
    EXPECT_EQ(second.end, 3);
    EXPECT_EQ(pieces_of(second), (std::vector<std::vector<int>>{{1, 0, 0, 6}, {0, 4, 6, 10}, {3, 6, 10, 10}}));
    EXPECT_EQ(band_at(windows, 3, 10, 8).end, 4);
    EXPECT_EQ(band_at(windows, 4, 10, 8).end, 8);
}

TEST(WindowBands, AGapIsAnErrorThatNamesItsWindow) {
    const auto advice = [](std::vector<Window> windows) {
        return error_of([&] { band_at(windows, 0, 10, 8); }).advice();
    };
    EXPECT_EQ(advice({{1, 0, 9, 8}}), "render them with 'window' 0,0,1,8");
    EXPECT_EQ(advice({{0, 0, 4, 8}, {6, 0, 4, 8}}), "render them with 'window' 4,0,2,8");
    EXPECT_EQ(advice({{0, 0, 4, 8}, {4, 5, 6, 3}}), "render them with 'window' 4,0,6,5");
    EXPECT_EQ(advice({}), "render them with 'window' 0,0,10,8");
}

class JoinWindows : public testing::Test {
protected:
    const TemporaryFolder folder;
    Context context;

    /// A part of a picture in a file that knows its place.
    std::string cut(const Pixels& whole, const Window& w, const std::string& name, bool says = true) {
        Pixels part = whole;
        part.width = w.width, part.height = w.height;
        const std::size_t pixel = part.row_bytes() / std::size_t(w.width);
        part.bytes.resize(part.row_bytes() * std::size_t(w.height));
        for (int y = 0; y < w.height; ++y)
            std::memcpy(part.row(y), whole.row(w.y + y) + std::size_t(w.x) * pixel, part.row_bytes());
        io::OutputTarget target(folder.file(name));
        if (says) target.place = {w.x, w.y, whole.width, whole.height};
        io::write_image(target, part);
        return folder.file(name);
    }

    JoinResult join(const std::vector<WindowPart>& parts, const std::string& output) {
        return join_windows({parts, folder.file(output)}, context);
    }
};

class JoinedFormats : public JoinWindows,
                      public testing::WithParamInterface<std::tuple<const char*, int, Component>> {};

TEST_P(JoinedFormats, HaveTheBytesOfTheWhole) {
    const auto [ending, channels, component] = GetParam();
    const Pixels whole = noise_picture(width, height, channels, component);
    const std::string dot = std::string(".") + ending;
    io::write_image(folder.file("whole" + dot), whole);
    const std::vector<WindowPart> parts{{cut(whole, {20, 0, 41, 30}, "a" + dot)},
                                        {cut(whole, {0, 10, 25, 37}, "b" + dot)},  // overlaps the first
                                        {cut(whole, {25, 30, 36, 17}, "c" + dot)},
                                        {cut(whole, {0, 0, 20, 10}, "d" + dot)}};
    const JoinResult result = join(parts, "joined" + dot);
    EXPECT_EQ(result.width, width);
    EXPECT_EQ(result.height, height);
    EXPECT_EQ(result.parts, 4u);
    EXPECT_EQ(bytes_of_file(folder.file("joined" + dot)), bytes_of_file(folder.file("whole" + dot)));
    EXPECT_EQ(context.memory().charged(), 0u);
}

INSTANTIATE_TEST_SUITE_P(All, JoinedFormats,
                         testing::Values(std::tuple("png", 1, Component::u8), std::tuple("png", 3, Component::u8),
                                         std::tuple("png", 4, Component::u8), std::tuple("png", 3, Component::u16),
                                         std::tuple("png", 4, Component::u16), std::tuple("exr", 3, Component::f32),
                                         std::tuple("exr", 4, Component::f32), std::tuple("hdr", 3, Component::f32)));

TEST_F(JoinWindows, PlacesMayBeNamedWithTheSizeOfTheWhole) {
    const Pixels whole = noise_picture(width, height, 3, Component::u8);
    io::write_image(folder.file("whole.png"), whole);
    const std::string left = cut(whole, {0, 0, 30, height}, "left.png", false),
                      right = cut(whole, {30, 0, 31, height}, "right.png", false);
    EXPECT_EQ(error_of([&] { join({{left}, {right}}, "out.png"); }).code(), ErrorCode::usage);
    EXPECT_EQ(error_of([&] { join({{left, 0, 0}, {right, 30, 0}}, "out.png"); }).setting(), "resolution");
    EXPECT_FALSE(std::filesystem::exists(folder.file("out.png")));
    join_windows({{{left, 0, 0}, {right, 30, 0}}, folder.file("out.png"), width, height}, context);
    EXPECT_EQ(bytes_of_file(folder.file("out.png")), bytes_of_file(folder.file("whole.png")));
}

TEST_F(JoinWindows, WhatMakesNoPictureIsOneErrorAndNoFile) {
    Pixels whole = noise_picture(width, height, 3, Component::u8);
    const std::string left = cut(whole, {0, 0, 40, height}, "left.png"),
                      right = cut(whole, {40, 0, 21, height}, "right.png");
    const std::string deep = cut(noise_picture(width, height, 3, Component::u16), {40, 0, 21, height}, "deep.png");
    const std::string foreign = cut(noise_picture(width, 50, 3, Component::u8), {40, 0, 21, height}, "foreign.png");
    const std::string other = cut(noise_picture(width, height, 3, Component::f32), {40, 0, 21, height}, "other.exr");
    whole.row(20)[3 * 35] ^= std::byte(1);
    const std::string differs = cut(whole, {30, 0, 31, height}, "differs.png");
    const auto refused = [&](std::vector<WindowPart> parts, const char* words, ErrorCode code = ErrorCode::bad_file) {
        const Error error = error_of([&] { join(parts, "out.png"); });
        EXPECT_EQ(error.code(), code) << error.what();
        EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
        EXPECT_FALSE(std::filesystem::exists(folder.file("out.png")));
    };
    refused({}, "no window", ErrorCode::usage);
    refused({{left}}, "no window covers columns 40 to 60 of rows 0 to 46; render them with 'window' 40,0,21,47");
    refused({{left}, {foreign}}, "is a window of a picture of 61 x 50 pixels, not of 61 x 47");
    refused({{left}, {deep}}, "is PNG of 3 channels with 16 bits");
    refused({{left}, {other}}, "is EXR of B,G,R");
    refused({{left}, {differs}}, "differs from '");
    refused({{differs}, {left}}, "at pixel 35,20");
    refused({{left}, {right, 41, 0}}, "extends beyond the picture");
    refused({{left}, {right}, {folder.file("missing.png")}}, "missing.png", ErrorCode::not_found);
    EXPECT_EQ(error_of([&] { join({{left}, {right}}, "out.exr"); }).code(), ErrorCode::usage);
    std::filesystem::resize_file(right, std::filesystem::file_size(right) / 2);
    refused({{left}, {right}}, "right.png");
    std::vector<std::string> rest;
    for (const auto& entry : std::filesystem::directory_iterator(folder.file("")))
        if (entry.path().filename().string().ends_with(".tmp")) rest.push_back(entry.path());
    EXPECT_TRUE(rest.empty());
}

TEST_F(JoinWindows, MemoryIsOfARowAndCancellingLeavesNothing) {
    const Pixels whole = noise_picture(width, 2000, 3, Component::u8);
    const std::string upper = cut(whole, {0, 0, width, 900}, "upper.png"),
                      lower = cut(whole, {0, 900, width, 1100}, "lower.png");
    Context small({.max_memory = 4096});  // a row has 183 bytes, the picture 366000
    join_windows({{{upper}, {lower}}, folder.file("out.png")}, small);
    Context tiny({.max_memory = 500});
    EXPECT_EQ(error_of([&] {
                  join_windows({{{upper}, {lower}}, folder.file("no.png")}, tiny);
              }).code(),
              ErrorCode::bad_file);
    Context cancelled({.progress = [&](std::string_view, double share) {
        if (share > 0.5) cancelled.cancel();
    }});
    EXPECT_EQ(error_of([&] {
                  join_windows({{{upper}, {lower}}, folder.file("no.png")}, cancelled);
              }).code(),
              ErrorCode::failed);
    EXPECT_FALSE(std::filesystem::exists(folder.file("no.png")));
}

}  // namespace
}  // namespace rakelight
