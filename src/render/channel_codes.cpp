// SPDX-License-Identifier: Apache-2.0
#include <rakelight/picture.h>

#include <cstring>

#include "engines/channel_arrays.h"
#include "render/channel_view.h"

namespace rakelight {
namespace {

/// The words of a channel, as view_row() takes them.
std::vector<std::uint32_t> words_of(const Frame& frame, std::uint32_t channel) {
    std::vector<std::uint32_t> words;
    for_each_channel(
        [&](std::uint32_t bit, const auto& values) {
            if (bit != channel || values.empty()) return;
            words.resize(values.size() * sizeof(values[0]) / sizeof words[0]);
            std::memcpy(words.data(), values.data(), words.size() * sizeof words[0]);
        },
        static_cast<const ChannelArrays&>(frame));
    return words;
}

}  // namespace

std::vector<std::uint32_t> channel_codes(const Frame& frame, std::uint32_t channel, const ChannelRange& range) {
    const bool is_one =
        channel != 0 && (channel & (channel - 1)) == 0 && (channel & ~(channels_all | channel_ambient_occlusion)) == 0;
    const std::vector<std::uint32_t> words = is_one ? words_of(frame, channel) : std::vector<std::uint32_t>();
    const std::size_t count = std::size_t(frame.window.width) * std::size_t(frame.window.height);
    if (!is_one || words.size() != count * std::size_t(info_of(channel).components()))
        throw Error(ErrorCode::usage, "the frame has no such channel");
    std::vector<std::uint8_t> rgb(3 * count);
    view_row(info_of(channel), range, words.data(), count, rgb.data());
    std::vector<std::uint32_t> codes(count);
    for (std::size_t i = 0; i < count; ++i)
        codes[i] = 0xff000000u | std::uint32_t(rgb[3 * i]) | std::uint32_t(rgb[3 * i + 1]) << 8 |
                   std::uint32_t(rgb[3 * i + 2]) << 16;
    return codes;
}

std::vector<std::string> channel_words() {
    std::vector<std::string> words;
    for (const ChannelInfo& channel : all_channels()) words.emplace_back(channel.word);
    return words;
}

}  // namespace rakelight
