// SPDX-License-Identifier: Apache-2.0
// Meshes on the GPU: their arrays as buffers, and as textures for streams without indices. Kept by the identity of blocks.
#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include <rakelight/scene/scene.h>

#include "engines/opengl/context/driver.h"
#include "engines/opengl/context/gl_objects.h"
#include "geometry/pose/mesh_pose.h"

namespace rakelight::opengl {

/// A mesh whose triangles per vertex stage can look up.
struct TriangleTable {
    GlTexture indices, vertices;
    std::int32_t against = -1;  ///< [texels] where its bits begin; -1: none
};

/// Where vertices of a mesh stand that were posed on the GPU (poses.h).
struct PosedBuffers {
    GlBuffer positions, normals, tangents;  ///< the last two where the mesh has them
    GlVertexArray draw;
};

class MeshStore {
public:
    explicit MeshStore(const Driver& driver) : driver_(driver) {}

    /// Drops what the scene has no more. @throws Error failed: no memory on the GPU
    void keep_only(const Scene& scene, const geometry::MeshPoses& poses);
    /// Bound with its buffers and indices. Uploads what is not there yet. @param posed  null: as its arrays are
    GLuint vertex_array(const Mesh& mesh, PosedBuffers* posed);
    /// Whether all its buffers hold their arrays. @param pose  its influences go with them; null: none
    bool is_there(const Mesh& mesh, const geometry::MeshPose* pose = nullptr) const;
    /// A part of an array that does not exist yet, at most so many bytes.
    void upload_piece(const Mesh& mesh, const geometry::MeshPose* pose = nullptr);
    /// The places 0 to 2 of the vertex array that is bound. What they read is there.
    void set_vertices(const Mesh& mesh, const PosedBuffers* posed = nullptr);
    template <class T>
    GLuint buffer_of(const Block<T>& block) const {
        return block.empty() ? 0 : buffers_.at(block.identity()).name.name();
    }
    static constexpr std::size_t piece_bytes = 8 << 20;
    static constexpr std::size_t checked_bytes = 64 << 10;  ///< pieces as large as this are asked whether they are there
    std::uint64_t bytes() const;                     ///< of all buffers that it holds
    GLuint no_arrays() { return no_arrays_.get(); }  ///< a vertex array without any
    /// @param against  [triangles] LitSide::against(), the same for all draws of a mesh; null: none is requested
    const TriangleTable& table(const Mesh& mesh, const std::int32_t* against);

private:
    /// An array on its way.
    struct Part {
        const void *identity, *data;
        std::size_t bytes;
        GLenum target;  ///< WebGL: a buffer stays of the kind that it was bound as first
        std::function<std::shared_ptr<const void>()> owner;
    };
    static std::vector<Part> parts_of(const Mesh& mesh, const geometry::MeshPose* pose);
    void upload_piece(const Part& part);

    using Key = std::vector<const void*>;  ///< identities of its blocks
    static Key key_of(const Mesh& mesh);

    const Driver& driver_;
    struct Buffer {
        std::shared_ptr<const void> of;  ///< keeps the identity its own
        GlBuffer name;
        std::size_t there = 0;  ///< [bytes]
    };
    std::map<const void*, Buffer> buffers_;
    std::map<Key, GlVertexArray> arrays_;
    std::map<Key, TriangleTable> tables_;
    GlVertexArray no_arrays_;
};

}  // namespace rakelight::opengl
