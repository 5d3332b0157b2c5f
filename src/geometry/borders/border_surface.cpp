// SPDX-License-Identifier: Apache-2.0
#include "geometry/borders/border_surface.h"

#include <cmath>

#include "base/enumerators.h"
#include "geometry/borders/open_edges.h"

namespace rakelight::geometry {

void check_matching(std::span<const AttributeMesh> meshes, const MatchOptions& options) {
    if (!(options.distance > 0) || !std::isfinite(options.distance))
        throw Error(ErrorCode::usage, "the border distance must be above 0 and finite");
    if (!exists(options.scope, Scope::model)) throw Error(ErrorCode::usage, no_such("scope", options.scope));
    AttributeOptions checked;
    checked.crease_angle_rad = options.crease_angle_rad;
    checked.weld_distance = options.weld_distance;
    checked.weight = options.weight;
    check_options(checked);
    check_normals(meshes);
}

BorderSurface::BorderSurface(std::span<const AttributeMesh> meshes, const MatchOptions& options, Context& context)
    : placed(place_vertices(meshes, options.weld_distance, context)) {
    const std::uint64_t vertices = placed.input.vertex_count();
    context.memory().check(13 * vertices, "matching open borders");
    open_corners = find_open_edges(placed, context);
    edges = border_edges(placed, open_corners, context);
}

}  // namespace rakelight::geometry
