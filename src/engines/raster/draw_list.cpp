// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/draw_list.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>

#include "math/linear.h"
#include "scene/material_table.h"

namespace rakelight::raster {
namespace {

void measure(const Mesh& mesh, vec3& low, vec3& high) {
    const float big = std::numeric_limits<float>::max();
    low = {big, big, big};
    high = {-big, -big, -big};
    for (const vec3& p : mesh.positions) {
        if (!is_finite(p)) continue;
        low = min(low, p);
        high = max(high, p);
    }
}

void extend(Bounds& bounds, const Draw& draw) {
    for (int corner = 0; corner < 8; ++corner) {
        const vec3 p = {corner & 1 ? draw.high.x : draw.low.x, corner & 2 ? draw.high.y : draw.low.y,
                        corner & 4 ? draw.high.z : draw.low.z};
        const dvec3 at = transform_point(draw.to_world, cast<double>(p));
        bounds.low = min(bounds.low, at);
        bounds.high = max(bounds.high, at);
    }
}

/// The box of each mesh; meshes that share their positions are measured once.
class BoxTable {
public:
    explicit BoxTable(const std::vector<Mesh>& meshes) : meshes_(meshes), first_(meshes.size()) {
        std::vector<std::uint32_t> order(meshes.size());
        std::iota(order.begin(), order.end(), 0u);
        const auto block = [&](std::uint32_t m) { return meshes[m].positions.identity(); };
        std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            return block(a) != block(b) ? std::less<>()(block(a), block(b)) : a < b;
        });
        for (std::size_t i = 0; i < order.size(); ++i)
            first_[order[i]] = i > 0 && block(order[i]) == block(order[i - 1]) ? first_[order[i - 1]] : order[i];
        boxes_.resize(meshes.size());
        is_known_.resize(meshes.size());
    }
    const std::pair<vec3, vec3>& of(std::uint32_t mesh) {
        const std::uint32_t first = first_[mesh];
        if (!is_known_[first]) measure(meshes_[first], boxes_[first].first, boxes_[first].second);
        is_known_[first] = true;
        return boxes_[first];
    }

private:
    const std::vector<Mesh>& meshes_;
    std::vector<std::uint32_t> first_;  ///< [meshes] the first one of the same positions
    std::vector<std::pair<vec3, vec3>> boxes_;
    std::vector<bool> is_known_;
};

void add_draws(DrawList& list, std::uint64_t placements) {
    const Scene& scene = list.scene;
    BoxTable boxes(scene.meshes);
    list.draws.reserve(placements);
    for (std::uint32_t n = 0; n < scene.nodes.size(); ++n)
        for (const std::uint32_t m : scene.nodes[n].meshes) {
            const Mesh& mesh = scene.meshes[m];
            if (mesh.indices.empty()) continue;
            Draw draw;
            draw.node = n;
            draw.mesh = m;
            draw.material = mesh.material == none ? std::uint32_t(scene.materials.size()) : mesh.material;
            draw.to_world = list.node_to_world[n] * translation(mesh.origin);
            draw.mirrored = determinant(upper_left(draw.to_world)) < 0;
            std::tie(draw.low, draw.high) = boxes.of(m);
            if (!(draw.low.x <= draw.high.x)) continue;
            extend(list.bounds, draw);
            (mesh.topology == Topology::triangles ? list.draws : list.line_draws).push_back(draw);
        }
}

/// Meshes without the texture coordinates of their clearcoat's normal map get a material without that map, which would
/// tilt all of the coat by one of its texels.
void drop_coat_normals(DrawList& list) {
    std::map<std::uint32_t, std::uint32_t> without;  // by the material with it
    for (Draw& draw : list.draws) {
        const Mesh& mesh = list.scene.meshes[draw.mesh];
        const TextureSlot& map = list.materials[draw.material].view.map[role_clearcoat_normal];
        if (!map.view || has_coordinates(mesh, std::uint32_t(map.texcoord_set))) continue;
        const auto [known, is_new] = without.try_emplace(draw.material, std::uint32_t(list.materials.size()));
        if (is_new) {
            DrawMaterial plain = list.materials[draw.material];
            plain.view.map[role_clearcoat_normal] = {};
            list.materials.push_back(plain);
        }
        draw.material = known->second;
    }
}

/// Of each mesh where it is drawn first: a table for each of its places would cost more than it mends.
void find_normal_sides(DrawList& list, Context& context) {
    std::vector<AttributeMesh> meshes;
    std::vector<std::uint32_t> numbers;
    std::vector<bool> seen(list.scene.meshes.size(), false);
    for (const Draw& draw : list.draws) {
        const Mesh& mesh = list.scene.meshes[draw.mesh];
        if (seen[draw.mesh] || mesh.normals.empty() || !list.materials[draw.material].classical) continue;
        seen[draw.mesh] = true;
        numbers.push_back(draw.mesh);
        AttributeMesh& m = meshes.emplace_back();
        m.positions = mesh.positions;
        m.indices = mesh.indices;
        m.normals = mesh.normals;
        m.to_world = draw.to_world;
    }
    list.normal_sides.assign(list.scene.meshes.size(), {});
    if (meshes.empty()) return;
    std::vector<geometry::NormalSides> sides = geometry::find_normal_sides(meshes, context);
    for (std::size_t i = 0; i < numbers.size(); ++i) list.normal_sides[numbers[i]] = std::move(sides[i]);
}

}  // namespace

void fill_materials(DrawList& list, TextureCache& textures, Context& context);  // material_views.cpp

DrawList make_draw_list(Scene given, TextureCache& textures, Context& context) {
    DrawList list;
    list.scene = std::move(given);
    const Scene& scene = list.scene;
    std::uint64_t placements = 0;
    for (const Node& node : scene.nodes) placements += node.meshes.size();
    list.charge =
        MemoryCharge(context.memory(), scene.nodes.size() * sizeof(dmat4) + placements * sizeof(Draw), "what is drawn");
    list.node_to_world = world_matrices(scene);
    add_draws(list, placements);
    fill_materials(list, textures, context);
    drop_coat_normals(list);
    find_normal_sides(list, context);
    for (const Draw& draw : list.draws)
        if (!scene.meshes[draw.mesh].colors.empty()) list.materials[draw.material].view.vertex_colors = 1;
    return list;
}

}  // namespace rakelight::raster
