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

/// Indices of one corner into VertexData, 0-based; `none` where the corner has no such thing.
struct Corner {
    std::uint32_t position = none, texcoord = none, normal = none;
    bool operator==(const Corner&) const = default;
};

/// A vector whose growth is charged to the budget before it happens.
template <class T>
void push_charged(std::vector<T>& array, const T& value, MemoryBudget& budget) {
    if (array.size() == array.capacity()) {
        const std::size_t capacity = array.empty() ? 16 : 2 * array.size();
        budget.charge(capacity * sizeof(T), "the faces of an OBJ file");
        array.reserve(capacity);
    }
    array.push_back(value);
}

std::uint64_t hash_of(const Corner& corner, HashKey key);

/// Numbers unique corners in order of first use. Expected O(1) a corner.
class CornerTable {
public:
    std::uint32_t index_of(const Corner& corner, MemoryBudget& budget);
    const std::vector<Corner>& corners() const { return corners_; }
    /// Full slots in a row: as far as a look for a corner can go.
    std::size_t longest_run() const;

private:
    void grow(MemoryBudget& budget);
    HashKey key_ = hash_key_of_this_run();
    std::vector<Corner> corners_;
    std::vector<std::uint32_t> slots_;  ///< open addressing, a power of two, at most half full
};

/// What makes a mesh: the object, the material, what is drawn, and whether its faces have normals.
struct MeshKey {
    std::uint32_t object = 0, material = none;
    Topology topology = Topology::triangles;
    bool has_normals = false;
    bool operator==(const MeshKey&) const = default;
};

struct GrowingMesh {
    MeshKey key;
    CornerTable table;
    std::vector<std::uint32_t> indices, smoothing;
    std::vector<std::uint32_t> polygons;  ///< Mesh::polygons up to the last face of more than three corners
};

/// All meshes of a file, in order of first use.
class MeshSet {
public:
    GrowingMesh& mesh(const MeshKey& key);  ///< finds or begins it; the reference holds until the next call
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

/// The finished mesh; `growing` is emptied. Charges its blocks to the budget.
Mesh finish_mesh(GrowingMesh& growing, const VertexData& data, dvec3 origin, bool has_smoothing, Remarks& remarks,
                 Context& context);

}  // namespace rakelight::io::obj
