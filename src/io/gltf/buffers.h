// SPDX-License-Identifier: Apache-2.0
// Bytes of buffers and buffer views, read when first asked for, so that unused parts of a file cost and break nothing.
#pragma once
#include <map>
#include <optional>

#include "io/gltf/document.h"

namespace rakelight::io::gltf {

/// Bytes with what keeps them alive.
struct Region {
    std::span<const std::byte> bytes;
    std::shared_ptr<const void> owner;
    std::uint32_t stride = 0;  ///< byteStride of the view; 0: tightly packed
};

/// What a data URI holds; nullopt when `uri` is not one. @throws Error at `from`: without a comma, broken base64.
std::optional<Bytes> decode_data_uri(const std::string& uri, const Value& from, Context& context);

/// Where a URI of the file points on disk. @throws Error at `from`: it leaves the model's folder (names its last part
/// only).
std::string resolve_uri(const Document& document, const std::string& uri, const Value& from);

class Buffers {
public:
    explicit Buffers(const Document& document) : document_(document) {}

    /// @throws Error: no such buffer, broken URI, missing file, fewer bytes than byteLength says.
    Region buffer(std::uint32_t index, const Value& from);
    /// The bytes of a view, unpacked where it is compressed (EXT_meshopt_compression). @throws Error: reaches past its
    /// buffer.
    Region view(std::uint32_t index, const Value& from);

private:
    Region load_buffer(std::uint32_t index, const Value& buffer);
    Region slice(const Value& view);
    const Document& document_;
    std::map<std::uint32_t, Region> buffers_, unpacked_;
};

}  // namespace rakelight::io::gltf
