// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "io/import/stream_format.h"

namespace rakelight::import_helper {

using namespace io::import_stream;

/// Joins the vertices of a part that are equal to the last bit in everything, and drops those that nothing uses.
/// @param met  out, for tests: slots of the table that were looked at and held another vertex; null: not wanted
void join_equal_vertices(Part& part, std::uint64_t* met = nullptr);

}  // namespace rakelight::import_helper
