// SPDX-License-Identifier: Apache-2.0
// Attributes in and out of interleaved vertex buffers. compute_attributes() reads and writes packed arrays. The
// functions of this header copy between packed arrays and interleaved buffers. A copy takes little time compared with
// smoothing.
#pragma once
#include <cstddef>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace rakelight {

/// One attribute of an interleaved vertex buffer. Neither the address nor the stride has to be aligned.
/// `Byte` is const std::byte for a buffer that is only read.
template <class Byte>
struct InterleavedAttribute {
    std::span<Byte> buffer{};      ///< the whole buffer
    std::size_t offset = 0;        ///< [bytes] offset of the first vertex's attribute in the buffer
    std::size_t stride = 0;        ///< [bytes] from one vertex to the next; 0: packed, as in OpenGL
    std::size_t vertex_count = 0;  ///< vertices in the buffer

    /// [bytes] from one vertex to the next, for an attribute of `size` bytes.
    constexpr std::size_t step(std::size_t size) const { return stride == 0 ? size : stride; }
    /// Whether the attributes of all vertices, `size` bytes each, lie in the buffer and do not overlap.
    constexpr bool holds(std::size_t size) const {
        if (vertex_count == 0) return true;
        if (offset > buffer.size() || size > buffer.size() - offset) return false;
        return vertex_count == 1 ||
               (step(size) >= size && vertex_count - 1 <= (buffer.size() - offset - size) / step(size));
    }
};

/// A packed copy of an interleaved attribute.
/// @return [vertex_count]; empty if the buffer does not hold the attributes of all vertices
template <class T>
std::vector<T> packed(const InterleavedAttribute<const std::byte>& from) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (!from.holds(sizeof(T))) return {};
    std::vector<T> out(from.vertex_count);
    for (std::size_t v = 0; v < out.size(); ++v)
        std::memcpy(&out[v], from.buffer.data() + from.offset + v * from.step(sizeof(T)), sizeof(T));
    return out;
}

/// Writes a packed attribute into an interleaved buffer. All other bytes of the buffer stay.
/// @param values  [>= vertex_count]. Values beyond vertex_count are not written; for vertices that were split, enlarge
///        the buffer first
/// @return true: written. false: nothing was written, because the buffer or `values` has too few vertices
template <class T>
bool write_interleaved(std::span<const T> values, const InterleavedAttribute<std::byte>& to) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (!to.holds(sizeof(T)) || values.size() < to.vertex_count) return false;
    for (std::size_t v = 0; v < to.vertex_count; ++v)
        std::memcpy(to.buffer.data() + to.offset + v * to.step(sizeof(T)), &values[v], sizeof(T));
    return true;
}

}  // namespace rakelight
