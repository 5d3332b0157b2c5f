// SPDX-License-Identifier: Apache-2.0
// Pictures read row by row: the numbers of the file, its place in a larger picture, and files that lie.
#include "io/pictures/image_rows.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>

#include "io/pictures/image_place.h"
#include "unit/io/pictures/image_io_support.h"

namespace rakelight::io {
namespace {

using test::bytes_of_file;
using test::error_of;
using test::noise_picture;
using test::TemporaryFolder;

constexpr int width = 37, height = 29;
constexpr ImagePlace somewhere{5, 7, 100, 90};

void write(const OutputTarget& target, const Pixels& pixels) { write_image(target, pixels); }

OutputTarget placed(std::string path, std::string comment = {}) {
    OutputTarget target(std::move(path));
    target.place = somewhere, target.comment = std::move(comment);
    return target;
}

std::vector<std::byte> all_rows(RowReader& reader) {
    const RowHeader& h = reader.header();
    const std::size_t row = std::size_t(h.width) * h.kind.pixel_bytes();
    std::vector<std::byte> bytes(row * std::size_t(h.height));
    for (int y = 0; y < h.height; ++y) reader.read_row(bytes.data() + std::size_t(y) * row);
    return bytes;
}

void put(const std::string& path, std::span<const std::byte> bytes) {
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
}

class PngRows : public testing::TestWithParam<std::tuple<int, Component>> {};

TEST_P(PngRows, AreThoseThatWereWritten) {
    const auto [channels, component] = GetParam();
    const TemporaryFolder folder;
    const Pixels pixels = noise_picture(width, height, channels, component);
    write(placed(folder.file("a.png"), "a comment"), pixels);
    Context context;
    const auto reader = read_rows(folder.file("a.png"), context);
    EXPECT_EQ(reader->header(),
              (RowHeader{{RowFormat::png, channels, component, {}, "a comment"}, width, height, somewhere}));
    EXPECT_EQ(all_rows(*reader), pixels.bytes);
}

INSTANTIATE_TEST_SUITE_P(All, PngRows,
                         testing::Combine(testing::Values(1, 2, 3, 4), testing::Values(Component::u8, Component::u16)));

TEST(HdrRows, AreWrittenBackWithTheSameBytes) {
    const TemporaryFolder folder;
    for (const int columns : {1, 7, 8, 300}) {  // plain below 8, run lengths from there
        const Pixels pixels = noise_picture(columns, height, 3, Component::f32);
        write(placed(folder.file("a.hdr"), "a comment"), pixels);
        Context context;
        const auto reader = read_rows(folder.file("a.hdr"), context);
        EXPECT_EQ(reader->header().place, somewhere);
        EXPECT_EQ(reader->header().kind.comment, "a comment");
        const std::vector<std::byte> bytes = all_rows(*reader);
        Pixels back = pixels;
        back.bytes = bytes;
        write(placed(folder.file("b.hdr"), "a comment"), back);
        EXPECT_EQ(bytes_of_file(folder.file("a.hdr")), bytes_of_file(folder.file("b.hdr"))) << columns;
    }
}

TEST(ExrRows, HaveEveryChannelWithItsTypeAndBits) {
    const TemporaryFolder folder;
    const std::vector<ExrChannel> channels{{"A", ExrType::f32}, {"R", ExrType::f16}, {"object.I", ExrType::u32}};
    const auto writer = make_exr_writer(placed(folder.file("a.exr"), "a comment"), width, height, channels);
    std::vector<std::uint32_t> all;
    for (int y = 0; y < height; ++y) {
        std::vector<std::uint32_t> row;
        for (int x = 0; x < width; ++x) {
            row.push_back(x == 3 ? 0x7fc01234u : std::bit_cast<std::uint32_t>(float(x * y) / 3));  // a NaN
            row.push_back(std::bit_cast<std::uint32_t>(x == 5 ? std::numeric_limits<float>::infinity() : float(x) / 8));
            row.push_back(0xffffffffu - std::uint32_t(x * y));
        }
        writer->write_row(row.data());
        all.insert(all.end(), row.begin(), row.end());
    }
    writer->finish();
    Context context;
    const auto reader = read_rows(folder.file("a.exr"), context);
    EXPECT_EQ(reader->header(),
              (RowHeader{{RowFormat::exr, 3, Component::f32, channels, "a comment"}, width, height, somewhere}));
    const std::vector<std::byte> bytes = all_rows(*reader);
    ASSERT_EQ(bytes.size(), 4 * all.size());
    EXPECT_EQ(std::memcmp(bytes.data(), all.data(), bytes.size()), 0);
}

TEST(ImageRows, OfAPictureThatIsNoWindowSayNoPlace) {
    const TemporaryFolder folder;
    Context context;
    for (const char* name : {"a.png", "a.hdr"}) {
        write(folder.file(name), noise_picture(width, height, 3, component_for(name)));
        EXPECT_EQ(read_rows(folder.file(name), context)->header().place, ImagePlace{}) << name;
        OutputTarget whole(folder.file(name));
        whole.place = {0, 0, width, height};
        const std::vector<std::byte> before = bytes_of_file(folder.file(name));
        write(whole, noise_picture(width, height, 3, component_for(name)));
        EXPECT_EQ(bytes_of_file(folder.file(name)), before) << name;
    }
}

TEST(ImageRows, FilesThatAreCutShortOrOfAnotherKindAreErrorsWithTheirName) {
    const TemporaryFolder folder;
    for (const char* name : {"a.png", "a.exr", "a.hdr"}) {
        write(placed(folder.file(name)), noise_picture(width, height, 3, component_for(name)));
        const std::vector<std::byte> whole = bytes_of_file(folder.file(name));
        for (std::size_t size = 0; size + 20 < whole.size();
             size += 1 + whole.size() / 97) {  // the last bytes of a PNG are no row
            put(folder.file("cut"), std::span(whole).first(size));
            Context context;
            EXPECT_EQ(error_of([&] { all_rows(*read_rows(folder.file("cut"), context)); }).code(), ErrorCode::bad_file)
                << name << " of " << size << " bytes";
        }
    }
    Context context;
    write(folder.file("a.webp"), noise_picture(8, 8, 3, Component::u8));
    for (const char* name : {"a.webp", "missing.png", ""}) {
        const Error error = error_of([&] { read_rows(name[0] ? folder.file(name) : "", context); });
        EXPECT_EQ(error.code(), name == std::string("a.webp") ? ErrorCode::bad_file : ErrorCode::not_found) << name;
    }
    EXPECT_EQ(error_of([&] { read_rows(folder.file("a.webp"), context); }).file(), folder.file("a.webp"));
}

TEST(ImageRows, AChangedByteIsAnErrorOrGivesRows) {
    const TemporaryFolder folder;
    for (const char* name : {"a.png", "a.exr", "a.hdr"}) {
        write(placed(folder.file(name)), noise_picture(16, 9, 3, component_for(name)));
        const std::vector<std::byte> whole = bytes_of_file(folder.file(name));
        int errors = 0;
        for (std::size_t at = 0; at < std::min<std::size_t>(whole.size(), 600); ++at) {
            std::vector<std::byte> changed = whole;
            changed[at] ^= std::byte(0xff);
            put(folder.file("changed"), changed);
            Context context({.max_memory = 64u << 20});
            try {
                all_rows(*read_rows(folder.file("changed"), context));
            } catch (const Error& error) {
                EXPECT_EQ(error.code(), ErrorCode::bad_file) << name << " at " << at;
                ++errors;
            }
        }
        EXPECT_GT(errors, 30) << name;
    }
}

TEST(ImageRows, MemoryIsCheckedBeforeItIsAskedFor) {
    const TemporaryFolder folder;
    std::ofstream(folder.file("a.hdr"), std::ios::binary)
        << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 65536 +X 65536\n";
    Context context({.max_memory = 100000});
    EXPECT_NE(std::string(error_of([&] { read_rows(folder.file("a.hdr"), context); }).what()).find("limit"),
              std::string::npos);
    std::ofstream(folder.file("b.hdr"), std::ios::binary) << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 65537\n";
    EXPECT_NE(error_of([&] { read_rows(folder.file("b.hdr"), context); }).reason().find("65536"), std::string::npos);
}

TEST(ImagePlaces, AreReadAsTheyAreWritten) {
    EXPECT_EQ(window_text({432, 210, 960, 720}, 240, 180), "432,210,240,180 of 960,720");
    EXPECT_EQ(window_text({0, 0, 960, 720}, 960, 720), "");
    EXPECT_EQ(window_text({}, 960, 720), "");
    EXPECT_EQ(place_of("432,210,240,180 of 960,720", 240, 180), (ImagePlace{432, 210, 960, 720}));
    for (const char* text : {"", " of ", "1,2,3 of 4,5", "1,2,3,4 of 5", "1,2,3,4 of 5,6 ", "-1,2,3,4 of 5,6",
                             "1,2,3,4,5 of 5,6", "1,2,3,4 of 99999999999,6", "1,2,5,4 of 5,6", "a,2,3,4 of 5,6"})
        EXPECT_EQ(error_of([&] { place_of(text, 3, 4); }).code(), ErrorCode::bad_file) << text;
}

}  // namespace
}  // namespace rakelight::io
