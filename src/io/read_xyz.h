// SPDX-License-Identifier: Apache-2.0
// Points as lines of numbers (.xyz, .pts) -> scene.
#pragma once
#include <string_view>

#include "io/reader.h"

namespace rakelight::io {

/// One line per point: x y z, then other columns that are recognized by the values of the whole file. These are a
/// normal (three of length 1), a color (three from 0 to 255, or to 1), an intensity (a single one). A first line of one
/// number is the count that PTS files begin with. Numbers are separated by blanks, commas or semicolons; lines that
/// begin with '#' or '//' are comments.
/// @throws Error bad_file: a line that is none, with its number
Scene read_xyz_text(std::string_view text, const std::string& path, Context& context);

}  // namespace rakelight::io
