// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/write/save_data.h"

#include <algorithm>
#include <cstring>

#include <nlohmann/json.hpp>

#include "io/gltf/write/save_meshopt.h"
#include "io/gltf/write/save_storage.h"

namespace rakelight::io::gltf {
namespace {

constexpr int vertex_target = 34962, index_target = 34963;  // ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER

std::uint64_t hash_of(std::span<const std::byte> bytes) {  // FNV-1a
    std::uint64_t h = 0xcbf29ce484222325u;
    for (const std::byte b : bytes) h = (h ^ std::uint64_t(b)) * 0x100000001b3u;
    return h;
}

template <class T>
std::vector<std::byte> bytes_of(std::span<const T> values) {
    const auto raw = std::as_bytes(values);
    return {raw.begin(), raw.end()};
}

template <class T>
std::vector<std::byte> narrowed(std::span<const std::uint32_t> values) {
    std::vector<T> narrow(values.begin(), values.end());
    return bytes_of(std::span<const T>(narrow));
}

const char* type_name(std::uint32_t components) {
    switch (components) {
        case 1:
            return "SCALAR";
        case 2:
            return "VEC2";
        case 3:
            return "VEC3";
        case 4:
            return "VEC4";
        default:
            return "MAT4";
    }
}

}  // namespace

std::uint32_t NewData::accessor(std::vector<std::byte> data, std::uint32_t stride, int target,
                                OrderedJson description) {
    // 1. a view of the same bytes, or a new one; every view begins at a multiple of 4
    const std::uint64_t hash = hash_of(data);
    const auto is_same = [&](const Known& k) {
        const std::byte* known = k.data.empty() ? bytes_.data() + k.begin : k.data.data();
        return k.size == data.size() && k.stride == stride && k.target == target && k.extension == extension_ &&
               std::equal(data.begin(), data.end(), known);
    };
    std::uint32_t view = no_index;
    for (auto [at, end] = views_.equal_range(hash); at != end && view == no_index; ++at)
        if (is_same(at->second)) view = at->second.view;
    if (view == no_index) {
        const std::size_t begin = bytes_.size();
        OrderedJson json = new_view(data, stride, target, description["count"].get<std::size_t>());
        const bool is_packed = json.contains("extensions");
        OrderedJson& views = root_["bufferViews"];
        view = std::uint32_t(views.size());
        views.push_back(std::move(json));
        views_.emplace(hash, Known{begin, data.size(), stride, target, extension_,
                                   is_packed ? std::move(data) : std::vector<std::byte>{}, view});
    }
    // 2. the accessor
    description["bufferView"] = view;
    const auto [entry, is_new] = accessors_.try_emplace(description.dump(), 0u);
    if (is_new) {
        OrderedJson& accessors = root_["accessors"];
        entry->second = std::uint32_t(accessors.size());
        accessors.push_back(std::move(description));
    }
    return entry->second;
}

/// Appends the bytes of a view, compressed where that is wanted and can be.
OrderedJson NewData::new_view(std::span<const std::byte> data, std::uint32_t stride, int target, std::size_t count) {
    OrderedJson json = {{"buffer", buffer_}, {"byteOffset", offset_ + bytes_.size()}, {"byteLength", data.size()}};
    if (stride != 0) json["byteStride"] = stride;
    if (target != 0) json["target"] = target;
    std::vector<std::byte> packed;
    if (!extension_.empty() && count > 0)
        packed = compress(data, data.size() / count, target == index_target, extension_, root_, json);
    if (!packed.empty()) {
        OrderedJson& extension = json["extensions"][extension_];
        extension["buffer"] = buffer_;
        extension["byteOffset"] = offset_ + bytes_.size();
    }
    const std::span<const std::byte> stored = packed.empty() ? data : std::span<const std::byte>(packed);
    bytes_.insert(bytes_.end(), stored.begin(), stored.end());
    bytes_.resize((bytes_.size() + 3) / 4 * 4);
    return json;
}

std::uint32_t NewData::directions(std::span<const float> numbers, std::uint32_t width, ComponentType type) {
    const std::uint32_t size = width * size_of(type), stride = (size + 3) / 4 * 4;
    OrderedJson json = {{"componentType", int(type)}, {"count", numbers.size() / width}, {"type", type_name(width)}};
    if (type != ComponentType::f32) json["normalized"] = true;
    return accessor(stored_bytes(numbers, width, type, stride), stride == size ? 0 : stride, vertex_target,
                    std::move(json));
}

std::uint32_t NewData::numbers(std::span<const float> values, std::uint32_t width, bool bounds) {
    OrderedJson json = {
        {"componentType", int(ComponentType::f32)}, {"count", values.size() / width}, {"type", type_name(width)}};
    if (bounds) {
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        json["min"] = {*low}, json["max"] = {*high};
    }
    return accessor(bytes_of(values), 0, 0, std::move(json));
}

std::uint32_t NewData::indices(std::span<const std::uint32_t> values, ComponentType least) {
    // The largest value of a type means "restart" to some systems; glTF forbids it.
    const std::uint32_t largest = values.empty() ? 0 : *std::max_element(values.begin(), values.end());
    const ComponentType type = largest >= 0xFFFF || least == ComponentType::u32 ? ComponentType::u32
                               : largest >= 0xFF || least == ComponentType::u16 ? ComponentType::u16
                                                                                : ComponentType::u8;
    std::vector<std::byte> data = type == ComponentType::u32   ? bytes_of(values)
                                  : type == ComponentType::u16 ? narrowed<std::uint16_t>(values)
                                                               : narrowed<std::uint8_t>(values);
    return accessor(std::move(data), 0, index_target,
                    {{"componentType", int(type)}, {"count", values.size()}, {"type", "SCALAR"}});
}

std::uint32_t NewData::extended(const Elements& elements, std::span<const std::uint32_t> copied,
                                const OrderedJson& model) {
    const std::size_t size = elements.element_bytes(), stride = (size + 3) / 4 * 4, count = std::size_t(elements.count);
    std::vector<std::byte> data((count + copied.size()) * stride);
    const auto copy = [&](std::size_t to, std::size_t from) {
        if (elements.data) std::memcpy(data.data() + to * stride, elements.data + from * elements.stride, size);
    };
    for (std::size_t i = 0; i < count; ++i) copy(i, i);
    for (std::size_t i = 0; i < copied.size(); ++i) copy(count + i, copied[i]);
    OrderedJson description = model;
    for (const char* name : {"byteOffset", "sparse"}) description.erase(name);
    description["componentType"] = int(elements.type);
    description["count"] = count + copied.size();
    description["type"] = type_name(elements.components);
    return accessor(std::move(data), stride == size ? 0 : std::uint32_t(stride), vertex_target, std::move(description));
}

}  // namespace rakelight::io::gltf
