// SPDX-License-Identifier: Apache-2.0
// The text of an OBJ file. obj_reader (io/model_readers.h) does this with a file.
#pragma once
#include <string>
#include <string_view>

#include "io/obj/obj_lines.h"
#include "io/reader.h"

namespace rakelight::io::obj {

/// @param text  the whole file
/// @param path  of the file, for messages and for the folder in which material files and textures are looked for
/// @param chunk_bytes  what threads take at once; nothing but speed depends on it
/// @throws Error bad_file, with the file's name
Scene read_obj_text(std::string_view text, const std::string& path, const ReadOptions& options, Context& context,
                    std::size_t chunk_bytes = usual_chunk_bytes);

}  // namespace rakelight::io::obj
