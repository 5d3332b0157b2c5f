// SPDX-License-Identifier: Apache-2.0
// The list of channels, for code that does the same with each: which bit belongs to which array, and what an array
// holds where there is no surface.
#pragma once
#include <limits>

#include <rakelight/engines/engine.h>

namespace rakelight {

/// Calls visit(bit, array, array, ...) with the same channel's array of each holder: Tile or ChannelArrays.
template <class Visit, class... Holders>
void for_each_channel(const Visit& visit, Holders&... of) {
    visit(channel_depth, of.depth...);
    visit(channel_normal, of.normal...);
    visit(channel_object, of.object...);
    visit(channel_material, of.material...);
    visit(channel_mesh, of.mesh...);
    visit(channel_triangle, of.triangle...);
    visit(channel_face_normal, of.face_normal...);
    visit(channel_tangent, of.tangent...);
    visit(channel_position, of.position...);
    visit(channel_barycentric, of.barycentric...);
    visit(channel_uv, of.uv...);
    visit(channel_uv1, of.uv1...);
    visit(channel_overdraw, of.overdraw...);
    visit(channel_base_color, of.base_color...);
    visit(channel_ambient, of.ambient...);
    visit(channel_diffuse, of.diffuse...);
    visit(channel_specular, of.specular...);
    visit(channel_emission, of.emission...);
    visit(channel_albedo, of.albedo...);
    visit(channel_direct, of.direct...);
    visit(channel_indirect, of.indirect...);
    visit(channel_variance, of.variance...);
    visit(channel_ambient_occlusion, of.ambient_occlusion...);
}

/// The value of a channel in the background.
template <class T>
T empty_value(std::uint32_t channel, const std::vector<T>&) {
    if constexpr (std::is_same_v<T, float>)
        return channel == channel_depth               ? std::numeric_limits<float>::infinity()
               : channel == channel_ambient_occlusion ? 1.0f
                                                      : 0.0f;
    if constexpr (std::is_same_v<T, std::uint32_t>) return channel == channel_overdraw ? 0u : no_index;
    return T{};
}

/// Makes the arrays of the requested channels, filled with their background values; empties the others.
inline void clear(ChannelArrays& arrays, std::uint32_t channels, std::size_t pixels) {
    for_each_channel(
        [&](std::uint32_t bit, auto& array) { array.assign(channels & bit ? pixels : 0, empty_value(bit, array)); },
        arrays);
}

}  // namespace rakelight
