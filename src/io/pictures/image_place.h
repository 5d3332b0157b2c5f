// SPDX-License-Identifier: Apache-2.0
// How the metadata of PNG and HDR files say that a picture is a window of a larger one: "432,210,240,180 of 960,720", as
// `--window` and `--resolution` have it. EXR has a data and a display window for that.
#pragma once
#include <string>
#include <string_view>

#include "io/files/output_file.h"

namespace rakelight::io {

/// The keyword of PNG's text chunk.
inline constexpr const char* png_window_keyword = "Window";

/// Empty: the file of that size is the whole picture.
std::string window_text(const ImagePlace& place, int width, int height);

/// @param width, height  [px] of the file
/// @throws Error bad_file: another text, or the window of a file of another size
ImagePlace place_of(std::string_view text, int width, int height);

}  // namespace rakelight::io
