// SPDX-License-Identifier: Apache-2.0
// Movies from PNG files. The library writes APNG and WebP itself, and MP4, WebM and GIF by the program ffmpeg.
#pragma once
#include <span>
#include <string>

#include <rakelight/context.h>
#include <rakelight/export.h>

namespace rakelight {

/// Whether a name has the ending of a movie: .mp4, .webm, .gif, .apng, .webp (which may also be a picture).
RL_API bool is_movie(const std::string& path);

/// Format of a movie's pictures.
struct MovieSize {
    int width = 0, height = 0;  ///< [px]
    bool has_alpha = false;     ///< some pixels may be transparent
};
/// Checks a movie before its pictures are drawn.
/// @throws Error usage: not a movie's ending, MP4 with alpha, a size that the format does not support
RL_API void check_movie(const std::string& path, const MovieSize& size);

/// Writes a movie of 8-bit PNG files of one size and color type, each shown for 1 / fps seconds. APNG, WebP and GIF
/// loop forever. The file appears complete or not at all. Equal pictures give equal bytes with one version of the
/// encoder. APNG: the compressed data of the pictures. WebP: lossless. MP4: H.264; odd sizes repeat the last row or
/// column. WebM: VP9.
/// @param fps pictures per second, 0.01..1000
/// @throws Error usage: as check_movie(), no pictures; not_found, bad_file: of the pictures, with the name; failed:
///         ffmpeg is missing or fails, the movie cannot be written
RL_API void write_movie(const std::string& path, std::span<const std::string> pictures, double fps, Context& context);

}  // namespace rakelight
