// SPDX-License-Identifier: Apache-2.0
// The mean is that of code values, as JPEG's smaller transforms give it too: the mean of light would be brighter where
// dark and bright pixels alternate.
#include "io/pictures/block_means.h"

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "io/pictures/new_pixels.h"

namespace rakelight::io::codec {
namespace {

using RowAt = std::function<const std::byte*(int)>;

template <class Value, class Sum>
Value mean(Sum sum, Sum count) {
    if constexpr (std::is_floating_point_v<Sum>) return sum / count;
    return Value((sum + count / 2) / count);
}

/// @tparam Sum  holds the sum of factor * factor values
template <class Value, class Sum>
void put_means(const Pixels& whole, int factor, const RowAt& row_at, Pixels& to, Context& context) {
    const std::size_t channels = std::size_t(whole.channels), size = std::size_t(whole.width) * channels;
    std::vector<Sum> sums(size);
    for (int y = 0; y < to.height; ++y) {
        context.throw_if_cancelled();
        std::ranges::fill(sums, Sum(0));
        const int rows = std::min(factor, whole.height - y * factor);
        for (int i = 0; i < rows; ++i) {
            const auto* const from = reinterpret_cast<const Value*>(row_at(y * factor + i));
            for (std::size_t k = 0; k < size; ++k) sums[k] += from[k];
        }
        auto* out = reinterpret_cast<Value*>(to.row(y));
        for (int x = 0; x < whole.width; x += factor) {
            const int columns = std::min(factor, whole.width - x);
            for (std::size_t c = 0; c < channels; ++c, ++out) {
                Sum sum = 0;
                for (int i = 0; i < columns; ++i) sum += sums[std::size_t(x + i) * channels + c];
                *out = mean<Value>(sum, Sum(columns * rows));
            }
        }
    }
}

}  // namespace

Pixels block_means(const Pixels& header, int factor, const RowAt& row_at, Context& context) {
    const auto side = [factor](int size) { return std::uint64_t(divided_up(size, factor)); };
    Pixels to =
        make_pixels(side(header.width), side(header.height), header.channels, header.component, Want::pixels, context);
    to.is_linear = header.is_linear, to.is_tagged_srgb = header.is_tagged_srgb;
    if (header.component == Component::u8) put_means<std::uint8_t, std::uint32_t>(header, factor, row_at, to, context);
    if (header.component == Component::u16)
        put_means<std::uint16_t, std::uint64_t>(header, factor, row_at, to, context);
    if (header.component == Component::f32) put_means<float, float>(header, factor, row_at, to, context);
    return to;
}

}  // namespace rakelight::io::codec
