// SPDX-License-Identifier: Apache-2.0
// Of a build without libwebp (RAKELIGHT_WEBP=OFF).
#include "base/left_out.h"
#include "io/movie/movie_writers.h"
#include "io/pictures/image_codecs.h"

namespace rakelight::io {
namespace {

Error no_webp(ErrorCode code = ErrorCode::bad_file) {
    return left_out("WebP pictures", "libwebp", "RAKELIGHT_WEBP", code);
}

}  // namespace

Pixels codec::read_webp(std::span<const std::byte>, Want, Context&) { throw no_webp(); }

bool codec::is_lossless_webp(std::span<const std::byte>) { return false; }

std::unique_ptr<ImageWriter> codec::write_webp(const OutputTarget& target, int, int, int, Component) {
    throw no_webp(ErrorCode::usage).with_file(target.path);
}

void write_webp_movie(const std::string& path, const MoviePictures&, Context&) {
    throw no_webp(ErrorCode::usage).with_file(path);
}

}  // namespace rakelight::io
