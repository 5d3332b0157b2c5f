// SPDX-License-Identifier: Apache-2.0
// Words on standard error: messages of one line each, and progress on a terminal. What the program says on standard
// output goes through here, too.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <rakelight/base/error.h>
#include <rakelight/base/report.h>
#include <rakelight/render/picture.h>

namespace rakelight::cli {

enum class Loudness { quiet, normal, verbose };

/// Clears the current line of a terminal.
inline constexpr const char* wipe_line = "\r\033[K";

/// The text with the settings that it quotes, 'camera-index', as options: --camera-index.
std::string with_options(std::string text, const std::vector<std::string>& settings);

/// The text of an error. Settings are called by their options: "--crease-angle: ...".
std::string text_of(const Error& error);

/// The line of print_error(), with what wipes a progress line on a terminal: for who may not call print_error().
std::string error_line(const Error& error);

/// The same for work that was cancelled. @param file  may be empty
std::string cancelled_line(const std::string& file);

/// "rakelight: error: FILE: PLACE: REASON; ADVICE". Errors are shown at any loudness.
void print_error(const Error& error);

/// One "rakelight: warning: ..." line a remark; at most 20 a file, then how many more there are. Notes only when
/// verbose.
void print_remarks(const Report& report, Loudness loudness);

/// "rakelight: ..." at Loudness::verbose.
void print_note(const std::string& text, Loudness loudness);
/// A line about the run, unless it is to be quiet.
void print_message(const std::string& text, Loudness loudness);

/// A picture in words: size, triangles, times.
std::string summary(const PictureResult& result);

/// Data on standard output, as it is. @throws Error failed when it cannot be written (a full disk, a closed pipe).
void print_data(const std::string& text);

/// Lines for people on standard output. Each goes through one_line(): no name of a file reaches a terminal raw.
void print_text(const std::string& text);

}  // namespace rakelight::cli
