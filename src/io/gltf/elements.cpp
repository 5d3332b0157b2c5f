// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/elements.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

namespace rakelight::io::gltf {
namespace {

template <class Use>
void with_component_type(ComponentType type, Use use) {
    switch (type) {
        case ComponentType::i8:
            return use(std::int8_t{});
        case ComponentType::u8:
            return use(std::uint8_t{});
        case ComponentType::i16:
            return use(std::int16_t{});
        case ComponentType::u16:
            return use(std::uint16_t{});
        case ComponentType::u32:
            return use(std::uint32_t{});
        case ComponentType::f32:
            return use(float{});
    }
}

template <class T>
T load(const std::byte* from) {
    T value;
    std::memcpy(&value, from, sizeof value);
    return value;
}

template <class T>
float as_float(T value, bool normalized) {
    if constexpr (std::is_floating_point_v<T>) {
        return value;
    } else {
        if (!normalized) return float(value);
        const float unit = float(value) / float(std::numeric_limits<T>::max());
        return unit < -1.0f ? -1.0f : unit;  // -128 / 127
    }
}

bool is_packed_float(const Elements& e, std::uint32_t width) {
    return e.data && e.type == ComponentType::f32 && e.components == width && e.stride == e.element_bytes();
}

template <class Vec, std::uint32_t width>
std::vector<Vec> to_vectors(const Elements& elements, float missing) {
    static_assert(sizeof(Vec) == width * sizeof(float));
    std::vector<Vec> result(std::size_t(elements.count));
    if (!result.empty()) to_floats(elements, width, missing, &result[0].x);
    return result;
}

}  // namespace

void to_floats(const Elements& elements, std::uint32_t width, float missing, float* out) {
    const std::size_t count = std::size_t(elements.count);
    if (is_packed_float(elements, width)) {
        std::memcpy(out, elements.data, count * width * sizeof(float));
        return;
    }
    const std::uint32_t given = std::min(width, elements.components);
    with_component_type(elements.type, [&](auto kind) {
        using T = decltype(kind);
        for (std::size_t i = 0; i < count; ++i) {
            const std::byte* from = elements.data ? elements.data + i * elements.stride : nullptr;
            float* to = out + i * width;
            for (std::uint32_t c = 0; c < given; ++c)
                to[c] = from ? as_float(load<T>(from + c * sizeof(T)), elements.normalized) : 0.0f;
            for (std::uint32_t c = given; c < width; ++c) to[c] = missing;
        }
    });
}

std::vector<vec2> to_vec2(const Elements& elements) { return to_vectors<vec2, 2>(elements, 0); }
std::vector<vec3> to_vec3(const Elements& elements) { return to_vectors<vec3, 3>(elements, 0); }
std::vector<vec4> to_vec4(const Elements& elements, float missing_w) {
    return to_vectors<vec4, 4>(elements, missing_w);
}

std::vector<float> to_scalars(const Elements& elements) {
    std::vector<float> result(std::size_t(elements.count) * elements.components);
    if (!result.empty()) to_floats(elements, elements.components, 0, result.data());
    return result;
}

namespace {

constexpr int fewest_bits = 9;  // of codes that are taken to be meant with fewer bits than their type has

/// Whether a code is a number of fewer bits whose highest bits are repeated in the lowest: so all of 0..1 is reached.
bool repeats(unsigned code, int bits, int all) {
    const unsigned number = code >> (all - bits);
    return code == ((number << (all - bits)) | (number >> (2 * bits - all)));
}

/// Significant bits of all codes, without the sign. As many as the type has, if that codes of fewer bits are repeated
/// (see repeats()) could be chance: for each different code the chance is 2^(bits - all).
/// @param all  bits of the type without its sign
template <class T>
int significant_bits(const Elements& elements, int all) {
    int bits = fewest_bits;
    std::vector<bool> seen(std::size_t(std::numeric_limits<T>::max()) + 1);
    std::size_t different = 0;
    for (std::size_t i = 0; i < elements.count && bits < all; ++i)
        for (std::uint32_t c = 0; c < elements.components; ++c) {
            const int signed_code = load<T>(elements.data + i * elements.stride + c * sizeof(T));
            const auto code = std::min(unsigned(std::abs(signed_code)), unsigned(std::numeric_limits<T>::max()));
            if (seen[code]) continue;
            seen[code] = true;
            ++different;
            while (bits < all && !repeats(code, bits, all)) ++bits;
        }
    constexpr std::size_t enough = 24;  // a chance of 2^-22: 0 and the largest code always repeat
    return different >= 2 && (different - 2) * std::size_t(all - bits) + 2 >= enough ? bits : all;
}

}  // namespace

double step_of(const Elements& elements) {
    if (elements.type == ComponentType::f32) return 0;
    if (!elements.normalized) return 1;
    double step = 1;
    with_component_type(elements.type, [&](auto zero) {
        using T = decltype(zero);
        const double largest = double(std::numeric_limits<T>::max());
        step = 1 / largest;
        if constexpr (sizeof(T) == 2) {
            constexpr int all = std::numeric_limits<T>::digits;
            const int bits = elements.data ? significant_bits<T>(elements, all) : all;
            // Half a step of these bits, and what repeating them adds: less than one code.
            if (bits < all) step = ((1 << (all - bits)) + 2) / largest;
        }
    });
    return step;
}

std::vector<std::uint32_t> to_integers(const Elements& elements) {
    std::vector<std::uint32_t> result(std::size_t(elements.count) * elements.components);
    if (!elements.data) return result;
    with_component_type(elements.type, [&](auto kind) {
        using T = decltype(kind);
        if constexpr (std::is_unsigned_v<T>) {
            std::size_t k = 0;
            for (std::size_t i = 0; i < elements.count; ++i)
                for (std::uint32_t c = 0; c < elements.components; ++c)
                    result[k++] = load<T>(elements.data + i * elements.stride + c * sizeof(T));
        }
    });
    return result;
}

}  // namespace rakelight::io::gltf
