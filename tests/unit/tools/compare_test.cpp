// SPDX-License-Identifier: Apache-2.0
// Two pictures and their numbers: what is held against what, limits, rows, difference pictures.
#include <rakelight/tools/compare.h>

#include <gtest/gtest.h>

#include <rakelight/render/picture.h>
#include <rakelight/tools/rows.h>
#include <rakelight_internal/tools/compare_page.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "image/false_color.h"
#include "io/pictures/image_io.h"
#include "support/temporary_folder.h"
#include "support/thrown_error.h"
#include "unit/image/image_support.h"

namespace rakelight {
namespace {

using test::error_of;
using test::picture_of;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

class Compare : public testing::Test {
protected:
    PictureComparison compare(const Pixels& a, const Pixels& b, const CompareOptions& options = {}) {
        return ComparedPictures(a, b, options, context_).comparison();
    }
    static Pixels gray(int code, int channels = 3, int width = 16, int height = 12) {
        return picture_of<std::uint8_t>(width, height, channels, [&](int, int, int) { return code; });
    }
    static Pixels light(float value, int channels = 3) {
        return picture_of<float>(16, 12, channels, [&](int, int, int) { return value; });
    }

    Context context_{{.threads = 1}};
};

TEST_F(Compare, EqualPicturesDifferInNothing) {
    const Pixels a = picture_of<std::uint8_t>(20, 15, 4, test::noise);
    const PictureComparison c = compare(a, a);
    EXPECT_TRUE(c.is_equal());
    EXPECT_EQ(c.width, 20);
    EXPECT_EQ(c.height, 15);
    EXPECT_EQ(c.rmse, 0);
    EXPECT_EQ(c.psnr_db, std::numeric_limits<double>::infinity());
    EXPECT_EQ(c.ssim, 1.0);
    EXPECT_EQ(c.flip, 0);
    EXPECT_EQ(c.differing_pixels, 0u);
}

TEST_F(Compare, APixelCountsOnceHoweverManyOfItsComponentsDiffer) {
    const Pixels a = gray(100);
    const Pixels b = picture_of<std::uint8_t>(16, 12, 3, [](int x, int y, int c) {
        return x == 3 && y < 2 ? 103 : x == 5 && y == 0 && c == 1 ? 101 : 100;
    });
    EXPECT_EQ(compare(a, b).differing_pixels, 3u);
    EXPECT_EQ(compare(a, b).differing_share, 3 / 192.0);
    EXPECT_EQ(compare(a, b, {.tolerance = 1 / 255.0}).differing_pixels, 2u);
    EXPECT_EQ(compare(a, b, {.tolerance = 3 / 255.0}).differing_pixels, 0u);
}

TEST_F(Compare, GrayAndRgbAndOpaqueAlphaAreTheSame) {
    for (const int channels : {1, 2, 3, 4}) {
        const Pixels other = picture_of<std::uint8_t>(
            16, 12, channels, [&](int, int, int c) { return (channels == 2 && c == 1) || c == 3 ? 255 : 77; });
        EXPECT_TRUE(compare(gray(77), other).is_equal()) << channels;
        EXPECT_TRUE(compare(other, gray(77, 1)).is_equal()) << channels;
    }
    const Pixels wide = picture_of<std::uint16_t>(16, 12, 4, [](int, int, int c) { return c == 3 ? 65535 : 77 * 257; });
    EXPECT_TRUE(compare(wide, gray(77)).is_equal());
}

TEST_F(Compare, AlphaCountsInTheErrorAndShowsMiddleGrayInFlip) {
    const Pixels clear = picture_of<std::uint8_t>(16, 12, 4, [](int, int, int c) { return c == 3 ? 0 : 128; });
    const PictureComparison c = compare(clear, gray(128));
    EXPECT_EQ(c.max_error, 1);
    EXPECT_NEAR(c.rmse, 0.5, 1e-12);  // one component of four
    EXPECT_EQ(c.flip, 0);
    EXPECT_EQ(c.ssim, 1.0);
}

TEST_F(Compare, CodesAreDecodedToBeHeldAgainstLinearLight) {
    const PictureComparison c = compare(gray(128), light(0.21586050f));
    EXPECT_LT(c.max_error, 1e-6);
    EXPECT_EQ(c.flip, 0);
    EXPECT_NEAR(compare(light(0.5f), gray(255)).max_error, 0.5, 1e-6);
}

TEST_F(Compare, LightBeyondTheDisplayCountsInTheErrorAlone) {
    const PictureComparison c = compare(light(1), light(3));
    EXPECT_EQ(c.max_error, 2);
    EXPECT_NEAR(c.psnr_db, -6.0206, 1e-4);
    EXPECT_EQ(c.flip, 0);
}

TEST_F(Compare, PicturesOfDifferentSizeAreRefused) {
    EXPECT_EQ(error_of([&] { compare(gray(1), gray(1, 3, 15, 12)); }).code(), ErrorCode::check_failed);
    const Error error = error_of([&] { compare(gray(1), gray(1, 3, 16, 13)); });
    EXPECT_EQ(error.code(), ErrorCode::check_failed);
    EXPECT_EQ(error.reason(), "the pictures differ in size: 16 x 12 and 16 x 13 pixels");
}

TEST_F(Compare, ImpossibleOptionsAreRefused) {
    for (const CompareOptions& options : {CompareOptions{.tolerance = -1},
                                          {.tolerance = NAN},
                                          {.pixels_per_degree = 0.9},
                                          {.pixels_per_degree = 1001},
                                          {.pixels_per_degree = NAN}})
        EXPECT_EQ(error_of([&] { compare(gray(1), gray(2), options); }).code(), ErrorCode::usage);
}

TEST_F(Compare, WhatItKeepsIsChargedAndGivenBack) {
    const Pixels a = gray(1), b = gray(2, 4);
    {
        const ComparedPictures pictures(a, b, {}, context_);
        EXPECT_EQ(context_.memory().charged(), 16u * 12 * (4 + 4 + 4 + 4));  // as displayed, the map, the one made RGBA
    }
    EXPECT_EQ(context_.memory().charged(), 0u);
    Context small({.threads = 1, .max_memory = 2000});
    EXPECT_EQ(error_of([&] { ComparedPictures(a, b, {}, small); }).code(), ErrorCode::bad_file);
}

TEST_F(Compare, EveryLimitIsHeldByItsOwnNumber) {
    const PictureComparison c{
        .max_error = 0.5, .rmse = 0.1, .psnr_db = 20, .ssim = 0.9, .flip = 0.2, .differing_share = 0.25};
    EXPECT_TRUE(check_limits(c, {}).empty());
    EXPECT_TRUE(check_limits(c, {0.5, 0.1, 20, 0.9, 0.2, 0.25}).empty());
    const auto failures = check_limits(c, {0.49, 0.09, 20.5, 0.95, 0.19, 0.24});
    const char* const expected[] = {
        "max-error: 0.5, more than 0.49",  "max-rmse: 0.1, more than 0.09",
        "min-psnr: 20 dB, less than 20.5", "min-ssim: 0.9, less than 0.95",
        "max-flip: 0.2, more than 0.19",   "max-differing: 0.25 of the pixels, more than 0.24"};
    ASSERT_EQ(failures.size(), std::size(expected));
    for (std::size_t i = 0; i < failures.size(); ++i)
        EXPECT_EQ(failures[i].limit + ": " + failures[i].message, expected[i]);
}

TEST_F(Compare, LimitsHoldWithoutAnEndOrAnSsim) {
    const double inf = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(check_limits({.psnr_db = inf, .ssim = 1.0}, {.min_psnr_db = 99, .min_ssim = 1}).empty());
    EXPECT_EQ(check_limits({.max_error = inf, .rmse = inf, .psnr_db = -inf}, {1e9, 1e9, -1e9}).size(), 3u);
    const auto none = check_limits(compare(gray(1, 3, 10, 40), gray(1, 3, 10, 40)), {.min_ssim = 0});
    ASSERT_EQ(none.size(), 1u);
    EXPECT_EQ(none[0].limit, "min-ssim");
}

TEST_F(Compare, RowsWithoutEndAreNullInJson) {
    ComparisonRow equal{.a = "a.png", .b = "b.png"};
    equal.comparison = compare(gray(1), gray(1));
    ComparisonRow broken{.a = "a.exr", .b = "c.exr", .engine_a = "soft", .engine_b = "other"};
    broken.comparison = compare(light(0), light(nan));
    broken.failures = {{"max-error", "inf, more than 1"}};
    ComparisonRow missing{.a = "x", .b = "y"};
    missing.error = Error(ErrorCode::not_found, "cannot be opened");
    const ComparisonRow rows[] = {equal, broken, missing};
    const nlohmann::json json = nlohmann::json::parse(to_json(rows));
    EXPECT_EQ(json["schema"], "rakelight.compare/1");
    const auto& first = json["rows"][0];
    EXPECT_EQ(first["equal"], true);
    EXPECT_TRUE(first["psnr_db"].is_null());
    EXPECT_EQ(first["max_error"], 0);
    EXPECT_EQ(first["ssim"], 1);
    EXPECT_EQ(first["pixels_per_degree"], 67);
    EXPECT_EQ(first["check"]["passed"], true);
    const auto& second = json["rows"][1];
    EXPECT_EQ(second["equal"], false);
    for (const char* key : {"max_error", "rmse", "psnr_db"}) EXPECT_TRUE(second.at(key).is_null()) << key;
    EXPECT_EQ(second["differing_pixels"], 192);
    EXPECT_EQ(second["engine_b"], "other");
    EXPECT_EQ(second["check"]["failures"][0]["limit"], "max-error");
    EXPECT_EQ(json["rows"][2]["error"]["code"], "not_found");
    EXPECT_FALSE(json["rows"][2].contains("rmse"));
}

TEST_F(Compare, TableHasARowForEachPairThatWasCompared) {
    ComparisonRow row{.a = "a\x1b.png", .b = "b.png", .engine_b = "gl"};
    row.comparison = compare(gray(0, 3, 5, 5), gray(51, 3, 5, 5));
    ComparisonRow missing{.a = "x", .b = "y"};
    missing.error = Error(ErrorCode::not_found, "cannot be opened");
    const std::string text = to_text(std::vector{row, missing});
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2);
    EXPECT_NE(text.find("a?.png  b.png (gl)        0.2   0.2    13.9794     -  "), std::string::npos) << text;
    EXPECT_NE(text.find("     100 %\n"), std::string::npos) << text;
    EXPECT_EQ(to_text(std::vector{missing}), "");
}

TEST_F(Compare, AbsoluteDifferencesAreTimesTheGain) {
    const Pixels b = picture_of<std::uint8_t>(16, 12, 3, [](int x, int, int c) { return x == 2 && c == 1 ? 97 : 100; });
    const ComparedPictures pictures(gray(100), b, {}, context_);
    const Pixels shown = pictures.difference(DifferenceKind::absolute, 20);
    EXPECT_EQ(shown.channels, 3);
    EXPECT_EQ(int(shown.row(0)[3 * 2 + 1]), 60);
    EXPECT_EQ(int(shown.row(0)[3 * 2]), 0);
    EXPECT_EQ(int(pictures.difference(DifferenceKind::absolute, 100).row(0)[3 * 2 + 1]), 255);
    for (const double gain : {0.0, -1.0, double(nan)})
        EXPECT_EQ(error_of([&] { (void)pictures.difference(DifferenceKind::absolute, gain); }).code(),
                  ErrorCode::usage);
}

TEST_F(Compare, FlipIsShownAsHeat) {
    const Pixels black = gray(0), white = gray(255);
    const ComparedPictures pictures(black, white, {}, context_);
    const Pixels shown = pictures.difference(DifferenceKind::flip, 1);
    const Code expected = heat(pictures.comparison().flip);
    EXPECT_EQ(int(shown.row(3)[3 * 5]), expected.r);
    EXPECT_EQ(int(shown.row(3)[3 * 5 + 1]), expected.g);
    EXPECT_EQ(int(shown.row(3)[3 * 5 + 2]), expected.b);
    const Code none = heat(0);
    const Pixels equal = ComparedPictures(black, black, {}, context_).difference(DifferenceKind::flip, 1);
    EXPECT_EQ(int(equal.row(0)[2]), none.b);
}

TEST_F(Compare, FilesOfFloatsHoldTheNumbers) {
    const test::TemporaryFolder folder;
    const ComparedPictures pictures(light(0.25f), light(3), {}, context_);
    save_difference(pictures, DifferenceKind::absolute, 2, folder.file("d.exr"));
    const Pixels read = read_picture(folder.file("d.exr"), context_);
    float value = 0;
    std::memcpy(&value, read.row(4), sizeof value);
    EXPECT_EQ(value, 5.5f);
    save_difference(pictures, DifferenceKind::flip, 1, folder.file("f.exr"));
    const Pixels flip = read_picture(folder.file("f.exr"), context_);
    std::memcpy(&value, flip.row(4), sizeof value);
    EXPECT_NEAR(double(value), pictures.comparison().flip, 1e-6);
}

TEST_F(Compare, OutputsAreCheckedBeforeAnythingIsCompared) {
    const test::TemporaryFolder folder;
    EXPECT_NO_THROW(check_comparison_output(folder.file("d.png")));
    EXPECT_NO_THROW(check_comparison_output(folder.file("d.html")));
    EXPECT_EQ(error_of([&] { check_comparison_output(folder.file("d.gif")); }).code(), ErrorCode::usage);
    EXPECT_NO_THROW(check_comparison_output(folder.file("none/d.html")));  // folders are made when it is written
    EXPECT_FALSE(std::filesystem::exists(folder.file("none")));
    std::ofstream(folder.file("plain")) << "no folder";
    EXPECT_EQ(error_of([&] { check_comparison_output(folder.file("plain/d.html")); }).code(), ErrorCode::failed);
}

TEST_F(Compare, ScenesAreKnownByTheirNames) {
    for (const char* scene : {"a.glb", "A.OBJ", "room.scene.toml", "builtin:teapot"})
        EXPECT_TRUE(is_scene(scene)) << scene;
    for (const char* picture : {"a.png", "b/a.EXR", "a.jpeg"}) EXPECT_TRUE(has_picture_ending(picture)) << picture;
    for (const char* other : {"a.txt", "png", "a.png.bak", "a.glb"}) EXPECT_FALSE(has_picture_ending(other)) << other;
    for (const char* picture : {"a.png", "a.exr", "a", "glb", "builtin.png"})
        EXPECT_FALSE(is_scene(picture)) << picture;
}

TEST_F(Compare, APictureInMemoryIsThatOfTheFile) {
    const test::TemporaryFolder folder;
    PictureRequest request{.input = "builtin:teapot", .output = folder.file("a.png")};
    request.settings.width = 70, request.settings.height = 130;
    for (const float alpha : {1.0f, 0.0f}) {
        request.settings.background.w = alpha;
        request.tone.exposure_ev = alpha;
        const PictureResult in_file = render_picture(request, context_);
        PictureRequest other = request;
        other.output = "no/such/folder";
        other.settings.channels = channel_depth;
        Pixels pixels;
        const PictureResult in_memory = render_picture(other, pixels, context_);
        const Pixels read = read_picture(request.output, context_);
        EXPECT_EQ(pixels.channels, alpha < 1 ? 4 : 3);
        EXPECT_EQ(pixels.channels, read.channels);
        EXPECT_EQ(pixels.width, 70);
        EXPECT_EQ(pixels.height, 130);
        EXPECT_EQ(pixels.bytes, read.bytes);
        EXPECT_TRUE(pixels.charge);
        EXPECT_EQ(in_memory.engine, in_file.engine);
        EXPECT_EQ(in_memory.white_pixels, in_file.white_pixels);
        EXPECT_TRUE(in_memory.output.empty());
    }
    request.engine = "none";
    Pixels pixels;
    EXPECT_EQ(error_of([&] { render_picture(request, pixels, context_); }).code(), ErrorCode::usage);
}

}  // namespace
}  // namespace rakelight
