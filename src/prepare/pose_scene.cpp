// SPDX-License-Identifier: Apache-2.0
// Stages: node transforms, joint matrices, pose of each animated instance, skinned nodes to world space; then vertices
// (geometry/mesh_pose.h), here or in the engine.
#include "prepare/pose_scene.h"

#include <rakelight/scene/validate.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstring>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "base/cancel_check.h"
#include "math/linear.h"
#include "prepare/moving_placements.h"
#include "scene/charge_arrays.h"
#include "scene/placement.h"

namespace rakelight {
namespace {

using geometry::JointColumns, geometry::MeshPose, geometry::MeshPoses;

/// [m] Positions farther from the world origin are stored relative to a nearby point, so that float precision suffices.
constexpr double far_away = 4096;

/// [skins] The first one with the same joints and bind matrices: files repeat a skin for each of its meshes.
std::vector<std::uint32_t> first_of_like_skins(const std::vector<Skin>& skins) {
    const auto joints = [&](std::uint32_t a, std::uint32_t b) {
        return std::lexicographical_compare_three_way(skins[a].joints.begin(), skins[a].joints.end(),
                                                      skins[b].joints.begin(), skins[b].joints.end());
    };
    const auto is_less = [&](std::uint32_t a, std::uint32_t b) {
        if (const auto order = joints(a, b); order != 0) return order < 0;
        const Block<dmat4>&of_a = skins[a].inverse_bind, &of_b = skins[b].inverse_bind;
        return !(of_a == of_b) && std::memcmp(of_a.data(), of_b.data(), of_a.size() * sizeof(dmat4)) < 0;
    };
    std::set<std::uint32_t, decltype(is_less)> known(is_less);
    std::vector<std::uint32_t> first;
    for (std::uint32_t s = 0; s < skins.size(); ++s) first.push_back(*known.insert(s).first);
    return first;
}

/// Poses of the skinned meshes of a scene, with one origin for all, so that equal places stay equal. Shared data is
/// computed once.
class Skeleton {
public:
    Skeleton(const Scene& scene, const std::vector<Instance>& moving, Context& context)
        : scene_(scene),
          context_(context),
          world_(world_matrices(scene)),
          alike_(first_of_like_skins(scene.skins)),
          sides_(scene.skins.size()),
          check_(context) {
        const auto first = std::ranges::find_if(moving, [&](const Instance& i) { return is_skinned(i); });
        if (first == moving.end()) return;
        const dvec3 place = transform_point(first_joint(*first), dvec3{0, 0, 0});
        if (!(std::fmax(std::fmax(std::fabs(place.x), std::fabs(place.y)), std::fabs(place.z)) < far_away))
            origin_ = {std::round(place.x), std::round(place.y), std::round(place.z)};
    }

    bool is_skinned(const Instance& i) const {
        return follows_skin(scene_, scene_.nodes[i.node], scene_.meshes[i.mesh]);
    }
    const std::vector<dmat4>& world() const { return world_; }
    dvec3 origin() const { return origin_; }

    /// Whether all joints of the node's skinned meshes mirror.
    bool mirrors(std::uint32_t node) {
        const std::vector<std::uint32_t>& meshes = scene_.nodes[node].meshes;
        return std::ranges::all_of(meshes, [&](std::uint32_t mesh) {
            const Instance i{node, 0, mesh};
            if (!is_skinned(i)) return true;
            const Mesh& m = scene_.meshes[mesh];
            const auto [known, is_new] =
                mirrors_.try_emplace({skin_of(i), m.influences.identity(), m.more_influences.identity()});
            if (is_new) known->second = mirrors(i);
            return known->second;
        });
    }

