// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/accessors.h"

#include <cstring>

#include "base/format_text.h"

namespace rakelight::io::gltf {
namespace {

/// Elements without bytes behind them (an accessor without a view is all zeros) that a file may ask for.
constexpr std::uint64_t max_invented_bytes = 64u << 20;

ComponentType component_type(const Value& part) {
    const std::uint64_t type = part.required_count("componentType");
    if (type < 5120 || type > 5126 || type == 5124) part.fail(format_text("componentType {} is unknown", type));
    return ComponentType(type);
}

std::uint32_t components_of(const Value& accessor) {
    const std::string type = accessor.text("type");
    if (type == "SCALAR") return 1;
    if (type == "VEC2") return 2;
    if (type == "VEC3") return 3;
    if (type == "VEC4") return 4;
    if (type == "MAT4") return 16;
    accessor.fail("its type '" + one_line(type, 20) + "' is not one that can be used here");
}

/// True when `count` elements fit in `available` bytes from `offset` on; nothing can overflow: count and offset are at
/// most 2^53 by Value, stride is 32-bit, so the division form is used throughout.
bool fits(std::uint64_t count, std::uint64_t offset, std::uint32_t stride, std::uint32_t element_bytes,
          std::uint64_t available) {
    if (count == 0) return offset <= available;
    if (offset > available || element_bytes > available - offset) return false;
    return count - 1 <= (available - offset - element_bytes) / stride;
}

[[noreturn]] void fail_past_end(const Value& part, std::uint64_t count, std::uint64_t offset,
                                std::uint32_t element_bytes, std::uint64_t available) {
    part.fail(
        format_text("reads past the end of its bufferView ({} elements of {} bytes from byte {}, the view has {})",
                    count, element_bytes, offset, available));
}

}  // namespace

Elements Accessors::description(std::uint32_t index, const Expected& expected, const Value& from) const {
    const Value accessor = document_.element(accessor_kind, index, from);
    Elements elements;
    elements.count = accessor.required_count("count");
    elements.type = component_type(accessor);
    elements.components = components_of(accessor);
    elements.normalized = accessor.boolean("normalized", false);
    elements.stride = elements.element_bytes();
    if (!(expected.components >> elements.components & 1u))
        accessor.fail("its type '" + accessor.text("type") + "' cannot be used as " + expected.use);
    if (!(expected.types & type_bit(elements.type)))
        accessor.fail(format_text("its componentType {} cannot be used as {}", unsigned(elements.type), expected.use));
    return elements;
}

Elements Accessors::elements(std::uint32_t index, const Expected& expected, const Value& from) {
    Elements elements = description(index, expected, from);
    const Value accessor = document_.element(accessor_kind, index, from);
    attach_view(elements, accessor);
    if (const Value sparse = accessor.object("sparse")) apply_sparse(elements, accessor, sparse);
    return elements;
}

void Accessors::attach_view(Elements& elements, const Value& accessor) {
    const std::uint32_t bytes = elements.element_bytes();
    const std::uint32_t view_index = accessor.index("bufferView");
    if (view_index == no_index) {
        if (elements.count > max_invented_bytes / bytes)
            accessor.fail(format_text("it has no bufferView; {} zeros are too many", elements.count));
        return;
    }
    const Region region = buffers_.view(view_index, accessor);
    const std::uint64_t offset = accessor.count("byteOffset", 0);
    if (region.stride != 0) elements.stride = region.stride;
    if (elements.stride < bytes)
        accessor.fail(format_text("the byteStride {} of its bufferView is less than its elements' {} bytes",
                                  elements.stride, bytes));
    if (!fits(elements.count, offset, elements.stride, bytes, region.bytes.size()))
        fail_past_end(accessor, elements.count, offset, bytes, region.bytes.size());
    elements.data = region.bytes.data() + offset;
    elements.owner = region.owner;
}

void Accessors::apply_sparse(Elements& elements, const Value& accessor, const Value& sparse) {
    // 1. the replacements, checked
    const std::uint64_t count = sparse.required_count("count");
    if (count > elements.count)
        accessor.fail(format_text("sparse.count {} is more than its count {}", count, elements.count));
    const Value at = sparse.object("indices"), with = sparse.object("values");
    if (!at || !with) accessor.fail("sparse has no indices or no values");
    Elements indices;
    indices.count = count;
    indices.type = component_type(at);
    if (!(unsigned_types & type_bit(indices.type))) accessor.fail("sparse.indices must be unsigned integers");
    indices.stride = indices.element_bytes();
    const Region index_bytes = buffers_.view(at.required_index("bufferView"), accessor);
    const Region value_bytes = buffers_.view(with.required_index("bufferView"), accessor);
    const std::uint64_t index_offset = at.count("byteOffset", 0), value_offset = with.count("byteOffset", 0);
    const std::uint32_t bytes = elements.element_bytes();
    if (!fits(count, index_offset, indices.stride, indices.stride, index_bytes.bytes.size()))
        fail_past_end(accessor, count, index_offset, indices.stride, index_bytes.bytes.size());
    if (!fits(count, value_offset, bytes, bytes, value_bytes.bytes.size()))
        fail_past_end(accessor, count, value_offset, bytes, value_bytes.bytes.size());
    indices.data = index_bytes.bytes.data() + index_offset;

    // 2. a packed copy of the base, or zeros
    MemoryBudget& memory = document_.context().memory();
    memory.check(elements.count * bytes + count * 4, "a sparse accessor");
    MemoryCharge charge(memory, elements.count * bytes, "a sparse accessor");
    std::vector<std::byte> packed(std::size_t(elements.count * bytes));
    if (elements.data)
        for (std::uint64_t i = 0; i < elements.count; ++i)
            std::memcpy(packed.data() + i * bytes, elements.data + i * elements.stride, bytes);

    // 3. replace
    std::uint64_t least = 0;
    const std::vector<std::uint32_t> targets = to_integers(indices);
    for (std::size_t k = 0; k < targets.size(); ++k) {
        if (targets[k] < least || targets[k] >= elements.count)
            accessor.fail(format_text("sparse index {} at {} does not ascend or exceeds the count {}", targets[k], k,
                                      elements.count));
        least = std::uint64_t(targets[k]) + 1;
        std::memcpy(packed.data() + targets[k] * std::uint64_t(bytes),
                    value_bytes.bytes.data() + value_offset + k * bytes, bytes);
    }
    const Bytes replaced = charged_bytes(std::move(packed), std::move(charge));
    elements.data = replaced->data();
    elements.stride = bytes;
    elements.owner = replaced;
}

}  // namespace rakelight::io::gltf
