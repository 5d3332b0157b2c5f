// SPDX-License-Identifier: Apache-2.0
#include "io/obj/obj_meshes.h"

#include <algorithm>
#include <cmath>

namespace rakelight::io::obj {
namespace {

template <class T>
std::vector<T> reserved(std::size_t count, Context& context) {
    context.memory().charge(count * sizeof(T), "the meshes of an OBJ file");
    std::vector<T> array;
    array.reserve(count);
    return array;
}

}  // namespace

std::uint64_t hash_of(const Corner& c, HashKey key) {
    return folded_product((std::uint64_t(c.position) << 32 | c.texcoord) ^ key.a, c.normal ^ key.b);
}

std::uint32_t CornerTable::index_of(const Corner& corner, MemoryBudget& budget) {
    if (2 * (corners_.size() + 1) > slots_.size()) grow(budget);
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t slot = hash_of(corner, key_) & mask;; slot = (slot + 1) & mask) {
        if (slots_[slot] == none) {
            if (corners_.size() >= none - 1)
                throw Error(ErrorCode::bad_file, "a mesh has more than 4294967294 vertices");
            slots_[slot] = std::uint32_t(corners_.size());
            push_charged(corners_, corner, budget);
            return slots_[slot];
        }
        if (corners_[slots_[slot]] == corner) return slots_[slot];
    }
}

void CornerTable::grow(MemoryBudget& budget) {
    const std::size_t size = std::max<std::size_t>(16, 2 * slots_.size());
    budget.charge(size * sizeof(std::uint32_t), "the faces of an OBJ file");
    slots_.assign(size, none);
    for (std::uint32_t i = 0; i < corners_.size(); ++i) {
        std::size_t slot = hash_of(corners_[i], key_) & (size - 1);
        while (slots_[slot] != none) slot = (slot + 1) & (size - 1);
        slots_[slot] = i;
    }
}

std::size_t CornerTable::longest_run() const {
    std::size_t longest = 0, run = 0;
    for (const std::uint32_t slot : slots_) longest = std::max(longest, run = slot == none ? 0 : run + 1);
    return longest;
}

std::size_t MeshSet::Hash::operator()(const MeshKey& key) const {
    const std::uint64_t kind = std::uint64_t(key.topology) << 1 | std::uint64_t(key.has_normals);
    const HashKey secret = hash_key_of_this_run();
    return std::size_t(folded_product((std::uint64_t(key.object) << 32 | key.material) ^ secret.a, kind ^ secret.b));
}

GrowingMesh& MeshSet::mesh(const MeshKey& key) {
    if (last_ < meshes_.size() && meshes_[last_].key == key) return meshes_[last_];
    const auto [entry, is_new] = by_key_.try_emplace(key, meshes_.size());
    if (is_new) {
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
                 Context& context) {
    const std::vector<Corner>& corners = growing.table.corners();
    const auto has = [&](auto&& test) { return std::any_of(corners.begin(), corners.end(), test); };
    const bool has_texcoords = has([](const Corner& c) { return c.texcoord != none; });
    const bool has_colors = !data.colors.empty() && has([&](const Corner& c) { return data.has_color[c.position]; });
    Mesh mesh;
    mesh.topology = growing.key.topology;
    mesh.material = growing.key.material;
    mesh.origin = origin;

    auto positions = reserved<vec3>(corners.size(), context);
    for (const Corner& c : corners) {
        const dvec3 p = data.positions[c.position];
        positions.push_back({float(p.x - origin.x), float(p.y - origin.y), float(p.z - origin.z)});
    }
    mesh.positions = std::move(positions);
    if (growing.key.has_normals) {
        auto normals = reserved<vec3>(corners.size(), context);
        for (const Corner& c : corners) normals.push_back(data.normals[c.normal]);
        mesh.normals = std::move(normals);
    }
    if (has_texcoords) {
        auto texcoords = reserved<vec2>(corners.size(), context);
        for (const Corner& c : corners) texcoords.push_back(c.texcoord != none ? data.texcoords[c.texcoord] : vec2{});
        mesh.texcoords.push_back(std::move(texcoords));
        if (has([](const Corner& c) { return c.texcoord == none; })) remarks.add(Issue::texcoords_missing, 0);
    }
    if (has_colors) {
        auto colors = reserved<vec4>(corners.size(), context);
        for (const Corner& c : corners) colors.push_back(data.colors[c.position]);
        mesh.colors = std::move(colors);
    }
    growing.indices.shrink_to_fit();
    mesh.indices = std::move(growing.indices);
    if (has_smoothing && mesh.topology == Topology::triangles) {
        growing.smoothing.shrink_to_fit();
        mesh.smoothing = std::move(growing.smoothing);
        mesh.smoothing_kind = SmoothingKind::numbers;
    }
    if (!growing.polygons.empty()) {
        for (std::size_t t = growing.polygons.size(); t < mesh.triangle_count(); ++t)
            push_charged(growing.polygons, std::uint32_t(t), context.memory());
        growing.polygons.shrink_to_fit();
        mesh.polygons = std::move(growing.polygons);
    }
    growing.table = {};
    return mesh;
}

}  // namespace rakelight::io::obj
