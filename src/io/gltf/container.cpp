// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/container.h"

#include <cstdint>
#include <cstring>

#include "base/format_text.h"

namespace rakelight::io::gltf {
namespace {

constexpr std::uint32_t magic = 0x46546C67, json_type = 0x4E4F534A, binary_type = 0x004E4942;
constexpr std::size_t header_bytes = 12, chunk_header_bytes = 8;

std::uint32_t word_at(std::span<const std::byte> bytes, std::size_t offset) {
    std::uint32_t word = 0;  // the container is little-endian, as every machine we build for
    std::memcpy(&word, bytes.data() + offset, 4);
    return word;
}

/// JSON may follow white space and a byte order mark; anything else is another kind of file.
bool looks_like_json(std::span<const std::byte> file) {
    for (const std::byte b : file) {
        const auto c = static_cast<unsigned char>(b);
        if (c == '{') return true;
        if (c != ' ' && c != '\t' && c != '\r' && c != '\n' && c != 0xEF && c != 0xBB && c != 0xBF) return false;
    }
    return false;
}

/// Chunks are padded with spaces; some writers use zero bytes.
std::span<const std::byte> without_padding(std::span<const std::byte> json) {
    while (!json.empty() && json.back() == std::byte{0}) json = json.first(json.size() - 1);
    return json;
}

std::span<const std::byte> checked_length(std::span<const std::byte> file, const std::string& path, Context& context) {
    if (file.size() < header_bytes)
        throw Error(ErrorCode::bad_file,
                    "cut short: the GLB header needs 12 bytes, the file has " + std::to_string(file.size()));
    const std::uint32_t version = word_at(file, 4), length = word_at(file, 8);
    if (version != 2) throw Error(ErrorCode::bad_file, format_text("GLB version {} is not supported, only 2", version));
    if (length > file.size())
        throw Error(ErrorCode::bad_file,
                    format_text("cut short: the GLB header says {} bytes, the file has {}", length, file.size()));
    if (length < header_bytes + chunk_header_bytes)
        throw Error(ErrorCode::bad_file, format_text("the GLB header says {} bytes: too few for a chunk", length));
    if (length < file.size())
        context.report().add(Remark::warning, path, {},
                             "the file is longer than its GLB header says; the rest is ignored");
    return file.first(length);
}

}  // namespace

Container open_container(std::span<const std::byte> file, const std::string& path, Context& context) {
    if (file.empty()) throw Error(ErrorCode::bad_file, "the file is empty");
    if (file.size() < 4 || word_at(file, 0) != magic) {
        if (!looks_like_json(file)) throw Error(ErrorCode::bad_file, "neither glTF JSON (UTF-8) nor a GLB container");
        return {.json = file};
    }
    const auto whole = checked_length(file, path, context);
    Container parts;
    std::size_t chunk = 0;
    for (std::size_t at = header_bytes; at < whole.size(); ++chunk) {
        const std::string place = "GLB chunk " + std::to_string(chunk);
        if (whole.size() - at < chunk_header_bytes) throw Error(ErrorCode::bad_file, "its header is cut short", place);
        const std::uint32_t size = word_at(whole, at), type = word_at(whole, at + 4);
        at += chunk_header_bytes;
        if (size > whole.size() - at)
            throw Error(ErrorCode::bad_file,
                        format_text("needs {} bytes, but only {} are left", size, whole.size() - at), place);
        const auto bytes = whole.subspan(at, size);
        at += size;
        if (chunk == 0) {
            if (type != json_type) throw Error(ErrorCode::bad_file, "the first chunk is not the JSON chunk", place);
            parts.json = without_padding(bytes);
        } else if (type == binary_type && !parts.has_binary) {
            parts.binary = bytes;
            parts.has_binary = true;
        } else {
            context.report().add(type == binary_type || type == json_type ? Remark::warning : Remark::note, path, place,
                                 "a GLB chunk that is second of its kind or of an unknown kind is ignored");
        }
    }
    return parts;
}

}  // namespace rakelight::io::gltf
