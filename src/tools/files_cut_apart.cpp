// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <deque>
#include <tuple>

#include <rakelight/render.h>
#include <rakelight/smooth_file.h>

#include "geometry/open_edges.h"
#include "geometry/place_classes.h"
#include "geometry/union_find.h"
#include "tools/surfaces.h"

namespace rakelight {
namespace {

/// The faces at open edges of one mesh. Each has its open edge first.
struct Rim {
    std::uint32_t file;
    std::vector<vec3> positions{};         ///< [3T] object space
    std::vector<std::uint32_t> indices{};  ///< [3T]
    dmat4 to_world{};
    double position_step = 0;

    void add(const AttributeMesh& mesh, std::uint32_t corner) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            indices.push_back(std::uint32_t(positions.size()));
            positions.push_back(mesh.positions[mesh.indices[corner - corner % 3 + (corner + k) % 3]]);
        }
    }
    AttributeMesh view() const {
        AttributeMesh out;
        out.object = file;
        out.positions = positions, out.indices = indices;
        out.to_world = to_world, out.position_step = position_step;
        return out;
    }
};

/// The rims of a file; nothing of the file stays in memory beside them.
void add_rims(const std::string& path, std::uint32_t file, const SmoothFileOptions& options, std::deque<Rim>& rims,
              Context& context) {
    const Scene scene = load(path, options.load, context);
    const Surfaces surfaces = collect_surfaces(scene, {}, NormalSource::file);
    const geometry::PlacedMeshes placed =
        geometry::place_vertices(surfaces.meshes, options.attributes.weld_distance, context);
    const std::vector<std::uint32_t> corners = geometry::find_open_edges(placed, context);
    context.memory().check(corners.size() * 3 * (sizeof(vec3) + 4), "the open borders of several files");
    std::uint32_t last = no_index;
    for (const std::uint32_t corner : corners) {  // ascending, so mesh by mesh
        const std::uint32_t m = placed.input.mesh_of_triangle(corner / 3);
        const AttributeMesh& mesh = surfaces.meshes[m];
        if (m != last)
            rims.push_back({.file = file, .to_world = mesh.to_world, .position_step = mesh.position_step}), last = m;
        // Around its face, in the winding of the mesh.
        rims.back().add(mesh, corner - 3 * placed.input.triangle_base[m]);
    }
}

/// An open edge between two places.
struct OpenEdge {
    std::uint32_t low, high;  ///< places
    bool is_upward;           ///< its face runs from `low` to `high`
    std::uint32_t file;
};

std::vector<OpenEdge> edges_of(std::span<const AttributeMesh> rims, double weld_distance, Context& context) {
    const geometry::PlacedMeshes placed = geometry::place_vertices(rims, weld_distance, context);
    const geometry::AttributeInput& input = placed.input;
    std::vector<OpenEdge> edges;
    edges.reserve(input.triangle_count());
    for (std::uint32_t m = 0; m < rims.size(); ++m)
        for (std::uint32_t v = input.vertex_base[m]; v < input.vertex_base[m + 1]; v += 3) {
            std::uint32_t from = placed.place[v], to = placed.place[v + 1];
            if (input.placements[m].flip < 0) std::swap(from, to);
            if (from != to) edges.push_back({std::min(from, to), std::max(from, to), from < to, rims[m].object});
        }
    std::ranges::sort(edges, {}, [](const OpenEdge& e) { return std::tuple(e.low, e.high, e.file, e.is_upward); });
    return edges;
}

}  // namespace

std::vector<std::uint32_t> files_cut_apart(std::span<const std::string> files, const SmoothFileOptions& options,
                                           Context& context) {
    std::deque<Rim> rims;
    for (std::uint32_t i = 0; i < files.size(); ++i) try {
            add_rims(files[i], i, options, rims, context);
        } catch (const Error&) {
            context.throw_if_cancelled();  // whoever smooths the file says what is wrong with it
        }
    std::vector<AttributeMesh> meshes;
    for (const Rim& rim : rims) meshes.push_back(rim.view());
    const std::vector<OpenEdge> edges = edges_of(meshes, options.attributes.weld_distance, context);
    geometry::UnionFind groups;
    groups.reset(files.size());
    for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
        const auto is_other = [&](const OpenEdge& e) { return e.low != edges[i].low || e.high != edges[i].high; };
        end = std::size_t(std::find_if(edges.begin() + i, edges.end(), is_other) - edges.begin());
        if (end - i == 2 && edges[i].is_upward != edges[i + 1].is_upward) groups.join(edges[i].file, edges[i + 1].file);
    }
    std::vector<std::uint32_t> first(files.size());
    for (std::uint32_t i = 0; i < files.size(); ++i) first[i] = groups.root(i);
    return first;
}

}  // namespace rakelight
