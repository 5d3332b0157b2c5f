// SPDX-License-Identifier: Apache-2.0
// Stages: open edges -> nodes at their ends -> links between borders of different meshes -> votes passed up the links,
// normals and tangents passed down.
#include <rakelight/geometry/matching_borders.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/format_text.h"
#include "geometry/borders/border_links.h"
#include "geometry/borders/border_sums.h"
#include "geometry/borders/border_surface.h"
#include "geometry/borders/open_edges.h"
#include "geometry/fits/fit_normals.h"

namespace rakelight {

struct BorderMatch::Impl {
    MatchOptions options;
    std::vector<std::uint32_t> vertices, triangles;  ///< [meshes] counts required by join_borders()
    geometry::BorderNodes nodes;
    geometry::BorderLinks links;
    geometry::BorderRings rings;  ///< empty: no normals are fitted
};

bool BorderMatch::is_empty() const { return impl_->links.links.empty(); }

BorderMatch match_borders(std::span<const AttributeMesh> meshes, const MatchOptions& options, Context& context) {
    geometry::check_matching(meshes, options);
    auto impl = std::make_shared<BorderMatch::Impl>();
    impl->options = options;
    for (const AttributeMesh& mesh : meshes) {
        impl->vertices.push_back(std::uint32_t(mesh.positions.size()));
        impl->triangles.push_back(std::uint32_t(mesh.indices.size() / 3));
    }
    if (options.scope == Scope::face) return BorderMatch(std::move(impl));
    const geometry::BorderSurface surface(meshes, options, context);
    if (surface.edges.empty()) return BorderMatch(std::move(impl));
    impl->nodes = geometry::find_border_nodes(surface.placed, surface.open_corners, context);
    const geometry::BorderSearch search(surface.edges, surface.placed.input, options, context);
    impl->links = geometry::link_borders(search, surface.placed.input, impl->nodes, options.distance, context);
    if (impl->links.links.empty()) impl->nodes = {};
    if (geometry::is_fitted(options.weight) && !options.keep_flat)
        impl->rings = geometry::border_rings(surface.placed, impl->nodes, impl->links.links, context);
    return BorderMatch(std::move(impl));
}

std::vector<MeshSeams> join_borders(const BorderMatch& match, std::span<const AttributeMesh> meshes,
                                    std::span<const std::span<const vec4>> tangents, MatchReport& report,
                                    Context& context) {
    const BorderMatch::Impl& impl = match.impl();
    report = {};
    report.vertices_not_searched = impl.links.vertices_not_searched;
    if (match.is_empty()) return std::vector<MeshSeams>(meshes.size());
    geometry::check_normals(meshes);
    const auto refuse = [](std::size_t m) {
        throw Error(ErrorCode::bad_file, "other counts than were matched", format_text("mesh {}", m));
    };
    for (std::size_t m = 0; m < std::max(meshes.size(), impl.vertices.size()); ++m)
        if (m >= meshes.size() || m >= impl.vertices.size() || meshes[m].positions.size() != impl.vertices[m] ||
            meshes[m].indices.size() / 3 != impl.triangles[m] ||
            (!tangents.empty() && !tangents[m].empty() && tangents[m].size() != impl.vertices[m]))
            refuse(m);
    const geometry::AttributeInput input = geometry::number_input(meshes);
    return geometry::BorderSums(input, tangents, impl.nodes, impl.links.links, impl.rings, impl.options.weight)
        .run(report, context);
}

}  // namespace rakelight