    /// Bind pose -> posed mesh, relative to origin(); x is negated for mirrored ones.
    const Block<JointColumns>& columns(const Instance& i, bool is_mirrored) {
        const dvec3 from = scene_.meshes[i.mesh].origin;
        const std::uint32_t skin = skin_of(i);
        const auto [known, is_new] = columns_.try_emplace({skin, is_mirrored, from.x, from.y, from.z});
        if (!is_new) return known->second;
        const std::size_t joints = scene_.skins[skin].joints.size();
        MemoryCharge charge(context_.memory(), joints * sizeof(JointColumns), "joints of skins");
        const dmat4 to_mesh = (is_mirrored ? scaling(dvec3{-1, 1, 1}) : dmat4{}) * translation(origin_ * -1.0);
        std::vector<JointColumns> columns;
        columns.reserve(joints);
        for (std::size_t j = 0; j < joints; ++j, check_())
            columns.push_back(geometry::columns_of(to_mesh * joint_matrix(skin, j) * translation(from)));
        return known->second = {std::move(columns), std::move(charge)};
    }

private:
    std::uint32_t skin_of(const Instance& i) const { return alike_[scene_.nodes[i.node].skin]; }

    dmat4 joint_matrix(std::uint32_t skin, std::size_t joint) const {
        const Skin& s = scene_.skins[skin];
        return world_[s.joints[joint]] * s.inverse_bind[joint];
    }
    dmat4 first_joint(const Instance& i) const {
        const Mesh& mesh = scene_.meshes[i.mesh];
        const JointInfluence& influence = mesh.influences[0];
        const std::size_t j = influence.weights[0] != 0 ? influence.joints[0] : 0;
        return joint_matrix(skin_of(i), j) * translation(mesh.origin);
    }
    /// Vertices without weights follow the first joint.
    bool mirrors(const Instance& i) {
        const Mesh& mesh = scene_.meshes[i.mesh];
        bool follows_some = false;
        for (const Block<JointInfluence>* block : {&mesh.influences, &mesh.more_influences})
            for (const JointInfluence& influence : *block)
                for (std::size_t k = 0; k < 4; ++k) {
                    if (influence.weights[k] == 0) continue;
                    if (!is_mirrored(skin_of(i), influence.joints[k])) return false;
                    follows_some = true;
                }
        return follows_some || is_mirrored(skin_of(i), 0);
    }
    bool is_mirrored(std::uint32_t skin, std::size_t joint) {
        std::vector<std::int8_t>& sides = sides_[skin];
        sides.resize(scene_.skins[skin].joints.size(), 0);
        if (sides[joint] == 0) sides[joint] = determinant(upper_left(joint_matrix(skin, joint))) < 0 ? -1 : 1;
        return sides[joint] < 0;
    }

    const Scene& scene_;
    Context& context_;
    std::vector<dmat4> world_;
    std::vector<std::uint32_t> alike_;  ///< [skins] of first_of_like_skins()
    dvec3 origin_{0, 0, 0};
    std::vector<std::vector<std::int8_t>> sides_;  ///< [skins][joints] -1: it mirrors, 0: not known yet
    /// By skin and influences.
    std::map<std::tuple<std::uint32_t, const void*, const void*>, bool> mirrors_;
    /// By skin, mirrored or not, origin of the mesh.
    std::map<std::tuple<std::uint32_t, bool, double, double, double>, Block<JointColumns>> columns_;
    CancelCheck check_;
};

void check_memory(const Scene& scene, const std::vector<Instance>& moving, Context& context) {
    std::uint64_t bytes = 0;
    for (const Instance& i : moving) {
        const Mesh& mesh = scene.meshes[i.mesh];
        const std::uint64_t sets = mesh.targets.empty() ? 1 : 2;  // those of the targets, and of the skin
        bytes += sizeof(MeshPoses::value_type) +
                 sets * (mesh.positions.size() * sizeof(vec3) + mesh.normals.size() * sizeof(vec3) +
                         mesh.tangents.size() * sizeof(vec4));
    }
    context.memory().check(bytes, "posed vertices");
}

/// [nodes] shading of each node including inherited values.
std::vector<std::optional<Shading>> resolved_shading(const Scene& scene) {
    std::vector<std::optional<Shading>> shading;
    shading.reserve(scene.nodes.size());
    for (const Node& node : scene.nodes)  // parents precede children
        shading.push_back(node.shading || node.parent == no_index ? node.shading : shading[node.parent]);
    return shading;
}

/// Moves nodes with skinned meshes to the root in world space; their children keep their place.
class Detacher {
public:
    Detacher(Scene& scene, const std::vector<dmat4>& world) : scene_(scene), world_(world) {}

