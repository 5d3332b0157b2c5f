// SPDX-License-Identifier: Apache-2.0
// APNG: the compressed data of PNG files in the chunks of an animation (PNG, third edition, section 11.3.6).
#include <cmath>

#include "io/files/file.h"
#include "io/files/output_file.h"
#include "io/movie/movie_formats.h"

namespace rakelight::io {
namespace {

/// How long a picture is shown, as two numbers of 16 bits.
struct Delay {
    std::uint32_t seconds, parts;
};

Delay delay_of(double fps) {
    for (const std::uint32_t scale : {1u, 10u, 100u, 1000u}) {
        const double parts = std::round(fps * scale);
        if (parts <= 65535 && parts >= 1 && (std::fabs(parts - fps * scale) < 1e-6 || scale == 1000))
            return {scale, std::uint32_t(parts)};
    }
    return {1, std::uint32_t(std::round(fps))};  // 65 to 1000 a second with more than three digits
}

/// Frame control: the whole picture replaces the one before.
void put_frame(std::vector<std::byte>& to, std::uint32_t number, const PngHeader& header, Delay delay) {
    std::vector<std::byte> data;
    for (const std::uint32_t value : {number, header.width, header.height, 0u, 0u}) put_u32(data, value);
    put_u16(data, delay.seconds), put_u16(data, delay.parts);
    data.insert(data.end(), {std::byte(0), std::byte(0)});  // dispose: none; blend: source
    put_chunk(to, "fcTL", {}, data);
}

/// Signature, IHDR and all other chunks before the first picture's data, with the number of pictures.
void put_head(std::vector<std::byte>& to, std::span<const PngChunk> chunks, std::size_t pictures) {
    for (const std::uint8_t byte : png_signature) to.push_back(std::byte(byte));
    std::vector<std::byte> control;
    put_u32(control, std::uint32_t(pictures)), put_u32(control, 0);  // 0: forever
    for (const PngChunk& chunk : chunks) {
        if (chunk.type == "IDAT") break;
        put_chunk(to, chunk.type, {}, chunk.data);
        if (chunk.type == "IHDR") put_chunk(to, "acTL", {}, control);
    }
}

void write_apng(const std::string& path, const MoviePictures& pictures, Context& context) {
    OutputFile out(path);
    const Delay delay = delay_of(pictures.fps);
    std::uint32_t number = 0;  // of fcTL and fdAT together
    for (std::size_t i = 0; i < pictures.files.size(); ++i) {
        context.throw_if_cancelled();
        context.progress("movie", double(i) / double(pictures.files.size()));
        const Bytes file = read_file(pictures.files[i], context);
        try {
            const std::vector<PngChunk> chunks = png_chunks(*file);
            std::vector<std::byte> bytes;
            if (i == 0) put_head(bytes, chunks, pictures.files.size());
            put_frame(bytes, number++, pictures.header, delay);
            for (const PngChunk& chunk : chunks) {
                if (chunk.type != "IDAT") continue;
                std::vector<std::byte> prefix;
                if (i > 0) put_u32(prefix, number++);
                put_chunk(bytes, i == 0 ? "IDAT" : "fdAT", prefix, chunk.data);
            }
            out.write(bytes);
        } catch (const Error& error) {
            throw error.code() == ErrorCode::bad_file ? error.with_file(pictures.files[i]) : error;
        }
    }
    std::vector<std::byte> end;
    put_chunk(end, "IEND", {}, {});
    out.write(end);
    out.commit();
}

}  // namespace

constinit const MovieFormat apng_movie = {.ending = "apng", .most_side = 65536, .write = write_apng};

}  // namespace rakelight::io
