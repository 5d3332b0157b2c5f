// SPDX-License-Identifier: Apache-2.0
#include "io/obj/obj_meshes.h"

#include <algorithm>
#include <cmath>

namespace rakelight::io::obj {
namespace {

template <class T>
MemoryCharge charge_for(std::size_t count, Context& context) {
    return {context.memory(), count * sizeof(T), "the meshes of an OBJ file"};
}

/// What `of` makes of each corner.
template <class T, class Of>
Block<T> block_of(const std::vector<Corner>& corners, Context& context, const Of& of) {
    MemoryCharge charge = charge_for<T>(corners.size(), context);
    std::vector<T> array;
    array.reserve(corners.size());
    for (const Corner& c : corners) array.push_back(of(c));
    return {std::move(array), std::move(charge)};
}

/// A grown array without its spare room. What it has taken so far is given back by the caller.
template <class T>
Block<T> fitted(std::vector<T>& array, Context& context) {
    MemoryCharge charge = charge_for<T>(array.size(), context);
    array.shrink_to_fit();
    return {std::move(array), std::move(charge)};
}

}  // namespace

/// An entry of MeshSet::by_key_ and its share of the buckets.
constexpr std::uint64_t table_bytes = sizeof(MeshKey) + 48;

std::uint64_t hash_of(const Corner& c, HashKey key) {
    return folded_product((std::uint64_t(c.position) << 32 | c.texcoord) ^ key.a, c.normal ^ key.b);
}

std::uint32_t CornerTable::index_of(const Corner& corner, MemoryCharge& charge) {
    if (2 * (corners_.size() + 1) > slots_.size()) grow(charge);
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t slot = hash_of(corner, key_) & mask;; slot = (slot + 1) & mask) {
        if (slots_[slot] == no_index) {
            if (corners_.size() >= no_index - 1)
                throw Error(ErrorCode::bad_file, "a mesh has more than 4294967294 vertices");
            slots_[slot] = std::uint32_t(corners_.size());
            push_charged(corners_, corner, charge);
            return slots_[slot];
        }
        if (corners_[slots_[slot]] == corner) return slots_[slot];
    }
}

void CornerTable::grow(MemoryCharge& charge) {
    const std::size_t before = slots_.capacity(), size = std::max<std::size_t>(8, 2 * slots_.size());
    charge.grow(size * sizeof(std::uint32_t), "the faces of an OBJ file");
    slots_ = std::vector<std::uint32_t>(size, no_index);
    charge.shrink(before * sizeof(std::uint32_t));
    for (std::uint32_t i = 0; i < corners_.size(); ++i) {
        std::size_t slot = hash_of(corners_[i], key_) & (size - 1);
        while (slots_[slot] != no_index) slot = (slot + 1) & (size - 1);
        slots_[slot] = i;
    }
}

std::uint64_t CornerTable::bytes() const {
    return corners_.capacity() * sizeof(Corner) + slots_.capacity() * sizeof(std::uint32_t);
}

std::uint64_t GrowingMesh::bytes() const {
    return table.bytes() + (indices.capacity() + smoothing.capacity() + polygons.capacity()) * sizeof(std::uint32_t);
}

std::size_t CornerTable::longest_run() const {
    std::size_t longest = 0, run = 0;
    for (const std::uint32_t slot : slots_) longest = std::max(longest, run = slot == no_index ? 0 : run + 1);
    return longest;
}

std::size_t MeshSet::Hash::operator()(const MeshKey& key) const {
    const std::uint64_t kind = std::uint64_t(key.topology) << 1 | std::uint64_t(key.has_normals);
    const HashKey secret = hash_key_of_this_run();
    return std::size_t(folded_product((std::uint64_t(key.object) << 32 | key.material) ^ secret.a, kind ^ secret.b));
}