    /// @param placed [nodes that show skinned meshes] placement of the posed meshes
    void detach(const std::map<std::uint32_t, dmat4>& placed) {
        if (placed.empty()) return;
        const std::vector<std::optional<Shading>> shading = resolved_shading(scene_);
        for (std::uint32_t n = 0; n < world_.size(); ++n)
            if (placed.contains(n) || hangs(n, placed)) scene_.nodes[n].shading = shading[n];
        for (std::uint32_t n = 0; n < world_.size(); ++n)
            if (hangs(n, placed)) place_in_world(scene_.nodes[n], world_[n]);
        const std::set<std::uint32_t> taken = nodes_of_others();
        for (const auto& [n, matrix] : placed)
            place_in_world(scene_.nodes[is_needed(n, taken) ? with_meshes_of(n) : n], matrix);
    }

private:
    bool hangs(std::uint32_t node, const std::map<std::uint32_t, dmat4>& placed) const {
        return scene_.nodes[node].parent != no_index && placed.contains(scene_.nodes[node].parent);
    }
    static void place_in_world(Node& node, const dmat4& matrix) {
        node.parent = no_index;
        node.local = {};
        if (!(matrix == dmat4{})) node.local.matrix = matrix;
    }
    bool is_skinned(std::uint32_t mesh) const { return !scene_.meshes[mesh].influences.empty(); }
    /// Nodes of lights and cameras.
    std::set<std::uint32_t> nodes_of_others() const {
        std::set<std::uint32_t> nodes;
        for (const Light& light : scene_.lights) nodes.insert(light.node);
        for (const Camera& camera : scene_.cameras) nodes.insert(camera.node);
        return nodes;
    }
    /// Whether the node also has a light, a camera, or a mesh without influences.
    bool is_needed(std::uint32_t node, const std::set<std::uint32_t>& taken) const {
        return taken.contains(node) ||
               !std::ranges::all_of(scene_.nodes[node].meshes, [&](std::uint32_t m) { return is_skinned(m); });
    }
    /// Moves the skinned meshes to a new node.
    /// @return its index
    std::uint32_t with_meshes_of(std::uint32_t node) {
        Node& old = scene_.nodes[node];
        Node added;
        added.name = old.name, added.source_node = old.source_node, added.shading = old.shading;
        std::ranges::copy_if(old.meshes, std::back_inserter(added.meshes),
                             [&](std::uint32_t m) { return is_skinned(m); });
        std::erase_if(old.meshes, [&](std::uint32_t m) { return is_skinned(m); });
        scene_.nodes.push_back(std::move(added));
        return std::uint32_t(scene_.nodes.size() - 1);
    }

    Scene& scene_;
    const std::vector<dmat4>& world_;
};

/// Lets meshes of the same positions share normals and tangents that are equal, so that they are posed once: smoothing
/// makes them for each placement. Compared are the first few of each kind.
void share_equal_vertices(Scene& scene, const std::vector<Instance>& moving, const Context& context) {
    constexpr std::size_t searched = 16;
    const auto are_equal = [](const auto& a, const auto& b) { return a == b || std::ranges::equal(a, b); };
    std::map<const void*, std::vector<std::uint32_t>> firsts;  // by positions
    for (const Instance& i : moving) {
        context.throw_if_cancelled();
        Mesh& mesh = scene.meshes[i.mesh];
        std::vector<std::uint32_t>& known = firsts[mesh.positions.identity()];
        const auto is_equal = [&](std::uint32_t first) {
            const Mesh& other = scene.meshes[first];
            return are_equal(other.normals, mesh.normals) && are_equal(other.tangents, mesh.tangents);
        };
        if (const auto same = std::ranges::find_if(known, is_equal); same != known.end())
            mesh.normals = scene.meshes[*same].normals, mesh.tangents = scene.meshes[*same].tangents;
        else if (known.size() < searched)
            known.push_back(i.mesh);
    }
}

/// Removes all animation data.
void end_motion(Scene& scene) {
    for (Mesh& mesh : scene.meshes) mesh.influences = {}, mesh.more_influences = {}, mesh.targets = {};
    for (Node& node : scene.nodes) node.skin = no_index, node.morph_weights = {};
    scene.skins.clear(), scene.animations.clear(), scene.pose = {};
}

}  // namespace

Scene with_posed_nodes(Scene scene) {
    if (!scene.pose) return scene;
    for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
        scene.nodes[n].local = scene.pose->local[n];
        scene.nodes[n].morph_weights = scene.pose->morph_weights[n];
    }
    scene.pose = {};
    return scene;
}

