// SPDX-License-Identifier: Apache-2.0
// Data channels as pictures to look at.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <rakelight/base/export.h>
#include <rakelight/engines/sink.h>
#include <rakelight/scene/scene.h>
#include <rakelight/scene/scene_queries.h>

namespace rakelight {

/// Data channels (depth, position and so on) can be written as PNG files (channel_files_png). These files show depth
/// with a gray scale, and position with a color scale. ChannelRange has the values at the ends of both scales. They are
/// computed from the bounding box of the whole model. So all windows of a picture get the same values. (A window is a
/// part of the picture that is rendered separately.)
struct ChannelRange {
    double depth_low = 0, depth_high = 0;  ///< [m] along the view axis, clipped to the camera's near and far
    dvec3 low{}, high{};                   ///< [m] world
};

/// The value of PictureResult::channel_range.
/// @param camera  result of choose_camera()
RL_API ChannelRange channel_range_of(const Bounds& bounds, const Camera& camera);

/// A channel of a frame as display values, as in PNG files of channels: [width * height of the frame's window] sRGB
/// codes, R in the low byte.
/// @param channel  one Channel bit
/// @throws Error usage: the frame has no such channel
RL_API std::vector<std::uint32_t> channel_codes(const Frame& frame, std::uint32_t channel, const ChannelRange& range);

/// The words of --channels, in the order of the Channel bits.
RL_API std::vector<std::string> channel_words();

}  // namespace rakelight
