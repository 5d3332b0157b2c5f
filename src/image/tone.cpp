// SPDX-License-Identifier: Apache-2.0
#include "image/tone.h"

#include <cstring>

#include "base/assert.h"
#include "image/srgb_encoder.h"
#include "math/color.h"

namespace rakelight {
namespace {

/// NaN gives 0.
float clamp_unit(float v) { return v > 0 ? (v < 1 ? v : 1.0f) : 0.0f; }

}  // namespace

void to_srgb8(std::span<const vec4> linear, int channels, std::span<std::uint8_t> out) {
    RL_ASSERT((channels == 3 || channels == 4) && out.size() == linear.size() * std::size_t(channels),
              "wrong size of a row");
    const SrgbEncoder& encode = SrgbEncoder::instance();
    std::uint8_t* to = out.data();
    const vec4* previous = nullptr;
    for (const vec4& color : linear) {
        if (previous != nullptr && *previous == color) {  // most of a background
            std::memcpy(to, to - channels, std::size_t(channels));
            to += channels;
            continue;
        }
        previous = &color;
        to[0] = std::uint8_t(encode(color.x));
        to[1] = std::uint8_t(encode(color.y));
        to[2] = std::uint8_t(encode(color.z));
        if (channels == 4) to[3] = std::uint8_t(clamp_unit(color.w) * 255.0f + 0.5f);
        to += channels;
    }
}

}  // namespace rakelight
