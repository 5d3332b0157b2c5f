// SPDX-License-Identifier: Apache-2.0
// Movies of numbered PNG files: APNG and WebP by the library itself, MP4, WebM and GIF by the program ffmpeg.
#pragma once
#include <span>
#include <string>

#include <rakelight/context.h>
#include <rakelight/export.h>

namespace rakelight {

/// Whether a name ends as one of a movie: .mp4, .webm, .gif, .apng, .webp (which may be a picture, too).
RL_API bool is_movie(const std::string& path);

/// What is to become a movie.
struct MovieSize {
    int width = 0, height = 0;  ///< [px]
    bool has_alpha = false;     ///< pixels may be transparent
};
/// Says what is wrong with a movie before there are pictures of it. @throws Error usage: no ending of a movie, MP4 with alpha, a size
/// that the format does not have
RL_API void check_movie(const std::string& path, const MovieSize& size);

/// Writes a movie of 8-bit PNG files that have one size and color type, each shown for 1 / fps seconds; APNG, WebP and GIF begin
/// anew at their end. It appears whole or not at all. The same pictures give the same bytes, with one version of the encoder.
/// APNG: the pictures' own compressed data. WebP: without loss. MP4: H.264, an odd side gets its last pixels twice. WebM: VP9.
/// @param fps  pictures a second, 0.01..1000
/// @throws Error usage: as check_movie(), no pictures; not_found, bad_file: of the pictures, with the name; failed: ffmpeg is not
///         there or fails, the movie cannot be written
RL_API void write_movie(const std::string& path, std::span<const std::string> pictures, double fps, Context& context);

}  // namespace rakelight
