// SPDX-License-Identifier: Apache-2.0
// An OBJ file written back with other normals: `vn` lines and the references of faces change, every other byte stays.
#pragma once
#include <string>

#include <rakelight/scene/scene.h>

#include "io/obj/obj_lines.h"
#include "io/reader.h"

namespace rakelight::io {

/// The file's own `vn` lines go; each object gets a block of new ones, after the last `v`, `vt` or `vn` line before its
/// first face (else right before that face). Numbers in the shortest form that reads back as the same float. Faces that
/// the reader skips lose their reference to a normal. A corner of a polygon has the normal of the first triangle that
/// the polygon was cut into there.
///
/// @param after  the scene that obj_reader makes of `source`, with other normals and splits
/// @param output may be `source`; to another folder the MTL files and pictures that the model names go along
/// @param options  with what the reader kept of the file, or without: then it is read again
/// @param chunk_bytes  what threads take at once; nothing but speed depends on it
/// @return false when all faces had these normals already, to rounding: the file was copied byte by byte
/// @throws Error as obj_reader; failed: cannot write, or a file of the model is there already with other bytes
bool rewrite_obj_normals(const std::string& source, const Scene& after, const std::string& output,
                         const ReadOptions& options, Context& context,
                         std::size_t chunk_bytes = obj::usual_chunk_bytes);

/// The file byte by byte; to another folder the MTL files and pictures that it names go along. @throws Error as above
void copy_obj(const std::string& source, const std::string& output, const ReadOptions& options, Context& context);

}  // namespace rakelight::io
