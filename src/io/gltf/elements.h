// SPDX-License-Identifier: Apache-2.0
// Typed elements in raw bytes, and their conversion to what a scene holds (glTF 2.0 specification, sections 3.6.2
// and 2.8).
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <rakelight/math/vector.h>

namespace rakelight::io::gltf {

/// The values are glTF's componentType.
enum class ComponentType : std::uint16_t { i8 = 5120, u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126 };

constexpr std::uint32_t size_of(ComponentType type) {
    return type == ComponentType::i8 || type == ComponentType::u8     ? 1
           : type == ComponentType::i16 || type == ComponentType::u16 ? 2
                                                                      : 4;
}

/// Elements whose bytes were checked to be there. Not aligned; a null `data` means that all are zero.
struct Elements {
    const std::byte* data = nullptr;
    std::uint64_t count = 0;
    std::uint32_t stride = 0;      ///< [bytes] from one element to the next
    std::uint32_t components = 1;  ///< 1..4 or 16
    ComponentType type = ComponentType::f32;
    bool normalized = false;  ///< integers stand for -1..1 or 0..1
    std::shared_ptr<const void> owner;
    std::uint32_t element_bytes() const { return components * size_of(type); }
};

/// Conversion to float, component by component: normalized integers by c / max and max(c / max, -1), others by value.
/// `out` has room for count * width floats; components that the elements lack become `missing`, surplus ones are left
/// out.
void to_floats(const Elements& elements, std::uint32_t width, float missing, float* out);

std::vector<vec2> to_vec2(const Elements& elements);
std::vector<vec3> to_vec3(const Elements& elements);
std::vector<vec4> to_vec4(const Elements& elements, float missing_w);  ///< w where the elements have 3 components
std::vector<float> to_scalars(const Elements& elements);               ///< [count * components]

/// Between two neighboring codes after conversion; 0 for floats. Normalized integers of 16 bits may be numbers of fewer bits: quantize()
/// of gltf-transform stores 14 bits so, the highest again in the lowest. Where all are, the step is that of these bits.
double step_of(const Elements& elements);

/// Unsigned integers as they are. Only for u8, u16, u32; [count * components].
std::vector<std::uint32_t> to_integers(const Elements& elements);

}  // namespace rakelight::io::gltf
