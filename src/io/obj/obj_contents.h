// SPDX-License-Identifier: Apache-2.0
// First pass over an OBJ file: what is in it. It takes all chunks at once.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <rakelight/base/context.h>

#include "io/obj/obj_lines.h"
#include "io/obj/obj_remarks.h"

namespace rakelight::io::obj {

/// A chunk and what was counted in it.
struct ChunkContents {
    Chunk chunk;
    std::uint64_t first_line = 1;                             ///< the number of its first line
    std::uint64_t positions = 0, texcoords = 0, normals = 0;  ///< v, vt, vn lines
    std::uint64_t others = 0;                                 ///< lines with other keywords
    std::uint64_t positions_before = 0, texcoords_before = 0, normals_before = 0;
    std::size_t vertices_end = 0;  ///< first byte after the last v, vt or vn line; 0: there is none
    bool has_vertices() const { return positions + texcoords + normals > 0; }
};

/// What a file holds, counted before memory is requested.
struct Contents {
    std::uint64_t positions = 0, texcoords = 0, normals = 0, elements = 0;  ///< v, vt, vn; f, l and p lines
    bool has_objects = false;                                               ///< any `o` line
    bool has_smoothing = false;                                             ///< any `s` line
    std::vector<std::string> libraries;  ///< arguments of the mtllib lines, in order, each text once
    std::vector<ChunkContents> chunks;   ///< all of the file
};

/// @param chunk_bytes  for chunks_of(); nothing but speed depends on it
/// @throws Error bad_file: more than 2^32 - 2 vertices of a kind; failed: cancelled
Contents count_contents(std::string_view file, Remarks& remarks, Context& context,
                        std::size_t chunk_bytes = usual_chunk_bytes);

}  // namespace rakelight::io::obj
