// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "geometry/fast_state.h"

namespace rakelight::geometry {

/// Adds the votes of all faces to the rows of their vertices, inside each mesh. Fixed pieces of about 128k triangles own
/// vertex ranges; votes for another piece's vertex are handed over and added in the order of the pieces, so the bits do not depend
/// on the threads. Faces on which float is not safe are computed in double and then rounded.
/// @return false: an index is out of range (nothing was read through it)
bool scatter_votes(FastState& state);

}  // namespace rakelight::geometry
