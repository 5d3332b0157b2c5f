// SPDX-License-Identifier: Apache-2.0
// Names and data types of channels in files.
#pragma once
#include <cstdint>
#include <span>

namespace rakelight {

enum class ChannelKind : std::uint8_t {
    distance,
    direction,
    number,
    count,
    coordinates,
    position,
    weights,
    color,
    amount,
    share
};

struct ChannelInfo {
    std::uint32_t channel;  ///< one Channel bit
    const char* word;       ///< "face-normal": in options and file names
    const char* layer;      ///< "face_normal": in EXR files
    const char* parts;      ///< one letter per component, "XYZ": layer.X, layer.Y, layer.Z
    ChannelKind kind;

    int components() const;  ///< of four bytes: floats, or std::uint32_t if is_integer()
    bool is_integer() const { return kind == ChannelKind::number || kind == ChannelKind::count; }
};

/// All channels in the order of the bits.
std::span<const ChannelInfo> all_channels();
const ChannelInfo& info_of(std::uint32_t channel);

}  // namespace rakelight
