// SPDX-License-Identifier: Apache-2.0
#include "bake/low/low_surface.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>

#include <rakelight/geometry/attributes.h>

#include "prepare/variants.h"
#include "scene/placed_normal.h"
#include "scene/placement.h"

namespace rakelight::bake {
namespace {

dvec3 blend(const dvec3 (&v)[3], const CornerWeights& w) { return v[0] * w[0] + v[1] * w[1] + v[2] * w[2]; }

/// Cage normals over all objects, without creases, so that rays of neighbors leave no gap.
AttributeOptions cage_options() {
    AttributeOptions options;
    options.scope = Scope::model;
    options.crease_angle_rad = pi;
    options.tangents = false;
    return options;
}

}  // namespace

LowPoint point_of(const LowTriangle& t, const CornerWeights& w) {
    const dvec3 face = cross(t.place[1] - t.place[0], t.place[2] - t.place[0]);
    return {.place = blend(t.place, w),
            .cage = normalize_or(blend(t.cage, w), normalize_or(face, dvec3{0, 0, 1})),
            .normal = blend(t.normal, w),
            .tangent = blend(t.tangent, w),
            .handedness = t.handedness,
            .to_object = t.to_object};
}

LowSurface::LowSurface(const Scene& scene, std::uint32_t set, Context& context)
    : set_(set), first_{0}, charge_(context.memory()) {
    const std::vector<dmat4> world = world_matrices(scene);
    std::vector<AttributeMesh> meshes;
    std::uint64_t triangles = 0;
    for (const Instance& instance : drawn_instances(scene)) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        if (set >= mesh.texcoords.size() || mesh.texcoords[set].empty()) continue;
        parts_.push_back({mesh, world[instance.node] * translation(mesh.origin)});
        meshes.push_back({.object = instance.node,
                          .positions = mesh.positions,
                          .indices = mesh.indices,
                          .to_world = parts_.back().to_world,
                          .position_step = mesh.position_step});
        triangles += mesh.triangle_count();
        if (triangles > std::numeric_limits<std::uint32_t>::max() / 4)
            throw Error(ErrorCode::bad_file, "has too many triangles to be baked to");
        first_.push_back(std::uint32_t(triangles));
        charge_.grow(mesh.positions.size() * sizeof(vec3) + mesh.indices.size() * 4 + sizeof(Part), "the cage");
    }
    if (triangles == 0) throw Error(ErrorCode::bad_file, "has no triangles to be baked to").with_file(scene.source);
    std::vector<MeshAttributes> made = compute_attributes(meshes, cage_options(), context);
    for (std::size_t i = 0; i < made.size(); ++i) {
        parts_[i].cage = std::move(made[i].normals);
        parts_[i].cage_indices = std::move(made[i].indices);
    }
}

LowSurface::Corner LowSurface::first_corner(std::uint32_t triangle) const {
    const auto part = std::size_t(std::ranges::upper_bound(first_, triangle) - first_.begin()) - 1;
    return {part, 3 * std::size_t(triangle - first_[part])};
}

LowTriangle LowSurface::triangle(std::uint32_t number) const {
    const auto [p, first] = first_corner(number);
    const Part& part = parts_[p];
    const Mesh& mesh = part.mesh;
    const PlacedNormals placed(part.to_world);
    const dmat3 linear = upper_left(part.to_world);
    LowTriangle out;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = mesh.indices[first + k],
                            c = part.cage_indices.empty() ? v : part.cage_indices[first + k];
        const vec4 tangent = mesh.tangents.empty() ? vec4{1, 0, 0, 1} : mesh.tangents[v];
        out.place[k] = transform_point(part.to_world, cast<double>(mesh.positions[v]));
        out.cage[k] = cast<double>(placed(part.cage[c]));
        out.normal[k] = cast<double>(placed(mesh.normals[v]));
        out.tangent[k] = normalize_or(linear * cast<double>(tangent.xyz()), dvec3{1, 0, 0});
        out.handedness = double(tangent.w) * (placed.is_mirrored() ? -1 : 1);
    }
    out.to_object = {{{linear[0].x, linear[1].x, linear[2].x},
                      {linear[0].y, linear[1].y, linear[2].y},
                      {linear[0].z, linear[1].z, linear[2].z}}};  // the inverse transpose of the cofactors
    return out;
}

const Mesh& LowSurface::mesh_of(std::uint32_t triangle) const { return parts_[first_corner(triangle).part].mesh; }

std::array<std::uint32_t, 3> LowSurface::vertices(std::uint32_t triangle) const {
    const auto [part, at] = first_corner(triangle);
    const std::uint32_t* const corner = &parts_[part].mesh.indices[at];
    return {corner[0], corner[1], corner[2]};
}

std::array<vec2, 3> LowSurface::texcoords(std::uint32_t triangle) const {
    const Block<vec2>& set = mesh_of(triangle).texcoords[set_];
    const auto [a, b, c] = vertices(triangle);
    return {set[a], set[b], set[c]};
}

bool LowSurface::is_turned(std::uint32_t number) const {
    return determinant(upper_left(parts_[first_corner(number).part].to_world)) < 0;
}

std::vector<std::uint32_t> LowSurface::map_vertices() const {
    struct Key {
        dvec3 place;
        vec2 uv;
    };
    std::vector<Key> keys;
    std::vector<std::size_t> base;
    for (const Part& part : parts_) {
        base.push_back(keys.size());
        for (std::size_t v = 0; v < part.mesh.positions.size(); ++v)
            keys.push_back(
                {transform_point(part.to_world, cast<double>(part.mesh.positions[v])), part.mesh.texcoords[set_][v]});
    }
    const auto bits = [](const Key& k) {  // of possibly invalid numbers
        return std::array{
            std::bit_cast<std::uint64_t>(k.place.x), std::bit_cast<std::uint64_t>(k.place.y),
            std::bit_cast<std::uint64_t>(k.place.z),
            std::uint64_t(std::bit_cast<std::uint32_t>(k.uv.x)) << 32 | std::bit_cast<std::uint32_t>(k.uv.y)};
    };
    std::vector<std::uint32_t> order(keys.size()), number(keys.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
        const auto x = bits(keys[a]), y = bits(keys[b]);
        return x != y ? x < y : a < b;
    });
    for (std::size_t i = 0; i < order.size(); ++i)
        number[order[i]] = i > 0 && bits(keys[order[i]]) == bits(keys[order[i - 1]]) ? number[order[i - 1]] : order[i];
    std::vector<std::uint32_t> corners;
    corners.reserve(3 * std::size_t(triangle_count()));
    for (std::size_t p = 0; p < parts_.size(); ++p)
        for (const std::uint32_t v : parts_[p].mesh.indices) corners.push_back(number[base[p] + v]);
    return corners;
}

}  // namespace rakelight::bake
