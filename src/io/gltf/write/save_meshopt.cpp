// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/write/save_meshopt.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cstring>

#include <nlohmann/json.hpp>

#include <rakelight/math/vector.h>

namespace rakelight::io::gltf {
namespace {

/// The first buffer that only says how long the unpacked data would be; null without one.
OrderedJson* buffer_without_bytes(OrderedJson& tree, std::size_t& number) {
    if (!tree.contains("buffers") || !tree["buffers"].is_array()) return nullptr;
    OrderedJson& buffers = tree["buffers"];
    for (number = 0; number < buffers.size(); ++number) {
        const OrderedJson& buffer = buffers[number];
        if (buffer.contains("uri") || !buffer.contains("extensions")) continue;
        for (const char* name : meshopt_names)
            if (buffer["extensions"].contains(name)) return &buffers[number];
    }
    return nullptr;
}

std::vector<std::byte> encoded(std::span<const std::byte> data, std::size_t element_bytes, bool is_indices) {
    const std::size_t count = data.size() / element_bytes;
    std::vector<std::byte> out;
    const auto to = [&](std::size_t bound) {
        out.resize(bound);
        return reinterpret_cast<unsigned char*>(out.data());
    };
    meshopt_encodeVertexVersion(0);  // what the extension allows; the library's own defaults change
    meshopt_encodeIndexVersion(1);
    if (is_indices) {  // as a sequence: the codec for triangles would turn them round
        std::vector<unsigned int> indices(count, 0);
        for (std::size_t i = 0; i < count; ++i)
            std::memcpy(&indices[i], data.data() + i * element_bytes, element_bytes);  // little-endian
        const std::size_t most = 1 + *std::max_element(indices.begin(), indices.end());
        const std::size_t bound = meshopt_encodeIndexSequenceBound(count, most);
        out.resize(meshopt_encodeIndexSequence(to(bound), bound, indices.data(), count));
    } else {
        const std::size_t bound = meshopt_encodeVertexBufferBound(count, element_bytes);
        out.resize(meshopt_encodeVertexBuffer(to(bound), bound, data.data(), count, element_bytes));
    }
    return out;
}

}  // namespace

std::vector<std::byte> compress(std::span<const std::byte> data, std::size_t element_bytes, bool is_indices,
                                const std::string& extension, OrderedJson& tree, OrderedJson& view) {
    const bool fits = is_indices ? element_bytes == 2 || element_bytes == 4
                                 : element_bytes % 4 == 0 && element_bytes > 0 && element_bytes <= 256;
    std::size_t number = 0;
    OrderedJson* buffer = fits && !data.empty() ? buffer_without_bytes(tree, number) : nullptr;
    if (!buffer) return {};
    std::vector<std::byte> packed = encoded(data, element_bytes, is_indices);
    if (packed.empty()) return {};
    const auto length = buffer->find("byteLength");
    if (length == buffer->end() || !length->is_number_unsigned() ||
        length->get<std::uint64_t>() > std::uint64_t(1) << 53)
        return {};
    const std::uint64_t begin = (length->get<std::uint64_t>() + 3) / 4 * 4;
    (*buffer)["byteLength"] = begin + data.size();
    view["buffer"] = number;
    view["byteOffset"] = begin;
    view["byteLength"] = data.size();
    view["extensions"][extension] = {{"byteLength", packed.size()},
                                     {"byteStride", element_bytes},
                                     {"mode", is_indices ? "INDICES" : "ATTRIBUTES"},
                                     {"count", data.size() / element_bytes}};
    return packed;
}

}  // namespace rakelight::io::gltf
