// SPDX-License-Identifier: Apache-2.0
// Meshes of instances that came out differently: the first result takes the mesh's place, others get a mesh of their own.
#pragma once
#include <cstdint>
#include <vector>

#include <rakelight/scene.h>

#include "scene/charge_arrays.h"

namespace rakelight {

/// One placement of one mesh: slot `slot` of node `node` shows mesh `mesh` (as numbered in the scene before the change).
struct Instance {
    std::uint32_t node = 0, slot = 0, mesh = 0;
};

/// All placements of triangle meshes that have triangles, in the order of nodes and slots.
std::vector<Instance> drawn_instances(const Scene& scene);

/// Puts results for instances into a scene, keeping meshes shared where the results are the same.
class MeshVariants {
public:
    /// @param keep_shared  no mesh gets a copy: instances with other results show the first one's
    MeshVariants(Scene& scene, Context& context, bool keep_shared = false)
        : scene_(scene), added_(scene, context), keep_shared_(keep_shared), made_(scene.meshes.size()) {}
    /// The instance shows `result` from now on: in place of its mesh when it is the first of that mesh, shared with an
    /// earlier instance where `result` is the same as that one's (see same_surface), else as a new mesh (or that of the
    /// first, where meshes are kept shared).
    /// @return the mesh's number
    /// @throws Error bad_file: over the memory budget
    std::uint32_t place(const Instance& instance, Mesh result);
    /// The instance shows the mesh `number` that place() returned for another instance of the same mesh.
    void share(const Instance& instance, std::uint32_t number);
    std::uint32_t copies() const { return added_.count(); }  ///< meshes that had to be added
    std::uint32_t kept() const { return kept_; }  ///< results that were not put in force, since meshes stay shared

private:
    Scene& scene_;
    AddedMeshes added_;
    bool keep_shared_;
    std::vector<std::vector<std::uint32_t>> made_;  ///< [meshes] the results of each, the first in its place
    std::uint32_t kept_ = 0;
};

/// Same triangles, and normals, tangents and texture coordinates that differ by rounding at most (2e-6 in each number): the
/// same surface at a rotated place comes back from the world with other last bits. w of tangents must be equal.
bool same_surface(const Mesh& a, const Mesh& b);

}  // namespace rakelight
