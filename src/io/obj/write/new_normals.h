// SPDX-License-Identifier: Apache-2.0
// Which normals the faces of an OBJ file get, and where their `vn` lines go.
#pragma once
#include <bit>
#include <cstdint>
#include <vector>

#include "io/obj/obj_faces.h"

namespace rakelight::io::obj {

/// A normal by its bits.
struct NormalBits {
    std::uint32_t x = 0, y = 0, z = 0;
    bool operator==(const NormalBits&) const = default;
    vec3 normal() const { return {std::bit_cast<float>(x), std::bit_cast<float>(y), std::bit_cast<float>(z)}; }
};

inline std::uint64_t hash_of(const NormalBits& n, HashKey key) {
    return folded_product((std::uint64_t(n.x) << 32 | n.y) ^ key.a, n.z ^ key.b);
}

/// The normals of one object, each once, in order of first use.
struct NormalBlock {
    std::vector<NormalBits> normals;
    std::size_t at = 0;       ///< where in the file its lines go: the first byte of a line
    std::uint64_t first = 0;  ///< normals in the blocks before
};

/// The faces of one chunk with their normals.
struct ChunkNormals {
    std::vector<std::uint32_t> object;   ///< [faces] of ChunkElements
    std::vector<std::uint32_t> numbers;  ///< [corners of all faces] in the object's block
};

struct NewNormals {
    std::vector<NormalBlock> blocks;       ///< [objects]
    std::vector<std::size_t> write_order;  ///< the blocks of objects with faces, as they come in the file
    std::vector<ChunkNormals> chunks;      ///< of Elements::chunks
    bool is_changed = false;               ///< some corner had another normal, or none
    MemoryCharge charge;
};

/// @param elements  with their chunks
/// @param after     the scene that obj_reader makes of the file, with other normals and splits
/// @throws Error failed: the scene does not fit the file; bad_file: over the memory limit
NewNormals choose_normals(const Elements& elements, const Contents& contents, const VertexData& data,
                          const Scene& after, Context& context);

}  // namespace rakelight::io::obj
