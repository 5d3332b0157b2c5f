// SPDX-License-Identifier: Apache-2.0
// Meshes of an OBJ file while they grow: unique corners, indices, smoothing groups.
#pragma once
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include <rakelight/context.h>
#include <rakelight/scene.h>

#include "base/hash_key.h"
#include "io/obj/obj_remarks.h"
#include "io/obj/obj_vertices.h"

namespace rakelight::io::obj {

/// Indices of one corner into VertexData, 0-based; `no_index` where the corner has no such thing.
struct Corner {
    std::uint32_t position = no_index, texcoord = no_index, normal = no_index;
    bool operator==(const Corner&) const = default;
};

/// Room for one more element: its growth is charged before it happens, and the old room is given back after it.
template <class T>
void make_room(std::vector<T>& array, MemoryCharge& charge) {
    if (array.size() < array.capacity()) return;
    const std::size_t before = array.capacity(), capacity = before == 0 ? 3 : 2 * before;  // most faces are triangles
    charge.grow(capacity * sizeof(T), "the faces of an OBJ file");
    array.reserve(capacity);
    charge.shrink(before * sizeof(T));
}

template <class T>
void push_charged(std::vector<T>& array, const T& value, MemoryCharge& charge) {
    make_room(array, charge);
    array.push_back(value);
}

std::uint64_t hash_of(const Corner& corner, HashKey key);

/// Numbers unique corners in order of first use. Expected O(1) a corner.
class CornerTable {
public:
    /// @param charge  grows by what the table takes more
    std::uint32_t index_of(const Corner& corner, MemoryCharge& charge);
    std::uint64_t bytes() const;  ///< of its arrays
    const std::vector<Corner>& corners() const { return corners_; }
    /// Full slots in a row: as far as a look for a corner can go.
    std::size_t longest_run() const;

private:
    void grow(MemoryCharge& charge);
    HashKey key_ = hash_key_of_this_run();
    std::vector<Corner> corners_;
    std::vector<std::uint32_t> slots_;  ///< open addressing, a power of two, at most half full
};

/// What makes a mesh: the object, the material, what is drawn, and whether its faces have normals.
struct MeshKey {
    std::uint32_t object = 0, material = no_index;
    Topology topology = Topology::triangles;
    bool has_normals = false;
    bool operator==(const MeshKey&) const = default;
};

struct GrowingMesh {
    MeshKey key;
    CornerTable table;
    std::vector<std::uint32_t> indices, smoothing;
    std::vector<std::uint32_t> polygons;  ///< Mesh::polygons up to the last face of more than three corners
    std::uint64_t bytes() const;          ///< of its arrays
};

/// All meshes of a file, in order of first use.
class MeshSet {
public:
    /// Finds or begins it; the reference holds until the next call. @param charge  grows by what a new one takes
    GrowingMesh& mesh(const MeshKey& key, MemoryCharge& charge);
    std::vector<GrowingMesh>& meshes() { return meshes_; }

private:
    struct Hash {
        std::size_t operator()(const MeshKey& key) const;
    };
    std::vector<GrowingMesh> meshes_;
    std::unordered_map<MeshKey, std::size_t, Hash> by_key_;
    std::size_t last_ = 0;
};

/// The point from which positions count: zero, unless the largest error of a used coordinate as a float is more than
/// 2^-22 of the diagonal of the box about all used positions (so where the model stands at more than about 8 times its
/// size from zero, with digits that float does not hold). Then it is the middle of the box, rounded to a multiple of
/// the largest power of two that is at most a quarter of the diagonal. One for the whole file: equal numbers stay
/// equal.
dvec3 choose_origin(const std::vector<dvec3>& positions, const std::vector<GrowingMesh>& meshes);

/// The finished mesh, whose blocks have charges of their own; `growing` is emptied.
/// @param charge  has paid for `growing` and gives back what that took
Mesh finish_mesh(GrowingMesh& growing, const VertexData& data, dvec3 origin, bool has_smoothing, Remarks& remarks,
                 MemoryCharge& charge, Context& context);

}  // namespace rakelight::io::obj
