// SPDX-License-Identifier: Apache-2.0
// Pictures at a fraction of their size. The mean is that of code values, as JPEG's smaller transforms give it too: the
// mean of light would be brighter where dark and bright pixels alternate.
#include <algorithm>
#include <type_traits>

#include "base/assert.h"
#include "io/pictures/image_codecs.h"

namespace rakelight::io::codec {
namespace {

using RowAt = std::function<const std::byte*(int)>;

int divided_up(int size, int factor) { return (size + factor - 1) / factor; }

/// The largest power of 2 that is needed, at most the one that leaves a pixel.
int factor_for(const Pixels& header, int most_side) {
    RL_ASSERT(most_side > 0, "a picture has a pixel a side at least");
    int factor = 1;
    while (divided_up(std::max(header.width, header.height), factor) > most_side) factor *= 2;
    return factor;
}

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

std::uint64_t pixels_of(const Pixels& header) { return std::uint64_t(header.width) * std::uint64_t(header.height); }

// Measured with 2048 x 2048 pixels of a smooth picture with noise (AMD EPYC with AVX-512), where a pixel of the PNG file
// with 3 x 8 bits takes 16 ns: PNG with 16 bits 0.6 to 1 a value, WebP 0.6 and 1.4 (lossless) a pixel, HDR 1.5, TGA and BMP
// 0.7 to 1, JPEG 0.1 to 0.2 (one scan) and 0.5 (several), EXR with zip or piz 0.6 to 1.3 a half and 2.2 to 2.6 a float.
std::uint64_t work_of_format(PictureReader reader, const Pixels& header, std::span<const std::byte> bytes) {
    const std::uint64_t values = pixels_of(header) * std::uint64_t(header.channels);
    if (reader == read_webp) return is_lossless_webp(bytes) ? values / 2 : values / 4;
    if (reader == read_hdr) return values / 2;
    if (reader == read_exr) return (3 * values + 2 * bytes.size()) / 4;  // floats and further channels need more bytes
    return header.component == Component::u16 ? values : values / 3;
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

Pixels read_reduced(std::span<const std::byte> bytes, int most_side, Want want, Context& context) {
    const PictureReader reader = reader_of(bytes);
    Pixels header = reader(bytes, Want::header, context);
    const int factor = factor_for(header, most_side);
    if (factor == 1) return want == Want::header ? header : reader(bytes, want, context);
    if (want == Want::header) {
        header.width = divided_up(header.width, factor), header.height = divided_up(header.height, factor);
        return header;
    }
    if (reader == read_png) return read_reduced_png(bytes, factor, context);
    if (reader == read_jpeg) return read_reduced_jpeg(bytes, factor, context);
    const Pixels whole = reader(bytes, want, context);
    return block_means(
        whole, factor, [&whole](int y) { return whole.row(y); }, context);
}

std::uint64_t reduced_work(std::span<const std::byte> bytes, int most_side, Context& context) {
    const PictureReader reader = reader_of(bytes);
    const Pixels header = reader(bytes, Want::header, context);
    const int factor = factor_for(header, most_side);
    const auto side = [factor](int size) { return std::uint64_t(divided_up(size, factor)); };
    const std::uint64_t reduced = side(header.width) * side(header.height);  // converted, and mip levels made
    if (reader == read_jpeg && has_several_scans(bytes, context)) return pixels_of(header) + reduced;
    if (reader == read_jpeg) return pixels_of(header) / (factor > 1 ? 4 : 2) + reduced;
    return work_of_format(reader, header, bytes) + reduced;
}

}  // namespace rakelight::io::codec
