// SPDX-License-Identifier: Apache-2.0
// Of a build that starts no other programs (RAKELIGHT_PROCESSES=OFF).
#include "base/left_out.h"
#include "io/movie/ffmpeg_process.h"
#include "io/movie/movie_formats.h"

namespace rakelight::io {
namespace {

void write_with_ffmpeg(const std::string& path, const MoviePictures&, Context&) {
    throw left_out("movies of this format", "ffmpeg", "RAKELIGHT_PROCESSES", ErrorCode::usage).with_file(path);
}

}  // namespace

void check_ffmpeg() {
    throw left_out("movies of this format", "ffmpeg", "RAKELIGHT_PROCESSES", ErrorCode::usage);
}

constinit const MovieFormat gif_movie = {
    .ending = "gif", .most_side = 65535, .write = write_with_ffmpeg, .is_by_ffmpeg = true};
constinit const MovieFormat mp4_movie = {
    .ending = "mp4", .most_side = 16384, .write = write_with_ffmpeg, .has_alpha = false, .is_by_ffmpeg = true};
constinit const MovieFormat webm_movie = {
    .ending = "webm", .most_side = 16384, .write = write_with_ffmpeg, .is_by_ffmpeg = true};

}  // namespace rakelight::io
