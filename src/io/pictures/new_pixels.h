// SPDX-License-Identifier: Apache-2.0
// Room for a picture that is about to be decoded.
#pragma once
#include <cstdint>
#include <string>

#include <rakelight/base/context.h>
#include <rakelight/image/image.h>

namespace rakelight::io::codec {

inline constexpr std::uint32_t max_side = 32768;  ///< [px] the largest picture side that is read

/// What a reader returns: the pixels, or only what the header tells of them (Pixels without bytes).
enum class Want : std::uint8_t { pixels, header };

/// Memory for a picture, after its size was checked against `max_side` and the memory budget; none if only the header
/// is wanted.
/// @throws Error bad_file: no pixels, too large
Pixels make_pixels(std::uint64_t width, std::uint64_t height, int channels, Component component, Want want,
                   Context& context);

[[noreturn]] void bad_picture(const std::string& reason, const std::string& advice = {});

}  // namespace rakelight::io::codec
