// SPDX-License-Identifier: Apache-2.0
// Open borders of an inspected model that run along each other: their seams, or the distance that would find these.
#pragma once
#include <rakelight/tools/inspect.h>

#include "geometry/faults/edge_census.h"
#include "geometry/faults/place_classes.h"
#include "tools/inspect/seam_normals.h"
#include "tools/inspect/surfaces.h"

namespace rakelight {

/// Whether meshes could match at all: two of them have open edges.
bool have_open_borders(const geometry::PlacedMeshes& placed, const geometry::EdgeCensus& census);

/// Fills Inspection::matched, and appends the pieces with a seam to Inspection::seam_lines when these are requested.
/// `normals.after` are joined along the borders.
void look_at_matched_borders(Inspection& result, const Surfaces& surfaces, SeamNormals& normals,
                             const InspectOptions& options, Context& context);

/// Whether the open edges of a model fit into memory for propose_border_distance(). If not, a note says so.
bool can_propose_border_distance(const std::string& file, const geometry::EdgeCensus& census, Context& context);

/// Fills Inspection::proposal. Where that needs too much memory there is none, and a note says so.
void propose_border_distance(Inspection& result, const Surfaces& surfaces, const std::vector<PartNormals>& before,
                             const InspectOptions& options, Context& context);

}  // namespace rakelight
