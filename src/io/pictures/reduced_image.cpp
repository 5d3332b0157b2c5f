// SPDX-License-Identifier: Apache-2.0
#include "io/pictures/reduced_image.h"

#include <algorithm>
#include <utility>

#include "base/assert.h"
#include "io/files/file.h"
#include "io/pictures/block_means.h"
#include "io/pictures/image_formats.h"
#include "io/pictures/image_io.h"

namespace rakelight::io {
namespace codec {
namespace {

/// The largest power of 2 that is needed, at most the one that leaves a pixel.
int factor_for(const Pixels& header, int most_side) {
    RL_ASSERT(most_side > 0, "a picture has a pixel a side at least");
    int factor = 1;
    while (divided_up(std::max(header.width, header.height), factor) > most_side) factor *= 2;
    return factor;
}

std::uint64_t pixels_of(const Pixels& header) { return std::uint64_t(header.width) * std::uint64_t(header.height); }

}  // namespace

Pixels read_reduced(std::span<const std::byte> bytes, int most_side, Want want, Context& context) {
    const ReadableFormat& format = readable_format(bytes);
    Pixels header = format.read(bytes, Want::header, context);
    const int factor = factor_for(header, most_side);
    if (factor == 1) return want == Want::header ? header : format.read(bytes, want, context);
    if (want == Want::header) {
        header.width = divided_up(header.width, factor), header.height = divided_up(header.height, factor);
        return header;
    }
    if (format.read_reduced) return format.read_reduced(bytes, factor, context);
    const Pixels whole = format.read(bytes, want, context);
    return block_means(
        whole, factor, [&whole](int y) { return whole.row(y); }, context);
}

std::uint64_t reduced_work(std::span<const std::byte> bytes, int most_side, Context& context) {
    const ReadableFormat& format = readable_format(bytes);
    const Pixels header = format.read(bytes, Want::header, context);
    const int factor = factor_for(header, most_side);
    const auto side = [factor](int size) { return std::uint64_t(divided_up(size, factor)); };
    const std::uint64_t reduced = side(header.width) * side(header.height);  // converted, and mip levels made
    if (format.work) return format.work(header, bytes, factor, context) + reduced;
    const std::uint64_t values = pixels_of(header) * std::uint64_t(header.channels);
    return (header.component == Component::u16 ? values : values / 3) + reduced;
}

}  // namespace codec

namespace {

using codec::Want;

template <Want want>
Pixels read_file_reduced(const EncodedImage& image, int most_side, Context& context) {
    try {
        const Bytes bytes = bytes_of(image, context, want == Want::pixels);
        context.throw_if_cancelled();
        return codec::read_reduced(*bytes, most_side, want, context);
    } catch (const Error& error) {
        throw named(error, image);
    }
}

}  // namespace

ImageHandle reduced_image(const ImageHandle& image, int most_side) {
    if (!is_of_file(*image)) return image;
    EncodedImage reduced = *image;
    reduced.decode = [most_side](const EncodedImage& i, Context& c) {
        return read_file_reduced<Want::pixels>(i, most_side, c);
    };
    reduced.measure = [most_side](const EncodedImage& i, Context& c) {
        return read_file_reduced<Want::header>(i, most_side, c);
    };
    return std::make_shared<const EncodedImage>(std::move(reduced));
}

std::uint64_t decoding_work(const EncodedImage& image, int most_side, Context& context) {
    if (!is_of_file(image)) return 0;
    try {
        return codec::reduced_work(*bytes_of(image, context, true), most_side, context);
    } catch (const Error&) {  // told when it is decoded
        context.throw_if_cancelled();
        return 0;
    }
}

bool has_alpha(const EncodedImage& image, Context& context) {
    if (!image.measure) return true;
    try {
        return image.measure(image, context).channels % 2 == 0;
    } catch (const Error&) {  // told when it is decoded
        context.throw_if_cancelled();
        return false;
    }
}

}  // namespace rakelight::io
