// SPDX-License-Identifier: Apache-2.0
#include "shading/remarks/open_surfaces.h"

#include <algorithm>
#include <set>
#include <string>

#include <rakelight_internal/base/text.h>

#include "base/format_text.h"
#include "geometry/faults/edge_census.h"
#include "scene/validate_parts.h"

namespace rakelight::shading {
namespace {

/// What counting takes, in elements.
std::uint64_t size_of(const Mesh& mesh) {
    return std::max<std::uint64_t>(mesh.triangle_count(), mesh.positions.size());
}

std::string message(bool asked, std::uint64_t edges, std::uint64_t more) {
    std::string text = "back faces were culled of an open surface with " + counted(edges, "boundary edge");
    if (more > 0) text += ", and of " + counted(more, "more object");
    return text + (asked ? ": its inside is not shown" : "");
}

/// Edges of one triangle, of which ends within a distance are one.
std::uint64_t open_edges(std::span<const AttributeMesh> meshes, double distance, Context& context) {
    return geometry::count_edges(geometry::place_vertices(meshes, distance, context), 1, context).objects[0].open;
}

}  // namespace

double OpenSurfaces::weld_tolerance(const DrawList& list, Part object) {
    double distance = 0;
    for (const Draw* draw = object.begin; draw != object.end; ++draw) {
        const vec3 far = max(draw->high, vec3{} - draw->low);
        constexpr double ulps = 0x4p-23, half_diagonal = 0.87;
        distance = std::max({distance, ulps * double(std::max({far.x, far.y, far.z})),
                             half_diagonal * list.scene.meshes[draw->mesh].position_step});
    }
    return distance;
}

std::uint64_t OpenSurfaces::count(const DrawList& list, Part object, Context& context) const {
    std::vector<AttributeMesh> meshes;
    for (const Draw* draw = object.begin; draw != object.end; ++draw) {
        const Mesh& mesh = list.scene.meshes[draw->mesh];
        AttributeMesh& m = meshes.emplace_back();  // in object space: the placement opens nothing
        m.positions = mesh.positions;
        m.indices = mesh.indices;
    }
    return open_edges(meshes, 0, context) == 0 ? 0 : open_edges(meshes, weld_tolerance(list, object), context);
}

void OpenSurfaces::remark(const DrawList& list, std::span<const std::uint8_t> is_culled, Cull cull, bool asked,
                          Context& context) {
    if (cull == Cull::none || cull == Cull::front) return;
    const std::vector<Draw>& draws = list.draws;
    Context silent(
        {.threads = context.threads(), .parent = &context});  // what welding has to say is no remark on the picture
    std::set<Key> seen;
    const std::uint64_t most = asked ? most_for_warning : most_for_note;
    std::uint64_t looked_at = 0, open = 0, edges = 0;
    std::uint32_t first = no_index;
    for (std::size_t d = 0, end = 0; d < is_culled.size(); d = end) {
        Key key;
        std::uint64_t size = 0;
        bool any_culled = false;
        for (end = d; end < draws.size() && draws[end].node == draws[d].node; ++end) {
            const Mesh& mesh = list.scene.meshes[draws[end].mesh];
            key.insert(key.end(), {mesh.positions.identity(), mesh.indices.identity()});
            size += size_of(mesh);
            any_culled |= is_culled[end] != 0;
        }
        if (!any_culled || size > most) continue;
        if (seen.insert(key).second && (looked_at += size) > most) break;
        const auto [known, is_new] = boundary_edges_.try_emplace(std::move(key), 0);
        if (is_new) known->second = count(list, {&draws[d], draws.data() + end}, silent);
        if (known->second == 0) continue;
        if (open++ == 0) first = draws[d].node, edges = known->second;
    }
    if (open == 0) return;
    context.report().add(asked ? Remark::warning : Remark::note, list.scene.source,
                         Place{"node", first, list.scene.nodes[first].name}.text(), message(asked, edges, open - 1));
}

}  // namespace rakelight::shading
