// SPDX-License-Identifier: Apache-2.0
#include "prepare/normals/bind_pose.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <string>
#include <tuple>

#include <rakelight/base/error.h>
#include <rakelight/base/report.h>

#include "base/cancel_check.h"
#include "base/format_text.h"
#include "math/linear.h"
#include "scene/placement.h"

namespace rakelight {
namespace {

constexpr float weight_slack = 0.01f;  // error of 8-bit weights

/// [skins] for each joint, whether it influences a drawn vertex.
std::vector<std::vector<bool>> used_joints(const Scene& scene) {
    std::vector<std::vector<bool>> used(scene.skins.size());
    for (std::size_t s = 0; s < used.size(); ++s) used[s].assign(scene.skins[s].joints.size(), false);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> seen;  // skin, mesh: each mesh is checked once
    for (const Instance& instance : drawn_instances(scene))
        if (const std::uint32_t skin = scene.nodes[instance.node].skin; skin != no_index)
            seen.emplace_back(skin, instance.mesh);
    std::sort(seen.begin(), seen.end());
    seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
    for (const auto& [skin, mesh] : seen)
        for (const Block<JointInfluence>* block : {&scene.meshes[mesh].influences, &scene.meshes[mesh].more_influences})
            for (const JointInfluence& influence : *block)
                for (std::size_t k = 0; k < 4; ++k)
                    if (influence.weights[k] != 0) used[skin][influence.joints[k]] = true;
    return used;
}

/// Restores the bottom row 0, 0, 0, 1 after rounding.
bool is_placement(dmat4& m) {
    for (std::size_t c = 0; c < 4; ++c) {
        const double wanted = c == 3 ? 1 : 0;
        if (!is_finite(m[c].xyz()) || !(std::fabs(m[c].w - wanted) <= 1e-6)) return false;
        m[c].w = wanted;
    }
    dmat4 unused;
    return inverse_affine(m, unused);
}

class BindPose {
public:
    explicit BindPose(const Scene& scene)
        : scene_(scene),
          world_(world_matrices(scene)),
          used_(used_joints(scene)),
          place_(scene.skins.size()),
          is_placed_(scene.skins.size()) {
        for (std::uint32_t s = 0; s < scene.skins.size(); ++s) is_placed_[s] = place(s);
    }

    std::vector<dmat4> matrices() const {
        std::vector<dmat4> result = world_;
        for (std::size_t n = 0; n < result.size(); ++n)
            if (const std::uint32_t skin = scene_.nodes[n].skin; skin != no_index && is_placed_[skin])
                result[n] = place_[skin];
        return result;
    }

private:
    struct Joint {
        std::uint32_t skin, index;
    };

    bool place(std::uint32_t s) {
        const Skin& skin = scene_.skins[s];
        bool placed = false;
        for (std::uint32_t j = 0; j < skin.joints.size() && !placed; ++j)
            if (const auto known = first_.find(skin.joints[j]); used_[s][j] && known != first_.end())
                placed = beside(known->second, s, j);
        for (std::uint32_t j = 0; j < skin.joints.size() && !placed; ++j) {
            place_[s] = world_[skin.joints[j]] * skin.inverse_bind[j];
            placed = used_[s][j] && is_placement(place_[s]);
        }
        for (std::uint32_t j = 0; j < skin.joints.size() && placed; ++j)
            if (used_[s][j]) first_.try_emplace(skin.joints[j], Joint{s, j});
        return placed;
    }

    /// Relative placement by the common joint, without its matrix, so that equal ones give bit-equal places.
    bool beside(const Joint& other, std::uint32_t s, std::uint32_t j) {
        const dmat4 &theirs = scene_.skins[other.skin].inverse_bind[other.index],
                    &ours = scene_.skins[s].inverse_bind[j];
        if (theirs == ours) {
            place_[s] = place_[other.skin];
            return true;
        }
        dmat4 joint_to_theirs;
        if (!inverse_affine(theirs, joint_to_theirs)) return false;
        place_[s] = place_[other.skin] * joint_to_theirs * ours;
        return is_placement(place_[s]);
    }

    const Scene& scene_;
    std::vector<dmat4> world_;
    std::vector<std::vector<bool>> used_;
    std::vector<dmat4> place_;  // [skins]
    std::vector<bool> is_placed_;
    std::map<std::uint32_t, Joint> first_;  // by joint node: the first placed skin with this joint
};

/// Nonzero influences of a vertex: joints as node indices, ascending.
struct Follower {
    std::array<std::uint32_t, 8> joint;
    std::array<float, 8> weight{};

    Follower(const Skin& skin, const Mesh& mesh, std::uint32_t vertex) {
        joint.fill(no_index);
        std::size_t count = 0;
        for (const Block<JointInfluence>* block : {&mesh.influences, &mesh.more_influences})
            for (std::size_t k = 0; k < 4 && !block->empty(); ++k) {
                const JointInfluence& influence = (*block)[vertex];
                if (influence.weights[k] == 0) continue;
                const std::uint32_t node = skin.joints[influence.joints[k]];
                const auto same = std::find(joint.begin(), joint.begin() + std::ptrdiff_t(count), node);
                const auto at = std::size_t(same - joint.begin());
                joint[at] = node;
                weight[at] += influence.weights[k];
                count = std::max(count, at + 1);
            }
    }
    float weight_of(std::uint32_t node) const {
        for (std::size_t k = 0; k < joint.size(); ++k)
            if (joint[k] == node) return weight[k];
        return 0;
    }
    bool agrees(const Follower& other) const {
        for (std::size_t k = 0; k < joint.size(); ++k)
            if (joint[k] != no_index && std::fabs(weight[k] - other.weight_of(joint[k])) > weight_slack) return false;
        return true;
    }
};

struct SkinnedVertex {
    dvec3 position;
    std::uint32_t instance, vertex;
    auto key() const { return std::tuple(position.x, position.y, position.z, instance, vertex); }
    bool operator<(const SkinnedVertex& other) const { return key() < other.key(); }
};

/// Finds places where vertices of skinned instances will separate.
class PartingSearch {
public:
    PartingSearch(const Scene& scene, const std::vector<Instance>& instances, const std::vector<dmat4>& place,
                  Context& context)
        : scene_(scene), instances_(instances), place_(place), context_(context), check_(context) {}

