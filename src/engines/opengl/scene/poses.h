// SPDX-License-Identifier: Apache-2.0
// Skins and morph targets on the GPU: transform feedback writes vertices as they stand into the buffers that programs read.
// Bind pose, influences and offsets stay there from moment to moment, and so do the buffers; joints and weights come again.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include <rakelight/scene/scene.h>

#include "engines/opengl/programs/program_text.h"
#include "engines/opengl/scene/meshes.h"
#include "geometry/pose/mesh_pose.h"

namespace rakelight::opengl {

class PoseStore {
public:
    explicit PoseStore(const Driver& driver) : driver_(driver) {}

    /// Whether the driver's textures hold the offsets and joints of a mesh.
    bool fits(const geometry::MeshPose& pose) const;
    /// Another moment: nothing stands yet. Drops what belongs to other meshes.
    void keep_only(const geometry::MeshPoses& poses);
    /// Vertices of all that fit and do not stand yet. `meshes` has their arrays, or uploads them.
    /// @throws Error failed: no memory on the GPU
    void pose(const Scene& scene, const geometry::MeshPoses& poses, MeshStore& meshes);
    /// A mesh that is posed elsewhere.
    void drop(std::uint32_t mesh) { posed_.erase(mesh); }
    /// What pose() wrote; null: it wrote nothing of this mesh.
    PosedBuffers* of(std::uint32_t mesh);
    std::uint64_t bytes() const;  ///< of all buffers and textures that it holds

private:
    using Identities = std::array<const void*, 6>;  ///< of blocks
    /// Of the targets; meshes with the same targets share them.
    struct Offsets {
        GlTexture texture;  ///< none: there are no offsets
        std::uint64_t bytes = 0;
    };
    using OffsetsKey = std::pair<const void*, PoseFeatures>;  ///< by MeshPose::targets
    struct Posed {
        PosedBuffers buffers;
        GlVertexArray bind;
        geometry::MeshPose of;  ///< keeps the identities of its blocks their own
        std::shared_ptr<const Offsets> offsets;
        bool stands = false;
    };
    struct Program {
        GlProgram name;
        GLint pose = -1;
    };
    /// Where a mesh's numbers stand in the moment's table.
    struct Place {
        GLint first_target, targets, first_joint;
    };
    static Identities arrays_of(const geometry::MeshPose& pose);
    Posed& posed_of(std::uint32_t number, const geometry::MeshPose& pose, const Mesh& mesh, MeshStore& meshes);
    std::shared_ptr<const Offsets> offsets_of(const geometry::MeshPose& pose);
    static void bind_attributes(Posed& posed, const Mesh& mesh, MeshStore& meshes);
    std::map<std::uint32_t, Place> upload_numbers(const geometry::MeshPoses& poses,
                                                  const std::vector<std::uint32_t>& numbers);
    const Program& program_of(const PoseFeatures& features);
    void bind_frame();
    void run(const Posed& posed, const Place& place);

    const Driver& driver_;
    std::map<std::uint32_t, Posed> posed_;  ///< by mesh
    std::map<OffsetsKey, std::weak_ptr<const Offsets>> offsets_;
    std::map<PoseFeatures, Program> programs_;
    GlTexture numbers_, no_offsets_;
    GlRenderbuffer pixel_;
    GlFramebuffer frame_;  ///< of one pixel that nothing is drawn into
    std::uint64_t numbers_bytes_ = 0;
};

}  // namespace rakelight::opengl
