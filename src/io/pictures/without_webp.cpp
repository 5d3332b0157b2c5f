// SPDX-License-Identifier: Apache-2.0
// Of a build without libwebp (RAKELIGHT_WEBP=OFF).
#include "base/left_out.h"
#include "io/movie/movie_formats.h"
#include "io/pictures/image_formats.h"

namespace rakelight::io {
namespace {

Error no_webp(ErrorCode code = ErrorCode::bad_file) {
    return left_out("WebP pictures", "libwebp", "RAKELIGHT_WEBP", code);
}

Pixels read_webp(std::span<const std::byte>, codec::Want, Context&) { throw no_webp(); }

std::unique_ptr<ImageWriter> write_webp(const OutputTarget& target, int, int, int, Component) {
    throw no_webp(ErrorCode::usage).with_file(target.path);
}

void write_webp_movie(const std::string& path, const MoviePictures&, Context&) {
    throw no_webp(ErrorCode::usage).with_file(path);
}

}  // namespace

const codec::ReadableFormat codec::readable_webp = {.read = read_webp};
const codec::WritableFormat codec::writable_webp = {.write = write_webp};
constinit const MovieFormat webp_movie = {.ending = "webp", .most_side = 16383, .write = write_webp_movie};

}  // namespace rakelight::io
