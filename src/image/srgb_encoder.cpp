// SPDX-License-Identifier: Apache-2.0
#include "image/srgb_encoder.h"

#include "base/assert.h"
#include "math/color.h"

namespace rakelight {
namespace {

/// The bits of the smallest float whose code is at least `code`, 1..255. Bisection over the bit patterns of positive
/// floats, which are ordered like their values.
std::uint32_t first_bits_of(std::uint32_t code, std::uint32_t above) {
    std::uint32_t below = std::bit_cast<std::uint32_t>(linear_from_srgb((float(code) - 0.75f) / 255.0f));
    while (below + 1 < above) {
        const std::uint32_t middle = below + (above - below) / 2;
        (srgb8_from_linear(std::bit_cast<float>(middle)) >= code ? above : below) = middle;
    }
    return above;
}

}  // namespace

const SrgbEncoder& SrgbEncoder::instance() {
    static const SrgbEncoder encoder;
    return encoder;
}

SrgbEncoder::SrgbEncoder() {
    constexpr std::uint32_t bucket = 1u << srgb_bucket_bits;
    table_.fill(0);
    for (std::uint32_t code = 1; code <= 255; ++code) {
        const std::uint32_t hint = std::bit_cast<std::uint32_t>(linear_from_srgb((float(code) - 0.25f) / 255.0f));
        const std::uint32_t above = first_bits_of(code, hint);
        std::uint32_t& entry = table_[above >> srgb_bucket_bits];
        RL_ASSERT(entry == 0, "two steps in one bucket");
        entry = bucket - (above & (bucket - 1));
    }
    std::uint32_t code = 0;
    for (std::uint32_t& entry : table_) {
        const bool has_step = entry != 0;
        entry += code << srgb_bucket_bits;
        code += has_step ? 1 : 0;
    }
}

}  // namespace rakelight
