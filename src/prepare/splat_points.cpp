// SPDX-License-Identifier: Apache-2.0
#include "prepare/splat_points.h"

#include <rakelight/base/report.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/input/perpendicular.h"
#include "geometry/points/point_normals.h"
#include "geometry/points/point_spacing.h"
#include "math/linear.h"
#include "scene/materials/material_conversion.h"
#include "scene/materials/texture_uses.h"
#include "scene/placement.h"
#include "scene/splat_mesh.h"

namespace rakelight {
namespace {

constexpr float rim_radius = 1.5f;  ///< of a splat, in spacings, so that scattered points leave few gaps
constexpr float flat_half = 0.8f;   ///< half side of a flat square divided by the radius
constexpr float sine_60 = 0.8660254f;
constexpr float mark_diameter = 2.6f;  ///< of a disc on the screen, in the same unit
constexpr float max_of_median = 4;     ///< limit for isolated points, in median sizes
constexpr float max_of_box = 0.025f;  ///< of the box's diagonal: limit for few points, which are dots and not a surface
constexpr std::size_t min_for_normals = 1000;  ///< fewer points show no surface
constexpr std::size_t points_per_task = 1 << 14;

float diagonal_of(const Block<vec3>& positions) {
    vec3 low{1e30f, 1e30f, 1e30f}, high{-1e30f, -1e30f, -1e30f};
    for (const vec3& p : positions)
        if (is_finite(p))
            for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
    return low.x <= high.x ? std::sqrt(dot(high - low, high - low)) : 0;
}

bool may_be_splat(const Scene& scene, const Mesh& mesh) {
    const bool is_lit = !mesh.normals.empty() || (mesh.colors.empty() && mesh.positions.size() >= min_for_normals);
    return is_lit && mesh.influences.empty() && mesh.targets.empty() && mesh.indices.size() <= max_splats &&
           !(mesh.material != no_index && needs_tangents(scene.materials[mesh.material]));
}

/// Geometry of points: splats, or flat squares for many points, which are small on the screen.
struct Layout {
    bool is_flat;
    std::size_t vertices() const { return is_flat ? 4 : splat_vertices; }
    std::size_t corners() const { return is_flat ? 6 : 3 * splat_triangles; }
    std::uint32_t corner(std::size_t k) const {
        constexpr std::uint32_t order[6] = {0, 1, 2, 0, 2, 3};
        return is_flat ? order[k] : splat_corner(k);
    }
    /// Bytes per point.
    std::uint64_t bytes(const Mesh& mesh) const {
        return vertices() * (2 * sizeof(vec3) + sizeof(vec4) + mesh.texcoords.size() * sizeof(vec2)) +
               corners() * sizeof(std::uint32_t);
    }
};

/// Vertex arrays for P points.
struct Splats {
    Layout layout;
    std::vector<vec3> positions, normals;
    std::vector<vec4> colors;
    std::vector<std::vector<vec2>> texcoords;
    std::vector<std::uint32_t> indices;

    Splats(const Mesh& mesh, std::size_t points)
        : layout{points > max_raised},
          positions(layout.vertices() * points),
          normals(positions.size()),
          colors(mesh.colors.empty() ? 0 : positions.size()),
          indices(layout.corners() * points) {
        for (const Block<vec2>& set : mesh.texcoords) texcoords.emplace_back(set.empty() ? 0 : positions.size());
    }

    void set(std::size_t i, const Mesh& mesh, std::uint32_t v, float radius) {
        const vec3 p = mesh.positions[v], n = mesh.normals[v], up = n * (radius * splat_slope);
        const vec3 x = cast<float>(geometry::perpendicular(cast<double>(n))) * radius, y = cross(n, x) * sine_60,
                   z = x * 0.5f, a = x * flat_half, b = cross(n, a);
        const vec3 flat[4] = {p - a - b, p + a - b, p + a + b, p - a + b};
        const vec3 raised[splat_vertices] = {p + up, p - up, p + x, p + z + y, p - z + y, p - x, p - z - y, p + z - y};
        const std::size_t first = layout.vertices() * i;
        for (std::size_t k = 0; k < layout.vertices(); ++k) {
            positions[first + k] = layout.is_flat ? flat[k] : raised[k];
            normals[first + k] = n;
            if (!colors.empty()) colors[first + k] = mesh.colors[v];
            for (std::size_t s = 0; s < texcoords.size(); ++s)
                if (!texcoords[s].empty()) texcoords[s][first + k] = mesh.texcoords[s][v];
        }
        for (std::size_t k = 0; k < layout.corners(); ++k)
            indices[layout.corners() * i + k] = std::uint32_t(first) + layout.corner(k);
    }
};

std::uint64_t bytes_of_splats(const Mesh& mesh, std::size_t points) {
    return points * Layout{points > max_raised}.bytes(mesh);
}

bool is_direction(vec3 n) { return std::fabs(dot(n, n) - 1) < 0.01f; }

class Splatter {
public:
    Splatter(Scene& scene, Context& context) : scene_(scene), context_(context) {}

