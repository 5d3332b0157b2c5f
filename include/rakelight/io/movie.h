// SPDX-License-Identifier: Apache-2.0
// Movies from PNG files. The library writes APNG and WebP itself, and MP4, WebM and GIF by the program ffmpeg.
#pragma once
#include <span>
#include <string>

#include <rakelight/base/context.h>
#include <rakelight/base/export.h>

namespace rakelight {

/// Whether a name has the ending of a movie: .mp4, .webm, .gif, .apng or .webp. A .webp file may also be a picture.
RL_API bool is_movie(const std::string& path);

/// Format of a movie's pictures.
struct MovieSize {
    int width = 0, height = 0;  ///< [px]
    bool has_alpha = false;     ///< some pixels may be transparent
};
/// Checks a movie before its pictures are drawn.
/// @throws Error usage: not a movie's ending, MP4 with alpha, a size that the format does not support
RL_API void check_movie(const std::string& path, const MovieSize& size);

/// Writes a movie from 8-bit PNG files. All files must have the same size and color type. Each picture is shown for
/// 1 / fps seconds. APNG, WebP and GIF loop forever. The file appears complete or not at all. The same pictures and the
/// same version of the encoder give the same bytes.
/// - APNG: has the compressed data of the PNG files.
/// - WebP: lossless.
/// - MP4: H.264. If a side has an odd number of pixels, the last row or column is repeated.
/// - WebM: VP9.
/// @param fps pictures per second, 0.01..1000
/// @throws Error usage: as check_movie(), no pictures; not_found, bad_file: a picture, with its name; failed: ffmpeg is
///         missing or fails, or the movie cannot be written
RL_API void write_movie(const std::string& path, std::span<const std::string> pictures, double fps, Context& context);

}  // namespace rakelight
