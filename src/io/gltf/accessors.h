// SPDX-License-Identifier: Apache-2.0
// Accessors: checked elements over buffer views, with sparse replacements applied.
#pragma once
#include "io/gltf/buffers.h"
#include "io/gltf/elements.h"

namespace rakelight::io::gltf {

/// Which element shapes and component types a use of an accessor allows, and what it is called in messages.
struct Expected {
    const char* use;           ///< "POSITION"
    std::uint32_t components;  ///< bit n: n components are fine (16: a 4 x 4 matrix, bit 16)
    std::uint32_t types;       ///< bit (componentType - 5120)
};

constexpr std::uint32_t components(std::uint32_t n) { return 1u << n; }
constexpr std::uint32_t type_bit(ComponentType type) { return 1u << (unsigned(type) - 5120u); }
inline constexpr std::uint32_t float_only = type_bit(ComponentType::f32);
inline constexpr std::uint32_t unsigned_types =
    type_bit(ComponentType::u8) | type_bit(ComponentType::u16) | type_bit(ComponentType::u32);
/// Float, and the integers of 8 and 16 bits (by value or normalized; KHR_mesh_quantization).
inline constexpr std::uint32_t float_or_small = float_only | type_bit(ComponentType::i8) | type_bit(ComponentType::u8) |
                                                type_bit(ComponentType::i16) | type_bit(ComponentType::u16);

class Accessors {
public:
    Accessors(const Document& document, Buffers& buffers) : document_(document), buffers_(buffers) {}

    /// @throws Error bad_file: no such accessor, not of the expected kind, too small a stride, past the end of its
    /// view,
    ///         sparse indices that do not ascend or exceed the count.
    Elements elements(std::uint32_t index, const Expected& expected, const Value& from);

    /// What the accessor says without touching its data (compressed primitives have none).
    Elements description(std::uint32_t index, const Expected& expected, const Value& from) const;

    const Document& document() const { return document_; }
    Buffers& buffers() { return buffers_; }

private:
    void attach_view(Elements& elements, const Value& accessor);
    void apply_sparse(Elements& elements, const Value& accessor, const Value& sparse);
    const Document& document_;
    Buffers& buffers_;
};

}  // namespace rakelight::io::gltf
