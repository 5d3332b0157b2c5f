// SPDX-License-Identifier: Apache-2.0
// Results per instance: the first result replaces the mesh, different ones become new meshes.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/geometry/attributes.h>
#include <rakelight/scene/scene.h>

#include "scene/charge_arrays.h"

namespace rakelight {

/// One instance: slot `slot` of node `node` has mesh `mesh` (index in the scene before the change).
struct Instance {
    std::uint32_t node = 0, slot = 0, mesh = 0;
};

/// All instances of non-empty triangle meshes, in the order of nodes and slots.
std::vector<Instance> drawn_instances(const Scene& scene);

/// Stores results of instances in a scene; meshes with equal results stay shared.
class MeshVariants {
public:
    /// @param keep_shared meshes are never copied: instances with other results use the first one's
    MeshVariants(Scene& scene, Context& context, bool keep_shared = false)
        : scene_(scene), added_(scene, context), keep_shared_(keep_shared), made_(scene.meshes.size()) {}
    /// Sets the result of an instance. The first result of a mesh replaces the mesh. Later ones share an equal earlier
    /// result (see same_surface), or become a new mesh (or use the first, with `keep_shared`).
    /// @return index of the mesh
    /// @throws Error bad_file: over the memory budget
    std::uint32_t place(const Instance& instance, Mesh result);
    /// Uses the mesh `number` that place() returned for another instance of the same mesh.
    void share(const Instance& instance, std::uint32_t number);
    std::uint32_t copies() const { return added_.count(); }  ///< number of added meshes
    std::uint32_t kept() const { return kept_; }             ///< results discarded by `keep_shared`

private:
    Scene& scene_;
    AddedMeshes added_;
    bool keep_shared_;
    std::vector<std::vector<std::uint32_t>> made_;  ///< [meshes] the results of each, the first in its place
    std::uint32_t kept_ = 0;
};

/// [results] The first result of the same mesh with a same_surface(), or the result itself.
/// @param numbers  [results] their meshes
std::vector<std::size_t> first_alike(std::span<const std::uint32_t> numbers, std::span<const MeshAttributes> results);

/// Same triangles, and normals, tangents and texture coordinates that differ by rounding at most (2e-6 in each number):
/// rotated instances of the same surface differ in the last bits. w of tangents must be equal.
bool same_surface(const Mesh& a, const Mesh& b);

}  // namespace rakelight
