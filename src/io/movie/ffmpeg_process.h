// SPDX-License-Identifier: Apache-2.0
// The program ffmpeg as a child process that is fed with the bytes of files.
#pragma once
#include <span>
#include <string>
#include <vector>

#include <rakelight/base/context.h>

namespace rakelight::io {

/// The names by which arguments call its files.
inline constexpr const char* ffmpeg_input = "pipe:0";
inline constexpr const char* ffmpeg_output = "file:/dev/fd/3";
inline constexpr const char* ffmpeg_second_input = "file:/dev/fd/4";

struct FfmpegRun {
    std::vector<std::string> arguments;     ///< behind the name of the program; no shell sees them
    std::span<const std::string> pictures;  ///< go to `ffmpeg_input`, one behind the other
    int output = -1;                        ///< descriptor of a file that can be sought in
    int second_input = -1;                  ///< likewise; -1: none
    double progress_from = 0, progress_to = 1;
};

/// @throws Error failed: it is not installed
void check_ffmpeg();

/// Runs it to its end. It is killed where the context is cancelled.
/// @throws Error failed: it is not installed; its own words, where it fails; cancelled; not_found: a picture
void run_ffmpeg(const FfmpegRun& run, Context& context);

}  // namespace rakelight::io
