// SPDX-License-Identifier: Apache-2.0
// Data channels as kernels give them (channel_planes.h), on the way into an engine's arrays.
#pragma once
#include <array>
#include <type_traits>

#include "cpu_shading/channel_planes.h"
#include "engines/channel_arrays.h"
#include "math/linear.h"

namespace rakelight::cpu_shading {

struct KernelChannel {
    std::uint32_t bit;
    std::int32_t plane, components;
};
inline constexpr std::array kernel_channels{KernelChannel{channel_position, plane_position, 3},
                                            KernelChannel{channel_barycentric, plane_barycentric, 3},
                                            KernelChannel{channel_uv, plane_uv, 2},
                                            KernelChannel{channel_uv1, plane_uv1, 2},
                                            KernelChannel{channel_tangent, plane_tangent, 4},
                                            KernelChannel{channel_base_color, plane_base_color, 3},
                                            KernelChannel{channel_ambient, plane_ambient, 3},
                                            KernelChannel{channel_diffuse, plane_diffuse, 3},
                                            KernelChannel{channel_specular, plane_specular, 3},
                                            KernelChannel{channel_emission, plane_emission, 3}};

/// Where a kernel writes the asked-for channels. @param values  [channel_planes][stride]
inline ChannelValues channel_values(std::uint32_t channels, float* values, std::size_t stride) {
    ChannelValues out{};
    out.needs_terms = (channels & channels_lighting) != 0;
    for (const KernelChannel& k : kernel_channels)
        for (std::int32_t c = 0; (channels & k.bit) && c < k.components; ++c)
            out.out[k.plane + c] = values + std::size_t(k.plane + c) * stride;
    return out;
}

/// From the planes of `count` points to their pixels. Positions leave the eye in double.
/// @param pixel_of  number of a point -> its pixel in the arrays
template <class PixelOf>
void take_channels(std::uint32_t channels, const float* values, std::size_t stride, std::size_t count, dvec3 eye,
                   const PixelOf& pixel_of, ChannelArrays& to) {
    const auto take = [&](const KernelChannel& k, auto& array) {
        for (std::int32_t c = 0; c < k.components; ++c)
            for (std::size_t i = 0; i < count; ++i)
                array[pixel_of(i)][std::size_t(c)] = values[std::size_t(k.plane + c) * stride + i];
    };
    for_each_channel(
        [&](std::uint32_t bit, auto& array) {
            using Value = std::remove_reference_t<decltype(array[0])>;
            if constexpr (!std::is_arithmetic_v<Value>)
                for (const KernelChannel& k : kernel_channels)
                    if (k.bit == bit && (channels & bit)) take(k, array);
        },
        to);
    for (std::size_t i = 0; i < count && (channels & channel_position); ++i) {
        vec3& p = to.position[pixel_of(i)];
        p = {float(eye.x + double(p.x)), float(eye.y + double(p.y)), float(eye.z + double(p.z))};
    }
}

}  // namespace rakelight::cpu_shading
