// SPDX-License-Identifier: Apache-2.0
// Movies of PNG files: APNG chunk by chunk, WebP by its container, and what is refused.
#include <rakelight/io/movie.h>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <cstring>

#include "io/movie/png_chunks.h"
#include "io/pictures/image_io.h"
#include "io/pictures/whole_picture.h"
#include "unit/io/pictures/image_io_support.h"

namespace rakelight {
namespace {

using io::PngChunk, io::png_chunks;
using test::bytes_of_file, test::error_of;

class Movies : public testing::Test {
protected:
    /// Noise that differs from picture to picture.
    std::string picture(int number, int width = 21, int height = 14, int channels = 3) {
        Pixels pixels = test::noise_picture(width, height, channels, Component::u8);
        for (std::size_t i = 0; i < pixels.bytes.size(); i += 5)
            pixels.bytes[i] = std::byte(i * std::size_t(number + 3));
        const std::string path = folder_.file("p" + std::to_string(number) + ".png");
        io::write_image(path, pixels);
        return path;
    }
    std::vector<std::string> pictures(int count, int channels = 3) {
        std::vector<std::string> names;
        for (int i = 0; i < count; ++i) names.push_back(picture(i, 21, 14, channels));
        return names;
    }
    std::string write(const std::string& name, const std::vector<std::byte>& bytes) {
        return folder_.write(name, std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    }
    /// The error of a movie whose second picture is `bad`; nothing is left of it.
    Error refused(const std::string& ending, const std::string& bad) {
        const std::string movie = folder_.file("refused" + ending);
        const std::vector<std::string> names{picture(0), bad};
        const Error error = error_of([&] { write_movie(movie, names, 25, context_); });
        EXPECT_EQ(error.code(), ErrorCode::bad_file) << ending;
        EXPECT_EQ(error.file(), bad) << ending;
        EXPECT_FALSE(std::filesystem::exists(movie)) << ending;
        return error;
    }
    static bool has_ffmpeg() {
        try {
            check_movie("a.mp4", {});
            return true;
        } catch (const Error&) {
            return false;
        }
    }
    Pixels decoded(const std::string& path) { return io::decode_image(bytes_of_file(path), context_); }

    test::TemporaryFolder folder_;
    Context context_{{.threads = 1}};
};

std::uint32_t number_at(std::span<const std::byte> data, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | std::uint32_t(data[at + i]);
    return value;
}

/// The PNG file that picture `wanted` of an animation is by itself.
std::vector<std::byte> frame_alone(std::span<const PngChunk> chunks, int wanted) {
    std::vector<std::byte> file;
    for (const std::uint8_t byte : io::png_signature) file.push_back(std::byte(byte));
    int number = -1;
    for (const PngChunk& chunk : chunks) {
        number += chunk.type == "fcTL";
        if (chunk.type == "IHDR") io::put_chunk(file, "IHDR", {}, chunk.data);
        if (number != wanted) continue;
        if (chunk.type == "IDAT") io::put_chunk(file, "IDAT", {}, chunk.data);
        if (chunk.type == "fdAT") io::put_chunk(file, "IDAT", {}, chunk.data.subspan(4));
    }
    io::put_chunk(file, "IEND", {}, {});
    return file;
}

TEST_F(Movies, ApngHasAllPicturesInTheirOwnData) {
    for (const int channels : {3, 4}) {
        const std::vector<std::string> names = pictures(3, channels);
        const std::string path = folder_.file("a.apng");
        write_movie(path, names, 25, context_);
        const std::vector<std::byte> bytes = bytes_of_file(path);
        const std::vector<PngChunk> chunks = png_chunks(bytes);
        ASSERT_EQ(chunks[1].type, "acTL");
        EXPECT_EQ(number_at(chunks[1].data, 0), 3u);
        EXPECT_EQ(number_at(chunks[1].data, 4), 0u);  // for ever
        std::uint32_t sequence = 0;
        for (const PngChunk& chunk : chunks)
            if (chunk.type == "fcTL" || chunk.type == "fdAT") {
                EXPECT_EQ(number_at(chunk.data, 0), sequence++);
            }
        for (int i = 0; i < 3; ++i) {
            const Pixels frame = io::decode_image(frame_alone(chunks, i), context_);
            EXPECT_EQ(frame.bytes, decoded(names[std::size_t(i)]).bytes) << i;
        }
        EXPECT_EQ(io::decode_image(bytes, context_).bytes, decoded(names[0]).bytes);  // for who knows PNG alone
    }
}

TEST_F(Movies, ApngSaysHowLongAPictureIsShown) {
    const std::vector<std::string> names = pictures(2);
    const auto delay = [&](double fps) {
        const std::string path = folder_.file("a.apng");
        write_movie(path, names, fps, context_);
        const std::vector<std::byte> bytes = bytes_of_file(path);
        for (const PngChunk& chunk : png_chunks(bytes))
            if (chunk.type == "fcTL") return number_at(chunk.data, 20);  // two numbers of 16 bits
        return 0u;
    };
    EXPECT_EQ(delay(30), 1u << 16 | 30);
    EXPECT_EQ(delay(12.5), 10u << 16 | 125);
    EXPECT_EQ(delay(29.97), 100u << 16 | 2997);
    EXPECT_EQ(delay(0.05), 100u << 16 | 5);
    EXPECT_EQ(delay(1000), 1u << 16 | 1000);
}

TEST_F(Movies, TheSamePicturesGiveTheSameBytes) {
    const std::vector<std::string> names = pictures(3, 4);
    for (const std::string ending : {".apng", ".webp"}) {
        write_movie(folder_.file("a" + ending), names, 24, context_);
        write_movie(folder_.file("b" + ending), names, 24, context_);
        EXPECT_EQ(bytes_of_file(folder_.file("a" + ending)), bytes_of_file(folder_.file("b" + ending))) << ending;
    }
}

TEST_F(Movies, WebpHasAFrameForEachPicture) {
    write_movie(folder_.file("a.webp"), pictures(4), 10, context_);
    const std::vector<std::byte> bytes = bytes_of_file(folder_.file("a.webp"));
    const auto little = [&](std::size_t at, std::size_t count) {
        std::uint32_t value = 0;
        for (std::size_t i = count; i-- > 0;) value = value << 8 | std::uint32_t(bytes[at + i]);
        return value;
    };
    std::size_t frames = 0;
    for (std::size_t at = 12; at + 8 <= bytes.size(); at += 8 + (little(at + 4, 4) + 1) / 2 * 2) {
        if (std::memcmp(&bytes[at], "ANMF", 4) != 0) continue;
        ++frames;
        EXPECT_EQ(little(at + 8 + 12, 3), 100u);  // [ms]
    }
    EXPECT_EQ(frames, 4u);
}

TEST_F(Movies, PicturesThatDifferInKindAreRefused) {
    const std::string movie = folder_.file("a.apng"), first = picture(0);
    const auto refused = [&](const std::string& other) {
        const std::vector<std::string> names{first, other};
        return error_of([&] { write_movie(movie, names, 30, context_); });
    };
    EXPECT_NE(refused(picture(1, 22)).reason().find("another size"), std::string::npos);
    EXPECT_NE(refused(picture(2, 21, 14, 4)).reason().find("another size or kind"), std::string::npos);
    EXPECT_EQ(refused(folder_.file("none.png")).code(), ErrorCode::not_found);
    const std::vector<std::byte> whole = bytes_of_file(first);
    const std::string cut =
        folder_.write("cut.png", std::string(reinterpret_cast<const char*>(whole.data()), whole.size() - 3));
    EXPECT_EQ(refused(cut).code(), ErrorCode::bad_file);
    EXPECT_EQ(refused(cut).file(), cut);
    EXPECT_FALSE(std::filesystem::exists(movie));
}

TEST_F(Movies, DamagedDataAreFound) {
    std::vector<std::byte> bytes = bytes_of_file(picture(0));
    bytes[bytes.size() - 30] ^= std::byte(1);
    const Error error = refused(".apng", write("bad.png", bytes));
    EXPECT_NE(error.reason().find("checksum"), std::string::npos);
}

TEST_F(Movies, APictureThatIsDamagedInItsMiddleIsRefusedByName) {
    const std::vector<std::byte> whole = bytes_of_file(picture(1));
    std::vector<std::byte> changed = whole;
    changed[changed.size() / 2] ^= std::byte(1);
    std::vector<std::byte> shortened;  // whole chunks with data that end too early
    for (const std::uint8_t byte : io::png_signature) shortened.push_back(std::byte(byte));
    for (const PngChunk& chunk : png_chunks(whole))
        io::put_chunk(shortened, chunk.type, {},
                      chunk.type == "IDAT" ? chunk.data.first(chunk.data.size() / 2) : chunk.data);
    for (const std::string ending : {".apng", ".webp", ".mp4", ".gif", ".webm"}) {
        if (ending != ".apng" && ending != ".webp" && !has_ffmpeg()) continue;
        refused(ending, write("changed.png", changed));
        refused(ending, write("shortened.png", shortened));
    }
}

TEST_F(Movies, AFifoWithThePicturesNameIsNotWaitedFor) {
    const std::string fifo = folder_.file("fifo.png");
    ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
    const std::vector<std::string> names{picture(0), fifo};
    const Error error = error_of([&] { write_movie(folder_.file("a.apng"), names, 30, context_); });
    EXPECT_EQ(error.code(), ErrorCode::not_found);
    EXPECT_EQ(error.file(), fifo);
}

TEST_F(Movies, EveryCutFileIsRefusedInOneWay) {
    const std::vector<std::byte> bytes = bytes_of_file(picture(0));
    for (std::size_t size = 0; size < bytes.size(); size += 7)
        EXPECT_EQ(error_of([&] { png_chunks(std::span(bytes).first(size)); }).code(), ErrorCode::bad_file) << size;
}

TEST_F(Movies, WhatAFormatDoesNotHaveIsSaidBefore) {
    EXPECT_EQ(error_of([] { check_movie("a.avi", {}); }).code(), ErrorCode::usage);
    EXPECT_EQ(error_of([] { check_movie("a.mp4", {8, 8, true}); }).code(), ErrorCode::usage);
    EXPECT_EQ(error_of([] { check_movie("a.webp", {20000, 8, false}); }).code(), ErrorCode::usage);
    EXPECT_NO_THROW(check_movie("a.WEBM", {8, 8, true}));
    EXPECT_EQ(error_of([&] { write_movie("a.apng", {}, 30, context_); }).code(), ErrorCode::usage);
    EXPECT_TRUE(is_movie("x.GIF"));
    EXPECT_FALSE(is_movie("x.png"));
}

TEST_F(Movies, OnlyWholeFilesCountAsThere) {
    const std::string path = picture(0);
    const io::PngHeader header = io::header_of_whole_png(path, context_);
    EXPECT_EQ(header.width, 21u);
    EXPECT_EQ(header.height, 14u);
    std::filesystem::resize_file(path, std::filesystem::file_size(path) - 1);
    for (const std::string& other : {path, folder_.write("empty.png", ""), folder_.file("none.png")})
        EXPECT_EQ(error_of([&] { io::header_of_whole_png(other, context_); }).file(), other);
}

TEST_F(Movies, DecodingAWholePictureHoldsItsFileAndAFewRows) {
    const std::string path = picture(0, 600, 2000);
    const std::uint64_t file = std::filesystem::file_size(path), all_rows = 600ull * 2000 * 3;
    Context context({.threads = 1, .max_memory = file + all_rows / 10});
    EXPECT_EQ(io::header_of_whole_png(path, context).height, 2000u);
    Context small({.threads = 1, .max_memory = file - 1});
    EXPECT_EQ(error_of([&] { io::header_of_whole_png(path, small); }).code(), ErrorCode::bad_file);
}

}  // namespace
}  // namespace rakelight
