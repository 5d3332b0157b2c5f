// SPDX-License-Identifier: Apache-2.0
// Memory charges for arrays and tables created by a processing step, for their lifetime.
#pragma once
#include <cstdint>
#include <memory>
#include <set>

#include <rakelight/context.h>
#include <rakelight/scene.h>

namespace rakelight {

/// Approximate overhead of a block: its record and two allocations.
constexpr std::uint64_t bytes_beside_array = 112;

/// Uncharged arrays of the scene's meshes, created by the caller. By Block::identity().
std::set<const void*> unpaid_arrays(const Scene& scene);

/// Charges the uncharged arrays of the meshes of `made`. Their creator has checked the budget before.
/// @param own  the caller's, which stay as they are
/// @throws Error bad_file: over the memory budget
void charge_new_arrays(const Scene& made, const std::set<const void*>& own, Context& context);
/// The same for one mesh, made of `source`.
void charge_new_arrays(const Mesh& made, const Mesh& source, Context& context);

/// [bytes] that a copy takes: of nodes, meshes, materials and all else but the arrays and pictures, which copies share.
std::uint64_t table_bytes(const Scene& scene);
std::uint64_t table_bytes(const Node& node);
std::uint64_t table_bytes(const Mesh& mesh);

/// Meshes that a step adds to a scene, one after another: the table is charged before it grows. The scene holds the
/// charge and must stay where it is.
class AddedMeshes {
public:
    AddedMeshes(Scene& scene, Context& context) : scene_(scene), context_(context), first_(scene.meshes.size()) {}
    /// @return its number
    /// @throws Error bad_file: over the memory budget
    std::uint32_t add(Mesh mesh);
    std::uint32_t count() const { return std::uint32_t(scene_.meshes.size() - first_); }

private:
    void make_room();

    Scene& scene_;
    Context& context_;
    const std::size_t first_;  ///< meshes that were there before, and are paid
    std::shared_ptr<MemoryCharge> charge_;
    std::uint64_t room_bytes_ = 0;  ///< of the charge: for the table beyond `first_`
};

}  // namespace rakelight
