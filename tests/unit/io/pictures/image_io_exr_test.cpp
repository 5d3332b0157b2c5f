// SPDX-License-Identifier: Apache-2.0
// EXR files of the kinds that other programs write, made here with the library itself, and headers that lie.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>
#include <ImfTiledOutputFile.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

#include "io/pictures/image_io.h"
#include "io/pictures/reduced_image.h"
#include "unit/io/pictures/image_io_support.h"

namespace rakelight::io {
namespace {

using test::bytes_of_file;
using test::error_of;
using test::TemporaryFolder;

constexpr int width = 21, height = 13;

/// Any data window that covers width x height pixels.
Imf::Header header_at(int x, int y) {
    const Imath::Box2i window(Imath::V2i(x, y), Imath::V2i(x + width - 1, y + height - 1));
    return {Imath::Box2i(Imath::V2i(0, 0), Imath::V2i(99, 99)), window};
}

float value_at(int x, int y, int c) { return float(c) + float(x) / 32.0f + float(y) * 2.0f; }

std::vector<float> values_of(const Pixels& pixels) {
    std::vector<float> values(pixels.bytes.size() / 4);
    std::memcpy(values.data(), pixels.bytes.data(), pixels.bytes.size());
    return values;
}

/// Planes of floats or halves, [channel][height][width], and slices of them for a window that begins at (x, y).
template <class T>
struct Planes {
    std::vector<T> values;
    explicit Planes(int channels) {
        for (int c = 0; c < channels; ++c)
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) values.push_back(T(value_at(x, y, c)));
    }
    Imf::FrameBuffer slices(const std::vector<const char*>& names, const Imf::Header& header) const {
        Imf::FrameBuffer buffer;
        for (std::size_t c = 0; c < names.size(); ++c)
            buffer.insert(names[c],
                          Imf::Slice::Make(sizeof(T) == 2 ? Imf::HALF : Imf::FLOAT, values.data() + c * width * height,
                                           header.dataWindow(), sizeof(T), sizeof(T) * width));
        return buffer;
    }
};

void expect_planes(const Pixels& pixels, int channels) {
    ASSERT_EQ(pixels.width, width);
    ASSERT_EQ(pixels.height, height);
    ASSERT_EQ(pixels.channels, channels);
    EXPECT_TRUE(pixels.is_linear);
    const std::vector<float> values = values_of(pixels);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < channels; ++c)
                ASSERT_EQ(values[std::size_t((y * width + x) * channels + c)], value_at(x, y, c))
                    << x << " " << y << " " << c;
}

Pixels decode(const std::string& path) {
    Context context;
    return decode_image(bytes_of_file(path), context);
}

TEST(ExrReading, HalvesOfEveryCompressionInAWindowAwayFromTheOrigin) {
    const TemporaryFolder folder;
    for (const auto compression : {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION,
                                   Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION}) {
        Imf::Header header = header_at(-7, 1000);
        header.compression() = compression;
        for (const char* name : {"R", "G", "B"}) header.channels().insert(name, Imf::Channel(Imf::HALF));
        {
            const Planes<half> planes(3);
            Imf::OutputFile file(folder.file("a.exr").c_str(), header);
            file.setFrameBuffer(planes.slices({"R", "G", "B"}, header));
            file.writePixels(height);
        }
        expect_planes(decode(folder.file("a.exr")), 3);
    }
}

TEST(ExrReading, TilesAndBottomUpLines) {
    const TemporaryFolder folder;
    Imf::Header header = header_at(3, -5);
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    header.setTileDescription(Imf::TileDescription(8, 4, Imf::MIPMAP_LEVELS));
    const Planes<float> planes(1);
    {
        Imf::TiledOutputFile file(folder.file("tiled.exr").c_str(), header);
        file.setFrameBuffer(planes.slices({"Y"}, header));
        file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
    }
    expect_planes(decode(folder.file("tiled.exr")), 1);
    header = header_at(0, 0);
    header.lineOrder() = Imf::DECREASING_Y;
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    {
        Imf::OutputFile file(folder.file("up.exr").c_str(), header);
        file.setFrameBuffer(planes.slices({"Y"}, header));
        file.writePixels(height);
    }
    expect_planes(decode(folder.file("up.exr")), 1);
}

TEST(ExrReading, TheFirstOfSeveralPartsAndOtherLayersAreLeftOut) {
    const TemporaryFolder folder;
    std::vector<Imf::Header> headers(2, header_at(0, 0));
    for (std::size_t i = 0; i < 2; ++i) {
        headers[i].setName(i == 0 ? "first" : "second");
        headers[i].setType(Imf::SCANLINEIMAGE);
        for (const char* name : {"R", "G", "B", "diffuse.R"})
            headers[i].channels().insert(name, Imf::Channel(Imf::FLOAT));
    }
    const Planes<float> planes(4);
    {
        Imf::MultiPartOutputFile file(folder.file("a.exr").c_str(), headers.data(), 2);
        for (int i = 0; i < 2; ++i) {
            Imf::OutputPart part(file, i);
            part.setFrameBuffer(i == 0 ? planes.slices({"R", "G", "B", "diffuse.R"}, headers[0])
                                       : planes.slices({"diffuse.R", "R", "G", "B"}, headers[1]));
            part.writePixels(height);
        }
    }
    expect_planes(decode(folder.file("a.exr")), 3);
}

