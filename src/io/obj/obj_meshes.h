// SPDX-License-Identifier: Apache-2.0
// Meshes of an OBJ file: which elements make one, and the finished ones.
#pragma once
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

#include "io/obj/chunk_elements.h"

namespace rakelight::io::obj {

/// Room for one more element: its growth is charged before it happens, and the old room is given back after it.
template <class T>
void make_room(std::vector<T>& array, MemoryCharge& charge) {
    if (array.size() < array.capacity()) return;
    const std::size_t before = array.capacity(), capacity = before == 0 ? 3 : 2 * before;
    charge.grow(capacity * sizeof(T), "the faces of an OBJ file");
    array.reserve(capacity);
    charge.shrink(before * sizeof(T));
}

/// What makes a mesh: the object, the material, what is drawn, and whether its faces have normals.
struct MeshKey {
    std::uint32_t object = 0, material = no_index;
    Topology topology = Topology::triangles;
    bool has_normals = false;
    bool operator==(const MeshKey&) const = default;
};

/// A mesh as it was read.
struct ReadMesh {
    MeshKey key;
    std::uint64_t index_count = 0;
    bool has_polygons = false;                      ///< of more than three corners
    std::vector<Corner> corners;                    ///< each once, in order of first use
    std::vector<std::uint32_t> indices, smoothing;  ///< smoothing: a group a triangle, in files with `s`
    std::vector<std::uint32_t> polygons;            ///< Mesh::polygons
    std::uint64_t bytes() const;                    ///< of its arrays
};

/// Where a run of a chunk went: into a mesh, from this place of its indices on.
struct RunPlace {
    std::size_t mesh = 0, first_index = 0;
};

struct ChunkPlaces {
    std::vector<RunPlace> runs;
    std::uint32_t smoothing_before = 0;  ///< the smoothing group that is in force where the chunk begins
};

/// Numbers meshes in order of first use.
class MeshNumbers {
public:
    /// Finds or begins one. @param charge  grows by what a new one takes
    std::size_t number_of(const MeshKey& key, std::vector<ReadMesh>& meshes, MemoryCharge& charge);

private:
    struct Hash {
        std::size_t operator()(const MeshKey& key) const;
    };
    std::unordered_map<MeshKey, std::size_t, Hash> by_key_;
    std::size_t last_ = 0;
};

/// The point from which positions count: position_origin() of all used ones. One for the whole file: equal numbers stay
/// equal.
dvec3 choose_origin(const std::vector<dvec3>& positions, const std::vector<ReadMesh>& meshes, Context& context);

/// The finished mesh, whose blocks have charges of their own; `read` is emptied.
/// @param charge  has paid for `read` and gives back what that took
Mesh finish_mesh(ReadMesh& read, const VertexData& data, dvec3 origin, Remarks& remarks, MemoryCharge& charge,
                 Context& context);

}  // namespace rakelight::io::obj
