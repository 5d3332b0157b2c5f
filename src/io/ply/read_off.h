// SPDX-License-Identifier: Apache-2.0
// OFF text -> scene: vertices and faces, each with a color of its own.
#pragma once
#include <string_view>

#include "io/reader.h"

namespace rakelight::io {

namespace ply {

/// One line a vertex: x y z, and with the letters of the header nx ny nz (N), red green blue alpha (C), s t (ST). One line a face: how
/// many corners, their numbers, and maybe a color of 3 or 4 numbers, 0..1 or 0..255. Colors of vertices go before those of faces.
/// @throws Error bad_file, with the line
Scene read_off_text(std::string_view bytes, const std::string& path, Context& context);

}  // namespace ply

}  // namespace rakelight::io