TEST(ExrReading, LuminanceAndChromaBecomeRgb) {
    const TemporaryFolder folder;
    constexpr int w = 20, h = 12;  // halved chroma wants even sizes
    const Imath::Box2i window(Imath::V2i(-4, 6), Imath::V2i(-4 + w - 1, 6 + h - 1));
    std::vector<Imf::Rgba> grays;
    for (int i = 0; i < w * h; ++i) grays.emplace_back(float(1 + i % w), float(1 + i % w), float(1 + i % w));
    for (int x = 0; x < w; ++x) grays[std::size_t(x)] = Imf::Rgba(40, 40, 40);  // the first row is another
    {
        Imf::RgbaOutputFile file(folder.file("a.exr").c_str(), Imf::Header(window, window), Imf::WRITE_YC);
        file.setFrameBuffer(grays.data() + 4 - 6 * w, 1, w);
        file.writePixels(h);
    }
    const Pixels pixels = decode(folder.file("a.exr"));
    ASSERT_EQ(pixels.channels, 3);
    ASSERT_EQ(pixels.width, w);
    ASSERT_EQ(pixels.height, h);
    const std::vector<float> values = values_of(pixels);
    for (int i = 0; i < w * h * 3; ++i)
        ASSERT_NEAR(values[std::size_t(i)], i < w * 3 ? 40.0f : float(1 + i / 3 % w), 0.05f) << i;
}

TEST(ExrReading, ChannelsThatAreNoColorAreRefused) {
    const TemporaryFolder folder;
    Imf::Header header = header_at(0, 0);
    header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
    const Planes<float> planes(1);
    {
        Imf::OutputFile file(folder.file("a.exr").c_str(), header);
        file.setFrameBuffer(planes.slices({"Z"}, header));
        file.writePixels(height);
    }
    EXPECT_NE(error_of([&] { decode(folder.file("a.exr")); }).reason().find("R, G, B or Y"), std::string::npos);
}

/// A small file of ours with `count` bytes `offset` after the end of a header value's name replaced.
Error error_after_change(const std::string& name, std::size_t offset, const std::vector<int>& bytes) {
    const TemporaryFolder folder;
    write_image(folder.file("a.exr"), test::noise_picture(16, 16, 3, Component::f32));
    auto file = bytes_of_file(folder.file("a.exr"));
    const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
    const std::size_t at = text.find(name + '\0') + name.size() + 1 + offset;
    for (std::size_t i = 0; i < bytes.size(); ++i) file[at + i] = std::byte(bytes[i]);
    Context context;
    return error_of([&] { decode_image(file, context); });
}

TEST(ExrReading, ItsWorkIsSeveralTimesThatOfAPng) {
    Context context;
    const std::uint64_t pixels = 64 * 32;
    std::vector<std::byte> bytes;
    write_image({"a.exr", bytes}, test::noise_picture(64, 32, 3, Component::f32));
    const std::uint64_t work = codec::reduced_work(bytes, 16, context);
    EXPECT_GT(work, 3 * pixels);
    bytes.resize(bytes.size() + 2 * pixels);  // as further channels do
    EXPECT_EQ(codec::reduced_work(bytes, 16, context), work + pixels);
}

TEST(ExrReading, HeadersThatLieAreRefusedBeforeTheLibrarySeesThem) {
    const std::size_t window = 6 + 4;  // behind "box2i", its zero and the size
    EXPECT_NE(error_after_change("dataWindow", window + 8, {255, 255, 0, 0}).reason().find("32768 per side"),
              std::string::npos);
    EXPECT_NE(error_after_change("dataWindow", window, {255, 255, 255, 127}).reason().find("too far out"),
              std::string::npos);
    EXPECT_NE(error_after_change("dataWindow", window + 8, {255, 255, 255, 255}).reason().find("no pixels"),
              std::string::npos);
    EXPECT_NE(error_after_change("dataWindow", 6, {17, 0, 0, 0}).reason().find("wrong size"), std::string::npos);
    EXPECT_NE(error_after_change("dataWindow", 6, {0, 0, 0, 127}).reason().find("too early"), std::string::npos);
    EXPECT_NE(error_after_change("dataWindow", 0, {'b', 'o', 'x', '2', 'f'}).reason().find("wrong type"),
              std::string::npos);
    EXPECT_NE(error_after_change("channels", 7, {18, 0, 0, 0}).reason().find("EXR"), std::string::npos);
    EXPECT_NE(error_after_change("channels", 7 + 4 + 2 + 8, {0, 0, 0, 0}).reason().find("sampling"), std::string::npos);
}

}  // namespace
}  // namespace rakelight::io