UnposedScene valid::unposed_scene(Scene scene, Context& context) {
    if (!is_posable(scene)) return {std::move(scene), {}};
    scene = with_own_meshes(with_posed_nodes(std::move(scene)), context);
    MeshPoses poses;
    {
        const std::vector<Instance> moving = moving_placements(scene);
        share_equal_vertices(scene, moving, context);
        check_memory(scene, moving, context);
        Skeleton skeleton(scene, moving, context);
        std::map<std::uint32_t, dmat4> placed;
        std::vector<std::uint32_t> skinned;
        for (const Instance& i : moving) {
            context.throw_if_cancelled();
            const Mesh& mesh = scene.meshes[i.mesh];
            MeshPose pose{.positions = mesh.positions,
                          .normals = mesh.normals,
                          .tangents = mesh.tangents,
                          .targets = mesh.targets,
                          .weights = scene.nodes[i.node].morph_weights};
            if (skeleton.is_skinned(i)) {
                const bool is_mirrored = skeleton.mirrors(i.node);
                pose.influences = mesh.influences, pose.more_influences = mesh.more_influences;
                pose.joints = skeleton.columns(i, is_mirrored);
                skinned.push_back(i.mesh);
                placed[i.node] = translation(skeleton.origin()) * (is_mirrored ? scaling(dvec3{-1, 1, 1}) : dmat4{});
            }
            if (pose.moves()) poses.emplace(i.mesh, std::move(pose));
        }
        Detacher(scene, skeleton.world()).detach(placed);
        for (const std::uint32_t mesh : skinned) scene.meshes[mesh].origin = {};
    }
    end_motion(scene);
    return {std::move(scene), std::move(poses)};
}

PoseTaker::Key PoseTaker::key_of(const MeshPose& p) {
    return {p.positions.identity(),  p.normals.identity(),         p.tangents.identity(), p.targets.identity(),
            p.influences.identity(), p.more_influences.identity(), p.joints.identity(),   p.weights.identity()};
}

PoseTaker::PoseTaker(UnposedScene& unposed, Context& context) : unposed_(unposed), context_(context) {
    for (const auto& [number, pose] : unposed.poses) ++posed_[key_of(pose)].left;
}

void PoseTaker::take(std::uint32_t number) {
    const auto found = unposed_.poses.find(number);
    if (found == unposed_.poses.end()) return;
    context_.throw_if_cancelled();
    const auto known = posed_.find(key_of(found->second));
    Posed& posed = known->second;
    if (!posed.arrays) posed.arrays = geometry::posed_arrays(found->second, context_);
    Mesh& mesh = unposed_.scene.meshes[number];
    mesh.positions = posed.arrays->positions, mesh.normals = posed.arrays->normals;
    mesh.tangents = posed.arrays->tangents;
    if (--posed.left == 0) posed_.erase(known);
    unposed_.poses.erase(found);
}

void PoseTaker::take_all() {
    while (!unposed_.poses.empty()) take(unposed_.poses.begin()->first);
}

Scene valid::posed_scene(Scene scene, Context& context) {
    if (!is_posable(scene)) return scene;
    const auto own = unpaid_arrays(scene);
    UnposedScene unposed = valid::unposed_scene(std::move(scene), context);
    PoseTaker(unposed, context).take_all();
    charge_new_arrays(unposed.scene, own, context);
    return std::move(unposed.scene);
}

std::optional<Scene> posed_outline(const Scene& scene, Context& context) {
    if (!is_posable(scene)) return {};
    Scene outline = charged_copy(scene, context);
    for (const Instance& i : moving_placements(scene))
        outline.meshes[i.mesh].normals = {}, outline.meshes[i.mesh].tangents = {};
    return valid::posed_scene(std::move(outline), context);
}

Scene posed_scene(const Scene& scene, Context& context) {
    validate(scene);
    return valid::posed_scene(scene, context);
}

}  // namespace rakelight
