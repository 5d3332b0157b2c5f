// SPDX-License-Identifier: Apache-2.0
#include "world/keys/channel_info.h"

#include <rakelight/engines/engine.h>

#include <array>
#include <bit>
#include <cstring>

#include <rakelight/scene/words.h>
#include <rakelight/world/request.h>

namespace rakelight {
namespace {

using enum ChannelKind;
constexpr std::array channels{
    ChannelInfo{channel_depth, "depth", "depth", "Z", distance},
    ChannelInfo{channel_normal, "normal", "normal", "XYZ", direction},
    ChannelInfo{channel_object, "object", "object", "I", number},
    ChannelInfo{channel_material, "material", "material", "I", number},
    ChannelInfo{channel_mesh, "mesh", "mesh", "I", number},
    ChannelInfo{channel_triangle, "triangle", "triangle", "I", number},
    ChannelInfo{channel_face_normal, "face-normal", "face_normal", "XYZ", direction},
    ChannelInfo{channel_tangent, "tangent", "tangent", "XYZW", direction},
    ChannelInfo{channel_position, "position", "position", "XYZ", position},
    ChannelInfo{channel_barycentric, "barycentric", "barycentric", "XYZ", weights},
    ChannelInfo{channel_uv, "uv", "uv", "UV", coordinates},
    ChannelInfo{channel_uv1, "uv1", "uv1", "UV", coordinates},
    ChannelInfo{channel_overdraw, "overdraw", "overdraw", "I", count},
    ChannelInfo{channel_base_color, "base-color", "base_color", "RGB", color},
    ChannelInfo{channel_ambient, "ambient", "ambient", "RGB", color},
    ChannelInfo{channel_diffuse, "diffuse", "diffuse", "RGB", color},
    ChannelInfo{channel_specular, "specular", "specular", "RGB", color},
    ChannelInfo{channel_emission, "emission", "emission", "RGB", color},
    ChannelInfo{channel_albedo, "albedo", "albedo", "RGB", color},
    ChannelInfo{channel_direct, "direct", "direct", "RGB", color},
    ChannelInfo{channel_indirect, "indirect", "indirect", "RGB", color},
    ChannelInfo{channel_variance, "variance", "variance", "Y", amount},
    ChannelInfo{channel_ambient_occlusion, "ambient-occlusion", "ambient_occlusion", "Y", share},
};

constexpr bool are_in_order() {
    for (std::size_t i = 0; i < channels.size(); ++i)
        if (channels[i].channel != 1u << i) return false;
    return (1u << channels.size()) - 1 == (channels_all | channels_of_paths | channel_ambient_occlusion);
}
static_assert(are_in_order());

}  // namespace

int ChannelInfo::components() const { return int(std::strlen(parts)); }

std::span<const ChannelInfo> all_channels() { return channels; }

const ChannelInfo& info_of(std::uint32_t channel) { return channels[std::size_t(std::countr_zero(channel))]; }

std::uint32_t channels_by_name(std::string_view name) {
    for (const ChannelInfo& c : channels)
        if (same_word(name, c.word)) return c.channel;
    if (same_word(name, "lighting")) return channels_lighting;
    if (same_word(name, "paths")) return channels_of_paths;
    if (same_word(name, "all")) return channels_all;
    if (same_word(name, "none")) return 0;
    std::string words;
    for (const ChannelInfo& c : channels) words += std::string(c.word) + ", ";
    throw Error(ErrorCode::usage, "unknown channel '" + one_line(std::string(name), 40) + "'", {},
                "use one of: " + words + "lighting, paths, all");
}

}  // namespace rakelight