    /// @return the points without a normal as a separate mesh; without indices if there are none
    Mesh run(std::uint32_t number) {
        Mesh& mesh = scene_.meshes[number];
        const std::vector<float> spacing = geometry::point_spacing(mesh.positions, context_);
        const float median = geometry::median_spacing(spacing), most = max_of_box * diagonal_of(mesh.positions);
        if (mesh.normals.empty() && !find_normals(mesh, spacing)) return {};
        std::vector<std::uint32_t> lit, others;
        for (const std::uint32_t v : mesh.indices)
            if (is_finite(mesh.positions[v])) (is_direction(mesh.normals[v]) ? lit : others).push_back(v);
        if (lit.empty()) return {};
        Mesh rest = mesh;
        rest.indices = others;
        rest.normals = {};
        make_splats(mesh, lit, [&](std::uint32_t v) {
            return std::min(rim_radius * std::min(spacing[v], max_of_median * median), most);
        });
        return rest;
    }

    /// Estimates normals for points without normals and colors.
    /// @return whether they lie on a surface
    bool find_normals(Mesh& mesh, const std::vector<float>& spacing) {
        std::vector<vec3> normals = geometry::point_normals(mesh.positions, spacing, context_);
        if (normals.empty()) return false;
        MemoryCharge charge(context_.memory(), normals.size() * sizeof(vec3), "the normals of points");
        mesh.normals = {std::move(normals), std::move(charge)};
        context_.report().add(Remark::note, scene_.source, "",
                              "points without normals and colors are lit by normals of their neighborhoods");
        return true;
    }

    /// The two-sided material.
    std::uint32_t two_sided(std::uint32_t material) {
        if (scene_.materials[material].double_sided) return material;
        const auto [entry, is_new] = two_sided_.try_emplace(material, std::uint32_t(scene_.materials.size()));
        if (is_new) {
            scene_.materials.push_back(scene_.materials[material]);
            scene_.materials.back().double_sided = true;
        }
        return entry->second;
    }

private:
    template <class RadiusOf>
    void make_splats(Mesh& mesh, const std::vector<std::uint32_t>& points, const RadiusOf& radius_of) {
        MemoryCharge charge(context_.memory(), bytes_of_splats(mesh, points.size()), "the discs of points");
        Splats splats(mesh, points.size());
        context_.parallel_for((points.size() + points_per_task - 1) / points_per_task, [&](std::size_t task) {
            const std::size_t end = std::min(points.size(), (task + 1) * points_per_task);
            for (std::size_t i = task * points_per_task; i < end; ++i)
                splats.set(i, mesh, points[i], radius_of(points[i]));
        });
        const auto block = [&charge](auto& array) {
            MemoryCharge part = charge.split(array.size() * sizeof(array[0]));
            return Block(std::move(array), std::move(part));
        };
        mesh.topology = Topology::triangles;
        mesh.positions = block(splats.positions), mesh.normals = block(splats.normals);
        mesh.colors = block(splats.colors), mesh.indices = block(splats.indices);
        for (std::size_t s = 0; s < mesh.texcoords.size(); ++s) mesh.texcoords[s] = block(splats.texcoords[s]);
        mesh.tangents = {};
        mesh.arrays.clear();  // they are one per point; colors were made of them before
        mesh.material = two_sided(mesh.material);
    }

    Scene& scene_;
    Context& context_;
    std::map<std::uint32_t, std::uint32_t> two_sided_;
};

double length_of(const dvec4& column) { return std::sqrt(dot(column.xyz(), column.xyz())); }

/// Indices of the meshes that become splats.
std::vector<std::uint32_t> meshes_to_splat(const Scene& scene) {
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t m = 0; m < scene.meshes.size(); ++m)
        if (scene.meshes[m].topology == Topology::points && may_be_splat(scene, scene.meshes[m])) numbers.push_back(m);
    return numbers;
}

}  // namespace

Scene splat_points(Scene scene, Context& context) {
    const std::vector<std::uint32_t> numbers = meshes_to_splat(scene);
    if (numbers.empty()) return scene;
    name_default_material(scene);
    Splatter splatter(scene, context);
    std::map<std::uint32_t, std::uint32_t> rests;  // mesh -> the mesh of its points without normals
    for (const std::uint32_t m : numbers) {
        Mesh rest = splatter.run(m);
        if (rest.indices.empty()) continue;
        rests[m] = std::uint32_t(scene.meshes.size());
        scene.meshes.push_back(std::move(rest));
    }
    for (Node& node : scene.nodes)
        for (std::size_t i = 0, end = rests.empty() ? 0 : node.meshes.size(); i < end; ++i)
            if (const auto rest = rests.find(node.meshes[i]); rest != rests.end()) node.meshes.push_back(rest->second);
    return scene;
}

std::optional<double> point_diameter(const Scene& scene, Context& context) {
    const std::vector<dmat4> world = world_matrices(scene);
    std::map<std::uint32_t, float> known;
    std::optional<double> smallest;
    for (std::size_t n = 0; n < scene.nodes.size(); ++n)
        for (const std::uint32_t m : scene.nodes[n].meshes) {
            const Mesh& mesh = scene.meshes[m];
            if (mesh.topology != Topology::points || mesh.indices.empty()) continue;
            const auto [entry, is_new] = known.try_emplace(m, 0.0f);
            if (is_new)
                entry->second =
                    std::min(mark_diameter * geometry::median_spacing(geometry::point_spacing(mesh.positions, context)),
                             2 * max_of_box * diagonal_of(mesh.positions));
            const double scale = (length_of(world[n][0]) + length_of(world[n][1]) + length_of(world[n][2])) / 3;
            const double diameter = scale * double(entry->second);
            if (diameter > 0 && !(smallest && *smallest <= diameter)) smallest = diameter;
        }
    return smallest;
}

}  // namespace rakelight
