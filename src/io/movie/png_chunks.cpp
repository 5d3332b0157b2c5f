// SPDX-License-Identifier: Apache-2.0
#include "io/movie/png_chunks.h"

#include <cstring>

#include <rakelight/base/error.h>

namespace rakelight::io {
namespace {

constexpr std::size_t around = 12;  ///< [bytes] length, type and checksum
constexpr std::size_t header_bytes = 13;
constexpr std::uint32_t most_in_chunk = 0x7fffffff;

/// PNG, annex D: the sums of single bytes.
constexpr std::array<std::uint32_t, 256> byte_sums() {
    std::array<std::uint32_t, 256> sums{};
    for (std::uint32_t n = 0; n < 256; ++n) {
        std::uint32_t c = n;
        for (int bit = 0; bit < 8; ++bit) c = c >> 1 ^ (c & 1 ? 0xedb88320u : 0);
        sums[n] = c;
    }
    return sums;
}

class Checksum {
public:
    void add(std::span<const std::byte> bytes) {
        for (const std::byte b : bytes) sum_ = sums[(sum_ ^ std::uint32_t(b)) & 255] ^ sum_ >> 8;
    }
    std::uint32_t value() const { return ~sum_; }

private:
    static constexpr std::array<std::uint32_t, 256> sums = byte_sums();
    std::uint32_t sum_ = 0xffffffff;
};

std::span<const std::byte> bytes_of(std::string_view text) { return std::as_bytes(std::span(text)); }

std::uint32_t u32_at(std::span<const std::byte> bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | std::uint32_t(bytes[at + i]);
    return value;
}

Error broken(const std::string& what) { return Error(ErrorCode::bad_file, "broken PNG: " + what); }

bool begins_as_png(std::span<const std::byte> bytes) {
    return bytes.size() >= png_signature.size() &&
           std::memcmp(bytes.data(), png_signature.data(), png_signature.size()) == 0;
}

}  // namespace

std::vector<PngChunk> png_chunks(std::span<const std::byte> bytes) {
    if (!begins_as_png(bytes)) throw Error(ErrorCode::bad_file, "is not a PNG picture");
    std::vector<PngChunk> chunks;
    for (std::size_t at = png_signature.size(); chunks.empty() || chunks.back().type != "IEND";) {
        if (bytes.size() - at < around) throw broken("it ends too early");
        const std::uint32_t length = u32_at(bytes, at);
        if (length > most_in_chunk || length > bytes.size() - at - around) throw broken("it ends too early");
        const std::span<const std::byte> type = bytes.subspan(at + 4, 4), data = bytes.subspan(at + 8, length);
        Checksum sum;
        sum.add(type), sum.add(data);
        if (sum.value() != u32_at(bytes, at + 8 + length)) throw broken("a checksum is wrong");
        chunks.push_back({{reinterpret_cast<const char*>(type.data()), type.size()}, data});
        at += around + length;
    }
    return chunks;
}

PngHeader png_header(std::span<const PngChunk> chunks) {
    if (chunks.empty() || chunks[0].type != "IHDR" || chunks[0].data.size() != header_bytes)
        throw broken("it has no header");
    const std::span<const std::byte> data = chunks[0].data;
    return {u32_at(data, 0), u32_at(data, 4), std::uint8_t(data[8]), std::uint8_t(data[9]), std::uint8_t(data[12])};
}

void put_u16(std::vector<std::byte>& to, std::uint32_t value) {
    for (const int shift : {8, 0}) to.push_back(std::byte(value >> shift & 255));
}

void put_u32(std::vector<std::byte>& to, std::uint32_t value) {
    for (const int shift : {24, 16, 8, 0}) to.push_back(std::byte(value >> shift & 255));
}

void put_chunk(std::vector<std::byte>& to, std::string_view type, std::span<const std::byte> prefix,
               std::span<const std::byte> data) {
    put_u32(to, std::uint32_t(prefix.size() + data.size()));
    Checksum sum;
    for (const std::span<const std::byte> part : {bytes_of(type), prefix, data}) {
        to.insert(to.end(), part.begin(), part.end());
        sum.add(part);
    }
    put_u32(to, sum.value());
}

}  // namespace rakelight::io