    /// @return number of places
    /// @throws Error bad_file: over the memory budget; failed: cancelled
    std::uint64_t run() {
        select();
        const MemoryCharge charge(context_.memory(), count_vertices() * sizeof(SkinnedVertex),
                                  "the vertices of all skinned placements");
        collect();
        std::sort(vertices_.begin(), vertices_.end(), [this](const SkinnedVertex& a, const SkinnedVertex& b) {
            check_();
            return a < b;
        });
        return count_parting();
    }

private:
    const Mesh& mesh_of(std::uint32_t instance) const { return scene_.meshes[instances_[instance].mesh]; }
    std::uint32_t skin_of(std::uint32_t instance) const { return scene_.nodes[instances_[instance].node].skin; }
    std::array<std::uint64_t, 16> bits(std::uint32_t instance) const {
        return std::bit_cast<std::array<std::uint64_t, 16>>(place_[instances_[instance].node]);
    }

    /// One instance for each combination of mesh, skin and matrix; others have the same joints at every vertex.
    void select() {
        for (std::uint32_t i = 0; i < instances_.size(); ++i)
            if (skin_of(i) != no_index && !mesh_of(i).influences.empty()) selected_.push_back(i);
        const auto order = [&](std::uint32_t a, std::uint32_t b) {
            check_();
            const auto key = [&](std::uint32_t i) { return std::pair(instances_[i].mesh, skin_of(i)); };
            return key(a) != key(b) ? key(a) < key(b) : bits(a) < bits(b);
        };
        std::stable_sort(selected_.begin(), selected_.end(), order);  // keeps the first of equal ones
        const auto same = [&](std::uint32_t a, std::uint32_t b) { return !order(a, b) && !order(b, a); };
        selected_.erase(std::unique(selected_.begin(), selected_.end(), same), selected_.end());
    }

    std::uint64_t count_vertices() const {
        std::uint64_t count = 0;
        for (const std::uint32_t i : selected_) count += mesh_of(i).positions.size();
        return count;
    }

    void collect() {
        vertices_.reserve(count_vertices());
        std::vector<bool> used;
        for (std::size_t s = 0; s < selected_.size(); ++s) {
            const std::uint32_t i = selected_[s];
            const Mesh& mesh = mesh_of(i);
            const dmat4 to_world = place_[instances_[i].node] * translation(mesh.origin);
            if (s == 0 || &mesh != &mesh_of(selected_[s - 1])) {
                used.assign(mesh.positions.size(), false);
                for (const std::uint32_t v : mesh.indices) used[v] = true;
            }
            for (std::uint32_t v = 0; v < mesh.positions.size(); ++v, check_()) {
                if (!used[v]) continue;
                const dvec3 p =
                    transform_point(to_world, cast<double>(mesh.positions[v])) + dvec3{0, 0, 0};  // -0 becomes +0
                if (is_finite(p)) vertices_.push_back({p, i, v});
            }
        }
    }

    Follower follower(const SkinnedVertex& v) const {
        return Follower(scene_.skins[skin_of(v.instance)], mesh_of(v.instance), v.vertex);
    }

    std::uint64_t count_parting() {
        std::uint64_t parting = 0;
        for (std::size_t first = 0, last = 0; first < vertices_.size(); first = last) {
            const Follower leader = follower(vertices_[first]);
            bool parts = false;
            for (last = first; last < vertices_.size() && vertices_[last].position == vertices_[first].position;
                 ++last, check_()) {
                const Follower other = follower(vertices_[last]);
                parts = parts || !leader.agrees(other) || !other.agrees(leader);
            }
            parting += parts;
        }
        return parting;
    }

    const Scene& scene_;
    const std::vector<Instance>& instances_;
    const std::vector<dmat4>& place_;
    Context& context_;
    CancelCheck check_;
    std::vector<std::uint32_t> selected_;  ///< into `instances_`, by mesh
    std::vector<SkinnedVertex> vertices_;
};

}  // namespace

std::vector<dmat4> bind_pose_matrices(const Scene& scene) { return BindPose(scene).matrices(); }

void warn_of_parting_vertices(const Scene& scene, const std::vector<Instance>& instances,
                              const std::vector<dmat4>& place, Context& context) {
    const auto add = [&](Remark kind, const std::string& text) { context.report().add(kind, scene.source, {}, text); };
    try {
        const std::uint64_t parting = PartingSearch(scene, instances, place, context).run();
        if (parting == 0) return;
        add(Remark::warning, format_text("{} places where vertices of skinned meshes meet have different joint "
                                         "weights: they will part in motion",
                                         parting));
    } catch (const Error& error) {
        if (error.code() == ErrorCode::failed) throw;  // cancelled
        add(Remark::note, "skinned meshes were not searched for places that part in motion: " + error.reason());
    }
}

}  // namespace rakelight
