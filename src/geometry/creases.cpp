// SPDX-License-Identifier: Apache-2.0
#include <rakelight/geometry/creases.h>

#include "geometry/groups/grouping.h"

namespace rakelight {

Creases find_creases(std::span<const AttributeMesh> meshes, const AttributeOptions& options, Context& context) {
    using namespace geometry;
    check_options(options);
    const AttributeInput input = check_input(meshes, context);
    GroupingBase base;
    AttributeOptions normals_only = options;
    normals_only.normals = true;
    const CreaseEdges& edges = crease_edges(base, input, normals_only, context);
    Creases out;
    out.report = edges.report;
    out.hard.resize(meshes.size());
    for (std::size_t m = 0; m < meshes.size(); ++m)
        for (std::uint32_t t = input.triangle_base[m]; t < input.triangle_base[m + 1]; ++t)
            out.hard[m].push_back(edges.bits[t] & 7);
    return out;
}

}  // namespace rakelight
