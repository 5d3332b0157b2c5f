// SPDX-License-Identifier: Apache-2.0
// The formats of movies. Each is one constant, which the source of the format defines; the table in movie.cpp lists them.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include <rakelight/base/context.h>

#include "io/movie/png_chunks.h"

namespace rakelight::io {

/// The pictures of a movie, which all have this header.
struct MoviePictures {
    std::span<const std::string> files;
    double fps;
    PngHeader header;
};

struct MovieFormat {
    std::string_view ending;  ///< of the file's name, in lower case
    int most_side;            ///< [px]
    void (*write)(const std::string& path, const MoviePictures& pictures, Context& context);
    bool has_alpha = true;
    bool is_by_ffmpeg = false;  ///< the program must be installed
};
extern const MovieFormat apng_movie, webp_movie, gif_movie, mp4_movie, webm_movie;

}  // namespace rakelight::io
