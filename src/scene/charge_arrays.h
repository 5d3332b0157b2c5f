// SPDX-License-Identifier: Apache-2.0
// Memory charges for arrays and tables created by a processing step, for their lifetime.
#pragma once
#include <cstdint>
#include <memory>
#include <set>
#include <span>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// Approximate overhead of a block: its record and two allocations.
constexpr std::uint64_t bytes_beside_array = 112;
/// What stages make for each node while they work: matrices of four stages, an instance. The reader of glTF, where a few
/// bytes make millions of nodes, charges it with the node.
constexpr std::uint64_t bytes_beside_node = 4 * sizeof(dmat4) + 32;

/// Uncharged arrays of the scene's meshes, created by the caller. By Block::identity().
std::set<const void*> unpaid_arrays(const Scene& scene);

/// Charges the uncharged arrays of the meshes of `made`. Their creator has checked the budget before.
/// @param own arrays of the caller, which are not charged
/// @throws Error bad_file: over the memory budget
void charge_new_arrays(const Scene& made, const std::set<const void*>& own, Context& context);
/// The same for one mesh, made of `source`.
void charge_new_arrays(const Mesh& made, const Mesh& source, Context& context);

/// [bytes] that a copy takes: of tables such as nodes, meshes and materials, without the shared arrays and pictures.
std::uint64_t table_bytes(const Scene& scene);
std::uint64_t table_bytes(const Node& node);
std::uint64_t table_bytes(const Mesh& mesh);
std::uint64_t table_bytes(std::span<const MorphTarget> targets);

/// A copy that holds the charge of its tables.
/// @throws Error bad_file: over the memory budget
Scene charged_copy(const Scene& scene, Context& context);

/// Appends meshes to a scene and charges the table before it grows. The scene holds the charge and must not be moved.
class AddedMeshes {
public:
    AddedMeshes(Scene& scene, Context& context) : scene_(scene), context_(context), first_(scene.meshes.size()) {}
    /// @return its index
    /// @throws Error bad_file: over the memory budget
    std::uint32_t add(Mesh mesh);
    std::uint32_t count() const { return std::uint32_t(scene_.meshes.size() - first_); }

private:
    void make_room();

    Scene& scene_;
    Context& context_;
    const std::size_t first_;  ///< number of earlier meshes, already charged
    std::shared_ptr<MemoryCharge> charge_;
    std::uint64_t room_bytes_ = 0;  ///< of the charge: for the table beyond `first_`
};

}  // namespace rakelight
