// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/packed/draco_header.h"

#include <cstring>

#include "base/format_text.h"

namespace rakelight::io::gltf {
namespace {

constexpr std::uint8_t mesh_geometry = 1, sequential_method = 0, edgebreaker_method = 1;
constexpr unsigned metadata_flag = 0x8000;
/// What the library takes while it decodes (corner table, traversal, attributes), measured on real meshes and rounded
/// up.
constexpr std::uint64_t working_bytes_per_face = 64, working_bytes_per_point = 96;
/// The most faces or points per byte of compressed data; a regular grid under the valence code reaches about 200.
constexpr std::uint64_t densest = 1024, slack = 65536;

/// Reads on while the data lasts; `good` falls forever at its end.
struct Cursor {
    std::span<const std::byte> data;
    bool good = true;

    std::uint8_t byte() {
        if (data.empty()) return good = false, std::uint8_t(0);
        const auto b = std::uint8_t(data.front());
        data = data.subspan(1);
        return b;
    }
    std::uint64_t varint() {  // LEB128, at most 10 bytes
        std::uint64_t value = 0;
        for (unsigned shift = 0; shift < 64 && good; shift += 7) {
            const std::uint8_t b = byte();
            value |= std::uint64_t(b & 0x7F) << shift;
            if (!(b & 0x80)) return value;
        }
        good = false;
        return 0;
    }
    void skip(std::uint64_t bytes) {
        if (bytes > data.size()) {
            good = false;
            return;
        }
        data = data.subspan(std::size_t(bytes));
    }
};

/// One metadata block with its nested ones, at most 8 deep.
void skip_metadata(Cursor& in, unsigned depth = 0) {
    if (depth > 8) {
        in.good = false;
        return;
    }
    for (std::uint64_t entries = in.varint(); entries > 0 && in.good; --entries) {
        in.skip(in.byte());
        in.skip(in.varint());
    }
    for (std::uint64_t nested = in.varint(); nested > 0 && in.good; --nested) {
        in.skip(in.byte());
        skip_metadata(in, depth + 1);
    }
}

}  // namespace

std::optional<DracoHeader> read_draco_header(std::span<const std::byte> data) {
    if (data.size() < 11 || std::memcmp(data.data(), "DRACO", 5) != 0) return std::nullopt;
    Cursor in{data.subspan(5)};
    DracoHeader header;
    header.major = in.byte();
    header.minor = in.byte();
    header.is_mesh = in.byte() == mesh_geometry;
    const std::uint8_t method = in.byte();
    const unsigned low = in.byte(), flags = low | unsigned(in.byte()) << 8;
    if (flags & metadata_flag) {
        for (std::uint64_t attributes = in.varint(); attributes > 0 && in.good; --attributes) {
            in.varint();
            skip_metadata(in);
        }
        skip_metadata(in);
    }
    if (method == sequential_method) {
        header.faces = in.varint();
        header.points = in.varint();
    } else if (method == edgebreaker_method) {
        in.byte();  // kind of traversal
        header.points = in.varint();
        header.faces = in.varint();
    } else {
        return std::nullopt;
    }
    return in.good ? std::optional(header) : std::nullopt;
}

void check_draco_header(std::span<const std::byte> data, const Value& from, Context& context) {
    const auto header = read_draco_header(data);
    if (!header || !header->is_mesh) from.fail("its Draco data is not a Draco mesh");
    if (header->major != 2 || header->minor != 2)
        from.fail(format_text("its Draco data has version {}.{}; glTF allows 2.2 only", header->major, header->minor));
    const std::uint64_t most = densest * data.size() + slack;
    if (header->faces > most || header->points > most)
        from.fail(format_text("its Draco data announces {} triangles and {} vertices, more than {} bytes can hold",
                              header->faces, header->points, data.size()));
    context.memory().check(header->faces * working_bytes_per_face + header->points * working_bytes_per_point,
                           "decoding a Draco mesh");
}

}  // namespace rakelight::io::gltf
