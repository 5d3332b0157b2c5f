// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/buffers.h"

#include "base/format_text.h"
#include "io/gltf/packed/meshopt.h"

namespace rakelight::io::gltf {
namespace {

std::string last_part(const std::string& uri) {
    const auto slash = uri.find_last_of("/\\");
    return one_line(slash == std::string::npos ? uri : uri.substr(slash + 1), 80);
}

/// 4..252 and a multiple of 4 by the specification; only what the arithmetic needs is insisted on.
std::uint32_t checked_stride(const Value& view) {
    const std::uint64_t stride = view.count("byteStride", 0);
    if (stride > 65536) view.fail(format_text("byteStride {} is more than 252", stride));
    return std::uint32_t(stride);
}

}  // namespace

std::optional<Bytes> decode_data_uri(const std::string& uri, const Value& from, Context& context) {
    if (!uri.starts_with("data:")) return std::nullopt;
    const auto comma = uri.find(',');
    if (comma == std::string::npos) from.fail("its data URI has no comma");
    const std::string_view header = std::string_view(uri).substr(0, comma),
                           body = std::string_view(uri).substr(comma + 1);
    MemoryCharge charge(context.memory(), body.size(), "a data URI");
    if (header.ends_with(";base64")) {
        auto bytes = base64_decode(body);
        if (!bytes) from.fail("the base64 of its data URI is broken");
        return charged_bytes(std::move(*bytes), std::move(charge));
    }
    const auto text = percent_decode(std::string(body));
    if (!text) from.fail("the percent-encoding of its data URI is broken");
    const auto* begin = reinterpret_cast<const std::byte*>(text->data());
    return charged_bytes({begin, begin + text->size()}, std::move(charge));
}

std::string resolve_uri(const Document& document, const std::string& uri, const Value& from) {
    if (uri.empty()) from.fail("its URI is empty");
    try {
        const std::string decoded = percent_decode(uri).value_or(uri);
        std::string path = resolve_reference(document.path(), decoded, document.options().allow_outside);
        if (decoded == uri || is_regular_file(path)) return path;
        // Some exporters write names with a percent sign as they are.
        std::string literal = resolve_reference(document.path(), uri, document.options().allow_outside);
        return is_regular_file(literal) ? literal : path;
    } catch (const Error& error) {
        throw error.at(from.place());
    }
}

Region Buffers::buffer(std::uint32_t index, const Value& from) {
    if (const auto known = buffers_.find(index); known != buffers_.end()) return known->second;
    Region region = load_buffer(index, document_.element(buffer_kind, index, from));
    return buffers_.emplace(index, std::move(region)).first->second;
}

Region Buffers::load_buffer(std::uint32_t index, const Value& buffer) {
    const std::uint64_t length = buffer.required_count("byteLength");
    const std::string* uri = buffer.text_pointer("uri");
    Region region;
    if (!uri) {
        if (index != 0 || !document_.has_binary()) buffer.fail("it has no URI and the file has no binary chunk for it");
        region = {document_.binary(), document_.file()};
    } else if (auto embedded = decode_data_uri(*uri, buffer, document_.context())) {
        region = {**embedded, *embedded};
    } else {
        const std::string path = resolve_uri(document_, *uri, buffer);
        try {
            const Bytes bytes = read_file(path, document_.context());
            region = {*bytes, bytes};
        } catch (const Error& error) {  // the message must name the model, not only the buffer's file
            throw Error(error.code(), "the file '" + last_part(*uri) + "': " + error.reason(), buffer.place(),
                        error.advice());
        }
    }
    if (length > region.bytes.size())
        buffer.fail(format_text("byteLength says {} bytes, but there are {}", length, region.bytes.size()));
    region.bytes = region.bytes.first(std::size_t(length));
    return region;
}

Region Buffers::slice(const Value& view) {
    const std::uint32_t index = view.required_index("buffer");
    const std::uint64_t offset = view.count("byteOffset", 0), length = view.required_count("byteLength");
    Region region = buffer(index, view);
    if (offset > region.bytes.size() || length > region.bytes.size() - offset)
        view.fail(format_text("reads past the end of buffer {} (bytes {} to {} of {})", index, offset, offset + length,
                              region.bytes.size()));
    region.bytes = region.bytes.subspan(std::size_t(offset), std::size_t(length));
    return region;
}

Region Buffers::view(std::uint32_t index, const Value& from) {
    const Value view = document_.element(buffer_view_kind, index, from);
    Value packed = view.extension("EXT_meshopt_compression");
    if (!packed) packed = view.extension("KHR_meshopt_compression");
    if (!packed) {
        Region region = slice(view);
        region.stride = checked_stride(view);
        return region;
    }
    if (const auto known = unpacked_.find(index); known != unpacked_.end()) return known->second;
    const auto bytes = decode_meshopt(packed, slice(packed).bytes, document_.context());
    return unpacked_.emplace(index, Region{*bytes, bytes, checked_stride(view)}).first->second;
}

}  // namespace rakelight::io::gltf
