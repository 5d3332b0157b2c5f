// SPDX-License-Identifier: Apache-2.0
#include "render/output/picture_target.h"

namespace rakelight {

PixelFormat FileTarget::format(const RenderSettings& settings) const {
    return format_for(output_, settings.background.w < 1);
}

void FileTarget::open(const RenderSettings& settings, const ChannelRange& range, Context&) {
    const Window window = whole_window(settings);
    files_.emplace(output_, window.width, window.height, format(settings),
                   ChannelWishes{settings.channels, channel_files_, half_colors_, range, comment_of(settings), memory_},
                   place_of(settings));
}

std::vector<std::string> FileTarget::finish() {
    files_->finish();
    return files_->channel_names();
}

PixelFormat PixelsTarget::format(const RenderSettings& settings) const {
    return {Component::u8, settings.background.w < 1 ? 4 : 3};
}

void PixelsTarget::open(const RenderSettings& settings, const ChannelRange&, Context& context) {
    const Window window = whole_window(settings);
    const PixelFormat format = this->format(settings);
    pixels_ = {window.width, window.height, format.channels, format.component, false, {}};
    pixels_.charge = share(MemoryCharge(
        context.memory(), std::uint64_t(pixels_.row_bytes()) * std::uint64_t(window.height), "the picture"));
}

}  // namespace rakelight
