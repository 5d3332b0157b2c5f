// SPDX-License-Identifier: Apache-2.0
// Inside of movie/: one writer a format.
#pragma once
#include <optional>
#include <span>
#include <string>

#include <rakelight/base/context.h>

#include "io/movie/png_chunks.h"

namespace rakelight::io {

enum class MovieKind : std::uint8_t { apng, webp, gif, mp4, webm };
/// By the ending of its name, in any case.
std::optional<MovieKind> movie_kind(const std::string& path);

/// The pictures of a movie, which all have this header.
struct MoviePictures {
    std::span<const std::string> files;
    double fps;
    PngHeader header;
};

void write_apng(const std::string& path, const MoviePictures& pictures, Context& context);
void write_webp_movie(const std::string& path, const MoviePictures& pictures, Context& context);
/// @param kind  gif, mp4 or webm
void write_movie_by_ffmpeg(const std::string& path, MovieKind kind, const MoviePictures& pictures, Context& context);

}  // namespace rakelight::io
