// SPDX-License-Identifier: Apache-2.0
#include "engines/raytrace/scene/ray_marks.h"

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
    edges.reserve(list.scene.meshes[draw.mesh].indices.size());
    for_each_seen(list, draw, view, settings, [&](const std::uint32_t* index) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [a, b] = std::minmax(index[k], index[(k + 1) % 3]);
            edges.push_back(std::uint64_t(a) << 32 | b);
        }
    });
    std::ranges::sort(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    std::vector<std::uint32_t> ends;
    ends.reserve(2 * edges.size());
    for (const std::uint64_t edge : edges)
        ends.push_back(std::uint32_t(edge >> 32)), ends.push_back(std::uint32_t(edge));
    return ends;
}

std::vector<std::uint32_t> vertices_of(const shading::DrawList& list, const shading::Draw& draw,
                                       const shading::PictureCamera& view, const RenderSettings& settings) {
    std::vector<std::uint32_t> vertices;
    vertices.reserve(list.scene.meshes[draw.mesh].indices.size());
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

/// Edges are found as numbers of 8 bytes, up to three a triangle, and their ends kept as two of 4 bytes.
constexpr std::uint64_t bytes_per_corner_of_edges = 8 + 2 * 4, bytes_per_corner_of_vertices = 4;

void find_vertices(MarkedDraw& m, const shading::DrawList& list, const shading::PictureCamera& view,
                   const RenderSettings& settings, Context& context) {
    const std::uint64_t corners = m.mesh->indices.size();
    m.charge = MemoryCharge(context.memory(),
                            corners * (m.is_line ? bytes_per_corner_of_edges : bytes_per_corner_of_vertices), "rays");
    m.vertices = m.is_line ? edges_of(list, *m.draw, view, settings) : vertices_of(list, *m.draw, view, settings);
    m.charge.shrink(m.charge.bytes() - m.vertices.capacity() * sizeof(std::uint32_t));
}

/// Marks of one color that follow each other in the scene are a run, as in raster/marks. Lines thinner than a pixel cover less than
/// points do.
void number_runs(std::vector<MarkedDraw>& marks, float line_width) {
    std::uint32_t runs = 0;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        if (marks[i].has_vertex_colors) continue;
        const bool goes_on = i > 0 && !marks[i - 1].has_vertex_colors && marks[i - 1].color == marks[i].color &&
                             (marks[i - 1].is_line == marks[i].is_line || line_width >= 1);
        marks[i].run = goes_on ? marks[i - 1].run : runs++;
    }
}

}  // namespace

bool MarkedDraw::are_joined(std::uint32_t a, std::uint32_t b) const {
    if (!is_line || !has_vertex_colors || !(color.w < 1)) return false;
    for (const std::size_t i : {0, 1})
        for (const std::size_t k : {0, 1})
            if (mesh->positions[vertex(2 * std::size_t(a) + i)] == mesh->positions[vertex(2 * std::size_t(b) + k)])
                return true;
    return false;
}

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
            find_vertices(m, list, view, settings, context);
            if (!m.vertices.empty()) marks.push_back(std::move(m));
        }
    number_runs(marks, settings.line_width);
    return marks;
}

}  // namespace rakelight::raytrace
