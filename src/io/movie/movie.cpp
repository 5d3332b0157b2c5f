// SPDX-License-Identifier: Apache-2.0
// Which writer a movie gets, and what is wrong with one before it is begun.
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <programs/base/file_ending.h>
#include <rakelight/io/movie.h>

#include "base/format_text.h"
#include "io/files/output_place.h"
#include "io/movie/ffmpeg_process.h"
#include "io/movie/movie_writers.h"
#include "io/pictures/whole_picture.h"

namespace rakelight {
namespace io {
namespace {

struct Kind {
    std::string_view ending;
    MovieKind kind;
    int most_side;  ///< [px]
};
constexpr std::array<Kind, 5> kinds{{{"apng", MovieKind::apng, 65536},
                                     {"webp", MovieKind::webp, 16383},
                                     {"gif", MovieKind::gif, 65535},
                                     {"mp4", MovieKind::mp4, 16384},
                                     {"webm", MovieKind::webm, 16384}}};

const Kind* find_kind(const std::string& path) {
    const auto found = std::ranges::find(kinds, file_ending(path), &Kind::ending);
    return found == kinds.end() ? nullptr : &*found;
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

std::optional<MovieKind> movie_kind(const std::string& path) {
    const Kind* const kind = find_kind(path);
    return kind ? std::optional(kind->kind) : std::nullopt;
}

}  // namespace io

bool is_movie(const std::string& path) { return io::movie_kind(path).has_value(); }

void check_movie(const std::string& path, const MovieSize& size) {
    const io::Kind* const kind = io::find_kind(path);
    if (!kind)
        throw Error(ErrorCode::usage, "no movie has this ending", {}, "use .mp4, .webm, .gif, .apng or .webp")
            .with_file(path);
    if (kind->kind == io::MovieKind::mp4 && size.has_alpha)
        throw Error(ErrorCode::usage, "MP4 has no alpha", {}, "use .webm, .apng or .webp, or an opaque background")
            .with_file(path);
    if (std::max(size.width, size.height) > kind->most_side)
        throw Error(ErrorCode::usage,
                    format_text("a movie of this kind has at most {} pixels per side", kind->most_side))
            .with_file(path);
    const bool is_by_ffmpeg =
        kind->kind == io::MovieKind::gif || kind->kind == io::MovieKind::mp4 || kind->kind == io::MovieKind::webm;
    try {
        if (is_by_ffmpeg) io::check_ffmpeg();
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
    switch (const io::MovieKind kind = *io::movie_kind(path)) {
        case io::MovieKind::apng:
            return io::write_apng(path, all, context);
        case io::MovieKind::webp:
            return io::write_webp_movie(path, all, context);
        default:
            return io::write_movie_by_ffmpeg(path, kind, all, context);
    }
}

}  // namespace rakelight
