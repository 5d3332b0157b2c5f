// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <deque>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include <rakelight/render/render.h>
#include <rakelight/tools/smooth_file.h>

#include "geometry/borders/open_edges.h"
#include "geometry/faults/place_classes.h"
#include "geometry/input/union_find.h"
#include "tools/inspect/surfaces.h"

namespace rakelight {
namespace {

/// The faces at open edges of one mesh. Each has its open edge first.
struct Rim {
    std::uint32_t file;
    std::vector<vec3> positions{};         ///< [3T] object space
    std::vector<std::uint32_t> indices{};  ///< [3T]
    MemoryCharge charge{};
    dmat4 to_world{};
    double position_step = 0;

    explicit Rim(std::uint32_t number) : file(number) {}
    /// @throws Error bad_file: over the memory budget
    void reserve(std::size_t faces, Context& context) {
        const std::size_t corners = 3 * faces;
        charge = MemoryCharge(context.memory(), corners * (sizeof(vec3) + sizeof(std::uint32_t)), "open borders");
        positions.reserve(corners), indices.reserve(corners);
    }
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
    for (std::size_t i = 0, end = 0; i < corners.size(); i = end) {  // ascending, so mesh by mesh
        const std::uint32_t m = placed.input.mesh_of_triangle(corners[i] / 3), first = placed.input.triangle_base[m];
        const auto last = std::lower_bound(corners.begin() + i, corners.end(), 3 * placed.input.triangle_base[m + 1]);
        end = std::size_t(last - corners.begin());
        const AttributeMesh& mesh = surfaces.meshes[m];
        Rim& rim = rims.emplace_back(file);
        rim.to_world = mesh.to_world, rim.position_step = mesh.position_step;
        rim.reserve(end - i, context);
        for (std::size_t k = i; k < end; ++k) rim.add(mesh, corners[k] - 3 * first);
    }
}

/// An open edge between two places.
struct OpenEdge {
    std::uint32_t low, high;  ///< places
    bool is_upward;           ///< its face runs from `low` to `high`
    std::uint32_t file;
};

/// Of all files, equal edges beside each other.
class OpenEdges {
public:
    OpenEdges(std::span<const AttributeMesh> rims, double weld_distance, Context& context) {
        const geometry::PlacedMeshes placed = geometry::place_vertices(rims, weld_distance, context);
        const geometry::AttributeInput& input = placed.input;
        charge_ = MemoryCharge(context.memory(), input.triangle_count() * sizeof(OpenEdge), "open borders");
        edges_.reserve(input.triangle_count());
        for (std::uint32_t m = 0; m < rims.size(); ++m)
            for (std::uint32_t v = input.vertex_base[m]; v < input.vertex_base[m + 1]; v += 3) {
                std::uint32_t from = placed.place[v], to = placed.place[v + 1];
                if (input.placements[m].flip < 0) std::swap(from, to);
                if (from != to) edges_.push_back({std::min(from, to), std::max(from, to), from < to, rims[m].object});
            }
        std::ranges::sort(edges_, {}, key);
    }

    /// Calls body(span of all uses) for each edge.
    void for_each(const auto& body) const {
        for (std::size_t i = 0, end = 0; i < edges_.size(); i = end) {
            const auto is_other = [&](const OpenEdge& e) { return e.low != edges_[i].low || e.high != edges_[i].high; };
            end = std::size_t(std::find_if(edges_.begin() + i, edges_.end(), is_other) - edges_.begin());
            body(std::span(edges_).subspan(i, end - i));
        }
    }

private:
    static std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, bool> key(const OpenEdge& e) {
        return {e.low, e.high, e.file, e.is_upward};
    }
    MemoryCharge charge_;
    std::vector<OpenEdge> edges_;
};

constexpr std::uint32_t fewest_common_edges = 2;

FilesCutApart compared(const OpenEdges& edges, std::size_t files) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> common;  // [two files] their edges
    std::set<std::uint32_t> unclear;
    edges.for_each([&](std::span<const OpenEdge> uses) {
        const auto up = std::ranges::count(uses, true, &OpenEdge::is_upward);
        if (up == 0 || std::size_t(up) == uses.size()) return;
        if (uses.size() == 2)
            ++common[{uses[0].file, uses[1].file}];
        else
            for (const OpenEdge& use : uses) unclear.insert(use.file);
    });
    geometry::UnionFind groups;
    groups.reset(files);
    for (const auto& [pair, count] : common)
        if (count >= fewest_common_edges) groups.join(pair.first, pair.second);
    FilesCutApart out{.unclear = {unclear.begin(), unclear.end()}};
    for (std::uint32_t i = 0; i < files; ++i) out.first.push_back(groups.root(i));
    return out;
}

}  // namespace

FilesCutApart files_cut_apart(std::span<const std::string> files, const SmoothFileOptions& options, Context& context) {
    std::deque<Rim> rims;
    for (std::uint32_t i = 0; i < files.size(); ++i) try {
            add_rims(files[i], i, options, rims, context);
        } catch (const Error&) {
            context.throw_if_cancelled();  // whoever smooths the file says what is wrong with it
            std::erase_if(rims, [&](const Rim& rim) { return rim.file == i; });
        }
    std::vector<AttributeMesh> meshes;
    for (const Rim& rim : rims) meshes.push_back(rim.view());
    return compared(OpenEdges(meshes, options.attributes.weld_distance, context), files.size());
}

}  // namespace rakelight