GrowingMesh& MeshSet::mesh(const MeshKey& key, MemoryCharge& charge) {
    if (last_ < meshes_.size() && meshes_[last_].key == key) return meshes_[last_];
    const auto [entry, is_new] = by_key_.try_emplace(key, meshes_.size());
    if (is_new) {
        charge.grow(table_bytes, "the meshes of an OBJ file");
        make_room(meshes_, charge);
        meshes_.emplace_back();
        meshes_.back().key = key;
    }
    last_ = entry->second;
    return meshes_[last_];
}

dvec3 choose_origin(const std::vector<dvec3>& positions, const std::vector<GrowingMesh>& meshes) {
    dvec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    double error = 0;
    for (const GrowingMesh& m : meshes)
        for (const Corner& c : m.table.corners())
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double x = positions[c.position][axis];
                if (!std::isfinite(x)) continue;
                low[axis] = std::min(low[axis], x);
                high[axis] = std::max(high[axis], x);
                error = std::max(error, std::abs(double(float(x)) - x));
            }
    dvec3 origin, extent;
    for (std::size_t axis = 0; axis < 3; ++axis) extent[axis] = std::max(0.0, high[axis] - low[axis]);
    const double diagonal = std::sqrt(extent.x * extent.x + extent.y * extent.y + extent.z * extent.z);
    if (!(diagonal > 0) || error <= std::ldexp(diagonal, -22)) return origin;
    int exponent = 0;
    std::frexp(diagonal, &exponent);  // diagonal is in [2^(exponent - 1), 2^exponent)
    const double unit = std::ldexp(1.0, exponent - 3);
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (low[axis] <= high[axis]) origin[axis] = std::floor((low[axis] + high[axis]) / 2 / unit + 0.5) * unit;
    return origin;
}

Mesh finish_mesh(GrowingMesh& growing, const VertexData& data, dvec3 origin, bool has_smoothing, Remarks& remarks,
                 MemoryCharge& charge, Context& context) {
    const std::vector<Corner>& corners = growing.table.corners();
    const auto has = [&](auto&& test) { return std::any_of(corners.begin(), corners.end(), test); };
    const bool has_texcoords = has([](const Corner& c) { return c.texcoord != no_index; });
    const bool has_colors = !data.colors.empty() && has([&](const Corner& c) { return data.has_color[c.position]; });
    Mesh mesh;
    mesh.topology = growing.key.topology;
    mesh.material = growing.key.material;
    mesh.origin = origin;

    mesh.positions = block_of<vec3>(corners, context, [&](const Corner& c) {
        const dvec3 p = data.positions[c.position];
        return vec3{float(p.x - origin.x), float(p.y - origin.y), float(p.z - origin.z)};
    });
    if (growing.key.has_normals)
        mesh.normals = block_of<vec3>(corners, context, [&](const Corner& c) { return data.normals[c.normal]; });
    if (has_texcoords) {
        mesh.texcoords.push_back(block_of<vec2>(corners, context, [&](const Corner& c) {
            return c.texcoord != no_index ? data.texcoords[c.texcoord] : vec2{};
        }));
        if (has([](const Corner& c) { return c.texcoord == no_index; })) remarks.add(Issue::texcoords_missing, 0);
    }
    if (has_colors)
        mesh.colors = block_of<vec4>(corners, context, [&](const Corner& c) { return data.colors[c.position]; });
    const std::size_t triangles = mesh.topology == Topology::triangles ? growing.indices.size() / 3 : 0;
    if (!growing.polygons.empty())
        for (std::size_t t = growing.polygons.size(); t < triangles; ++t)
            push_charged(growing.polygons, std::uint32_t(t), charge);
    const std::uint64_t held = growing.bytes();
    mesh.indices = fitted(growing.indices, context);
    if (has_smoothing && mesh.topology == Topology::triangles) {
        mesh.smoothing = fitted(growing.smoothing, context);
        mesh.smoothing_kind = SmoothingKind::numbers;
    }
    if (!growing.polygons.empty()) mesh.polygons = fitted(growing.polygons, context);
    const MeshKey key = growing.key;
    growing = {};
    growing.key = key;
    charge.shrink(held);
    return mesh;
}

}  // namespace rakelight::io::obj
