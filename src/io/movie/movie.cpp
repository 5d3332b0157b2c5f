// SPDX-License-Identifier: Apache-2.0
// Which writer a movie gets, and what is wrong with one before it is begun.
#include <algorithm>
#include <array>
#include <cmath>

#include <rakelight/io/movie.h>
#include <rakelight_internal/base/file_ending.h>

#include "base/format_text.h"
#include "io/files/made_folders.h"
#include "io/movie/ffmpeg_process.h"
#include "io/movie/movie_formats.h"
#include "io/pictures/whole_picture.h"

namespace rakelight {
namespace io {
namespace {

constexpr std::array formats{&apng_movie, &webp_movie, &gif_movie, &mp4_movie, &webm_movie};

/// By the ending of a name, in any case. Null: no movie has it.
const MovieFormat* find_format(const std::string& path) {
    const std::string ending = file_ending(path);
    for (const MovieFormat* const format : formats)
        if (format->ending == ending) return format;
    return nullptr;
}

/// All pictures have the first one's header, and none is damaged; their data are read again later, one by one.
PngHeader common_header(std::span<const std::string> pictures, Context& context) {
    std::vector<PngHeader> all(pictures.size());
    const auto faults = faults_of_pictures(
        pictures.size(), [&](std::size_t i) { all[i] = header_of_whole_png(pictures[i], context); }, context);
    const PngHeader& first = all[0];
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        if (faults[i]) throw *faults[i];
        if (!(all[i] == first))
            throw Error(ErrorCode::bad_file, "has another size or kind of color than the movie's first picture")
                .with_file(pictures[i]);
    }
    if (first.bit_depth != 8 || first.color_type == 3 || first.interlace != 0)
        throw Error(ErrorCode::bad_file, "movies are made of plain PNG pictures of 8 bits").with_file(pictures[0]);
    return first;
}

}  // namespace

}  // namespace io

bool is_movie(const std::string& path) { return io::find_format(path) != nullptr; }

void check_movie(const std::string& path, const MovieSize& size) {
    const io::MovieFormat* const format = io::find_format(path);
    if (!format)
        throw Error(ErrorCode::usage, "no movie has this ending", {}, "use .mp4, .webm, .gif, .apng or .webp")
            .with_file(path);
    if (!format->has_alpha && size.has_alpha)
        throw Error(ErrorCode::usage, "MP4 has no alpha", {}, "use .webm, .apng or .webp, or an opaque background")
            .with_file(path);
    if (std::max(size.width, size.height) > format->most_side)
        throw Error(ErrorCode::usage,
                    format_text("a movie of this kind has at most {} pixels per side", format->most_side))
            .with_file(path);
    try {
        if (format->is_by_ffmpeg) io::check_ffmpeg();
        io::check_output_place(path);
    } catch (const Error& error) {
        throw error.with_file(path);
    }
}

void write_movie(const std::string& path, std::span<const std::string> pictures, double fps, Context& context) {
    if (pictures.empty()) throw Error(ErrorCode::usage, "a movie needs a picture").with_file(path);
    if (!(fps >= 0.01 && fps <= 1000))
        throw Error(ErrorCode::usage, "frames per second must be 0.01 to 1000").with_file(path);
    check_movie(path, {});
    const io::MoviePictures all{pictures, fps, io::common_header(pictures, context)};
    check_movie(path, {int(all.header.width), int(all.header.height), all.header.has_alpha()});
    context.progress("movie", 0);
    io::find_format(path)->write(path, all, context);
}

}  // namespace rakelight
