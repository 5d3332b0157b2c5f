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

double step_of(const Elements& elements) {
    if (elements.type == ComponentType::f32) return 0;
    double largest = 1;
    with_component_type(elements.type,
                        [&](auto zero) { largest = double(std::numeric_limits<decltype(zero)>::max()); });
    return elements.normalized ? 1 / largest : 1;
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
