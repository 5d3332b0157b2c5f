// SPDX-License-Identifier: Apache-2.0
#include "engines/raytrace/ray_marks.h"

#include <algorithm>
#include <utility>

#include "math/linear.h"
#include "shading/culled_triangle.h"
#include "shading/mark_color.h"

namespace rakelight::raytrace {
namespace {

/// Calls use(corners) for each triangle that is not culled.
template <class Use>
void for_each_seen(const shading::DrawList& list, const shading::Draw& draw, const shading::PictureCamera& view,
                   const RenderSettings& settings, const Use& use) {
    const Mesh& mesh = list.scene.meshes[draw.mesh];
    const shading::Culling culling = shading::culling_of(list, draw, settings);
    const dmat4 to_camera = view.world_to_camera * draw.to_world;
    const auto place = [&](std::uint32_t vertex) {
        const dvec3 p = transform_point(to_camera, cast<double>(mesh.positions[vertex]));
        return dvec3{p.x * view.scale_x, p.y * view.scale_y, view.orthographic ? 1.0 : -p.z};
    };
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
        const std::uint32_t* const index = mesh.indices.data() + 3 * t;
        if ((culling.back || culling.front) &&
            shading::is_culled(culling, {place(index[0]), place(index[1]), place(index[2])}))
            continue;
        use(index);
    }
}

/// Both ends of every edge, each edge once.
std::vector<std::uint32_t> edges_of(const shading::DrawList& list, const shading::Draw& draw,
                                    const shading::PictureCamera& view, const RenderSettings& settings) {
    std::vector<std::uint64_t> edges;
    for_each_seen(list, draw, view, settings, [&](const std::uint32_t* index) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [a, b] = std::minmax(index[k], index[(k + 1) % 3]);
            edges.push_back(std::uint64_t(a) << 32 | b);
        }
    });
    std::ranges::sort(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    std::vector<std::uint32_t> ends;
    for (const std::uint64_t edge : edges)
        ends.push_back(std::uint32_t(edge >> 32)), ends.push_back(std::uint32_t(edge));
    return ends;
}

std::vector<std::uint32_t> vertices_of(const shading::DrawList& list, const shading::Draw& draw,
                                       const shading::PictureCamera& view, const RenderSettings& settings) {
    std::vector<std::uint32_t> vertices;
    for_each_seen(list, draw, view, settings,
                  [&](const std::uint32_t* index) { vertices.insert(vertices.end(), index, index + 3); });
    std::ranges::sort(vertices);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
}

MarkedDraw marked(const shading::DrawList& list, const shading::Draw& draw, bool is_line) {
    const Mesh& mesh = list.scene.meshes[draw.mesh];
    return {&draw, &mesh, is_line, shading::mark_color(list.materials[draw.material]), !mesh.colors.empty(), {}, {}};
}

}  // namespace

vec4 MarkedDraw::color_at(std::uint32_t number, float part) const {
    vec4 out = color;
    if (has_vertex_colors) {
        const std::size_t first = is_line ? 2 * std::size_t(number) : number;
        vec4 own = mesh->colors[vertex(first)];
        if (is_line) own = own + (mesh->colors[vertex(first + 1)] - own) * part;
        out = {color.x * own.x, color.y * own.y, color.z * own.z, color.w};
    }
    return {out.x, out.y, out.z, std::clamp(out.w, 0.0f, 1.0f)};
}

std::vector<MarkedDraw> marked_draws(const shading::DrawList& list, const shading::PictureCamera& view,
                                     const RenderSettings& settings, Context& context) {
    std::vector<MarkedDraw> marks;
    for (const shading::Draw& draw : list.line_draws)
        marks.push_back(marked(list, draw, list.scene.meshes[draw.mesh].topology == Topology::lines));
    const bool is_over = settings.surfaces && settings.line_color.w == 0;
    const vec4 one = is_over ? vec4{0, 0, 0, 1} : settings.line_color;
    for (const auto& [wanted, is_line] :
         {std::pair{settings.edges, true}, {settings.points != PointShape::none, false}})
        for (std::size_t d = 0; wanted && d < list.draws.size(); ++d) {
            context.throw_if_cancelled();
            MarkedDraw m = marked(list, list.draws[d], is_line);
            if (one.w > 0) m.color = one, m.has_vertex_colors = false;
            m.charge = MemoryCharge(context.memory(), m.mesh->indices.size() * sizeof(std::uint64_t), "rays");
            m.vertices = is_line ? edges_of(list, *m.draw, view, settings) : vertices_of(list, *m.draw, view, settings);
            if (!m.vertices.empty()) marks.push_back(std::move(m));
        }
    return marks;
}

}  // namespace rakelight::raytrace
