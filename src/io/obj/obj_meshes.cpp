// SPDX-License-Identifier: Apache-2.0
#include "io/obj/obj_meshes.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "io/obj/parallel_ranges.h"
#include "io/position_origin.h"

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
    std::vector<T> array(corners.size());
    parallel_ranges(corners.size(), context, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) array[i] = of(corners[i]);
    });
    return {std::move(array), std::move(charge)};
}

/// An array that was read. What it has taken so far is given back by the caller.
template <class T>
Block<T> block_from(std::vector<T>& array, Context& context) {
    MemoryCharge charge = charge_for<T>(array.size(), context);
    return {std::move(array), std::move(charge)};
}

template <class Test>
bool any_corner(const std::vector<Corner>& corners, Context& context, const Test& test) {
    std::atomic<bool> found{false};
    parallel_ranges(corners.size(), context, [&](std::size_t begin, std::size_t end) {
        if (!found && std::any_of(corners.data() + begin, corners.data() + end, test)) found = true;
    });
    return found;
}

/// An entry of MeshNumbers::by_key_ and its share of the buckets.
constexpr std::uint64_t table_bytes = sizeof(MeshKey) + 48;

/// The box about positions, and the largest error of a coordinate as a float.
struct Extent {
    dvec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    double error = 0;

    void add(const dvec3& p) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double x = p[axis];
            if (!std::isfinite(x)) continue;
            low[axis] = std::min(low[axis], x);
            high[axis] = std::max(high[axis], x);
            error = std::max(error, std::abs(double(float(x)) - x));
        }
    }
    void add(const Extent& e) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], e.low[axis]);
            high[axis] = std::max(high[axis], e.high[axis]);
        }
        error = std::max(error, e.error);
    }
};

/// Of what the meshes use. Least and largest values: the order of the parts does not count.
Extent extent_of(const std::vector<dvec3>& positions, const std::vector<ReadMesh>& meshes, Context& context) {
    Extent all;
    std::mutex mutex;
    for (const ReadMesh& mesh : meshes)
        parallel_ranges(mesh.corners.size(), context, [&](std::size_t begin, std::size_t end) {
            Extent part;
            for (std::size_t i = begin; i < end; ++i) part.add(positions[mesh.corners[i].position]);
            const std::lock_guard lock(mutex);
            all.add(part);
        });
    return all;
}

}  // namespace

std::uint64_t ReadMesh::bytes() const {
    return corners.capacity() * sizeof(Corner) +
           (indices.capacity() + smoothing.capacity() + polygons.capacity()) * sizeof(std::uint32_t);
}

std::size_t MeshNumbers::Hash::operator()(const MeshKey& key) const {
    const std::uint64_t kind = std::uint64_t(key.topology) << 1 | std::uint64_t(key.has_normals);
    const HashKey secret = hash_key_of_this_run();
    return std::size_t(folded_product((std::uint64_t(key.object) << 32 | key.material) ^ secret.a, kind ^ secret.b));
}

std::size_t MeshNumbers::number_of(const MeshKey& key, std::vector<ReadMesh>& meshes, MemoryCharge& charge) {
    if (last_ < meshes.size() && meshes[last_].key == key) return last_;
    const auto [entry, is_new] = by_key_.try_emplace(key, meshes.size());
    if (is_new) {
        charge.grow(table_bytes, "the meshes of an OBJ file");
        make_room(meshes, charge);
        meshes.emplace_back();
        meshes.back().key = key;
    }
    return last_ = entry->second;
}

dvec3 choose_origin(const std::vector<dvec3>& positions, const std::vector<ReadMesh>& meshes, Context& context) {
    const Extent used = extent_of(positions, meshes, context);
    return position_origin(used.low, used.high, used.error);
}

Mesh finish_mesh(ReadMesh& read, const VertexData& data, dvec3 origin, Remarks& remarks, MemoryCharge& charge,
                 Context& context) {
    const std::vector<Corner>& corners = read.corners;
    const auto has = [&](auto&& test) { return any_corner(corners, context, test); };
    const bool has_texcoords = has([](const Corner& c) { return c.texcoord != no_index; });
    const bool has_colors =
        !data.colors.empty() && has([&](const Corner& c) { return data.has_color[c.position] != 0; });
    Mesh mesh;
    mesh.topology = read.key.topology;
    mesh.material = read.key.material;
    mesh.origin = origin;

    mesh.positions = block_of<vec3>(corners, context, [&](const Corner& c) {
        const dvec3 p = data.positions[c.position];
        return vec3{float(p.x - origin.x), float(p.y - origin.y), float(p.z - origin.z)};
    });
    if (read.key.has_normals)
        mesh.normals = block_of<vec3>(corners, context, [&](const Corner& c) { return data.normals[c.normal]; });
    if (has_texcoords) {
        mesh.texcoords.push_back(block_of<vec2>(corners, context, [&](const Corner& c) {
            return c.texcoord != no_index ? data.texcoords[c.texcoord] : vec2{};
        }));
        if (has([](const Corner& c) { return c.texcoord == no_index; })) remarks.add(Issue::texcoords_missing, 0);
    }
    if (has_colors)
        mesh.colors = block_of<vec4>(corners, context, [&](const Corner& c) { return data.colors[c.position]; });
    const std::uint64_t held = read.bytes();
    mesh.indices = block_from(read.indices, context);
    if (!read.smoothing.empty()) {
        mesh.smoothing = block_from(read.smoothing, context);
        mesh.smoothing_kind = SmoothingKind::numbers;
    }
    if (!read.polygons.empty()) mesh.polygons = block_from(read.polygons, context);
    const MeshKey key = read.key;
    read = {};
    read.key = key;
    charge.shrink(held);
    return mesh;
}

}  // namespace rakelight::io::obj
