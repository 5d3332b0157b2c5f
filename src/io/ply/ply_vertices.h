// SPDX-License-Identifier: Apache-2.0
// The vertices of a PLY file.
#pragma once
#include "io/ply/ply_cursor.h"
#include "io/vertex_table.h"

namespace rakelight::io::ply {

/// Reads all rows of the element into a table of as many vertices. @throws Error bad_file: the data end before
void read_vertices(Cursor& cursor, const Element& element, Format format, VertexTable& table, const std::string& path,
                   Context& context);

/// What numbers of a property are like.
ColumnKind kind_of(const Property& property, Format format);

}  // namespace rakelight::io::ply
