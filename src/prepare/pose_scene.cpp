// SPDX-License-Identifier: Apache-2.0
// The way: nodes to their places, matrices of the joints, vertices of each placement that moves, nodes of skinned ones
// into the world.
#include "prepare/pose_scene.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>

#include "geometry/morph.h"
#include "geometry/skin.h"
#include "math/linear.h"
#include "prepare/moving_placements.h"
#include "scene/charge_arrays.h"
#include "scene/scene_tools.h"

namespace rakelight {
namespace {

using geometry::JointColumns;

/// Places farther from the world's origin than this [m] are given from a point nearby, so that floats suffice.
constexpr double far_away = 4096;

/// What a pose makes of the skinned meshes of one file: an origin for all, so that equal places stay equal.
class Skeleton {
public:
    explicit Skeleton(const Scene& scene) : scene_(scene), world_(world_matrices(scene)) {
        for (const Instance& i : moving_placements(scene)) {
            if (!is_skinned(i)) continue;
            const dvec3 place = transform_point(first_joint(i), dvec3{0, 0, 0});
            if (!(std::fmax(std::fmax(std::fabs(place.x), std::fabs(place.y)), std::fabs(place.z)) < far_away))
                origin_ = {std::round(place.x), std::round(place.y), std::round(place.z)};
            break;
        }
    }

    bool is_skinned(const Instance& i) const {
        return follows_skin(scene_, scene_.nodes[i.node], scene_.meshes[i.mesh]);
    }
    const std::vector<dmat4>& world() const { return world_; }
    dvec3 origin() const { return origin_; }

    /// Whether every joint that skinned meshes of the node follow turns them inside out.
    bool mirrors(std::uint32_t node) const {
        const auto& meshes = scene_.nodes[node].meshes;
        return std::ranges::all_of(meshes, [&](std::uint32_t m) {
            const Instance i{node, 0, m};
            return !is_skinned(i) || mirrors(i);
        });
    }

    /// Bind pose -> posed mesh, about origin(); x turned round for mirrored ones.
    std::vector<JointColumns> columns(const Instance& i, bool is_mirrored) const {
        std::vector<JointColumns> result;
        const dmat4 from_world = (is_mirrored ? scaling(dvec3{-1, 1, 1}) : dmat4{}) * translation(origin_ * -1.0);
        for (const dmat4& joint : joint_matrices(i)) {
            result.push_back(geometry::columns_of(from_world * joint * translation(scene_.meshes[i.mesh].origin)));
        }
        return result;
    }

private:
    bool mirrors(const Instance& i) const {
        const Mesh& mesh = scene_.meshes[i.mesh];
        const std::vector<dmat4> matrices = joint_matrices(i);
        std::vector<std::int8_t> side(matrices.size(), 0);
        for (const Block<JointInfluence>* block : {&mesh.influences, &mesh.more_influences})
            for (const JointInfluence& influence : *block)
                for (std::size_t k = 0; k < 4; ++k) {
                    if (influence.weights[k] == 0) continue;
                    std::int8_t& s = side[influence.joints[k]];
                    if (s == 0) s = determinant(upper_left(matrices[influence.joints[k]])) < 0 ? -1 : 1;
                    if (s > 0) return false;
                }
        return true;
    }
    const Skin& skin(const Instance& i) const { return scene_.skins[scene_.nodes[i.node].skin]; }
    std::vector<dmat4> joint_matrices(const Instance& i) const {
        std::vector<dmat4> result;
        for (std::size_t j = 0; j < skin(i).joints.size(); ++j)
            result.push_back(world_[skin(i).joints[j]] * skin(i).inverse_bind[j]);
        return result;
    }
    dmat4 first_joint(const Instance& i) const {
        const Mesh& mesh = scene_.meshes[i.mesh];
        const std::size_t j = mesh.influences[0].joints[0];
        return world_[skin(i).joints[j]] * skin(i).inverse_bind[j] * translation(mesh.origin);
    }

    const Scene& scene_;
    std::vector<dmat4> world_;
    dvec3 origin_{0, 0, 0};
};

/// A block of numbers that somebody will fill.
template <class T>
std::vector<T> room_for(const Block<T>& block) {
    return std::vector<T>(block.size());
}

std::vector<geometry::WeightedTarget> counting(const Mesh& mesh, const std::vector<float>& weights,
                                               Block<vec3> MorphTarget::*offsets) {
    std::vector<geometry::WeightedTarget> result;
    for (std::size_t t = 0; t < std::min(mesh.targets.size(), weights.size()); ++t)
        if (weights[t] != 0 && !(mesh.targets[t].*offsets).empty())
            result.push_back({weights[t], (mesh.targets[t].*offsets).span()});
    return result;
}

/// The mesh with its targets' offsets; arrays that nothing moves stay shared.
void morph(Mesh& mesh, const std::vector<float>& weights, Context& context) {
    const auto positions = counting(mesh, weights, &MorphTarget::positions);
    const auto normals = counting(mesh, weights, &MorphTarget::normals);
    const auto tangents = counting(mesh, weights, &MorphTarget::tangents);
    if (!positions.empty()) {
        auto out = room_for(mesh.positions);
        geometry::morph_positions(mesh.positions, positions, out, context);
        mesh.positions = std::move(out);
    }
    if (!normals.empty() && !mesh.normals.empty()) {
        auto out = room_for(mesh.normals);
        geometry::morph_normals(mesh.normals, normals, out, context);
        mesh.normals = std::move(out);
    }
    if (!tangents.empty() && !mesh.tangents.empty()) {
        auto out = room_for(mesh.tangents);
        geometry::morph_tangents(mesh.tangents, tangents, out, context);
        mesh.tangents = std::move(out);
    }
}

void skin(Mesh& mesh, const std::vector<JointColumns>& joints, Context& context) {
    auto positions = room_for(mesh.positions);
    auto normals = room_for(mesh.normals);
    auto tangents = room_for(mesh.tangents);
    geometry::skin_vertices(
        {mesh.positions, mesh.normals, mesh.tangents, mesh.influences, mesh.more_influences, joints},
        {positions, normals, tangents}, context);
    mesh.positions = std::move(positions), mesh.normals = std::move(normals), mesh.tangents = std::move(tangents);
}

void check_memory(const Scene& scene, const std::vector<Instance>& moving, Context& context) {
    std::uint64_t bytes = 0;
    for (const Instance& i : moving) {
        const Mesh& mesh = scene.meshes[i.mesh];
        bytes += mesh.positions.size() * sizeof(vec3) + mesh.normals.size() * sizeof(vec3) +
                 mesh.tangents.size() * sizeof(vec4);
    }
    context.memory().check(bytes, "posed vertices");
}

/// What a node and all above it say of shading.
std::optional<Shading> shading_of(const Scene& scene, std::uint32_t node) {
    for (; node != no_index; node = scene.nodes[node].parent)
        if (scene.nodes[node].shading) return scene.nodes[node].shading;
    return {};
}

/// Puts nodes that show skinned meshes into the world by themselves; what hangs from them stays in place.
class Detacher {
public:
    Detacher(Scene& scene, const std::vector<dmat4>& world) : scene_(scene), world_(world) {}

    /// @param placed  [nodes that show skinned meshes] where the posed meshes stand
    void detach(const std::map<std::uint32_t, dmat4>& placed) {
        for (std::uint32_t n = 0; n < world_.size(); ++n)
            if (placed.contains(n) || hangs(n, placed)) scene_.nodes[n].shading = shading_of(scene_, n);
        for (std::uint32_t n = 0; n < world_.size(); ++n)
            if (hangs(n, placed)) place_in_world(scene_.nodes[n], world_[n]);
        for (const auto& [n, matrix] : placed)
            place_in_world(scene_.nodes[is_needed(n) ? with_meshes_of(n) : n], matrix);
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
    /// Something else stands at the node: a light, a camera, a mesh without influences.
    bool is_needed(std::uint32_t node) const {
        const auto is_here = [node](const auto& element) { return element.node == node; };
        return std::ranges::any_of(scene_.lights, is_here) || std::ranges::any_of(scene_.cameras, is_here) ||
               !std::ranges::all_of(scene_.nodes[node].meshes, [&](std::uint32_t m) { return is_skinned(m); });
    }
    /// A new node takes the skinned meshes over. @return its number
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

/// Nothing is left that could move.
void end_motion(Scene& scene) {
    for (Mesh& mesh : scene.meshes) mesh.influences = {}, mesh.more_influences = {}, mesh.targets.clear();
    for (Node& node : scene.nodes) node.skin = no_index, node.morph_weights.clear();
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

Scene valid::posed_scene(Scene scene, Context& context) {
    if (!is_posable(scene)) return scene;
    const auto own = unpaid_arrays(scene);
    scene = with_own_meshes(with_posed_nodes(std::move(scene)), context);
    {
        const Skeleton skeleton(scene);
        std::map<std::uint32_t, dmat4> placed;
        std::vector<Mesh> posed;
        const std::vector<Instance> moving = moving_placements(scene);
        check_memory(scene, moving, context);
        for (const Instance& i : moving) {
            context.throw_if_cancelled();
            Mesh mesh = scene.meshes[i.mesh];
            morph(mesh, scene.nodes[i.node].morph_weights, context);
            if (skeleton.is_skinned(i)) {
                const bool is_mirrored = skeleton.mirrors(i.node);
                skin(mesh, skeleton.columns(i, is_mirrored), context);
                mesh.origin = {};
                const dmat4 place = translation(skeleton.origin()) * (is_mirrored ? scaling(dvec3{-1, 1, 1}) : dmat4{});
                placed[i.node] = place;
            }
            posed.push_back(std::move(mesh));
        }
        Detacher(scene, skeleton.world()).detach(placed);
        for (std::size_t k = 0; k < moving.size(); ++k) scene.meshes[moving[k].mesh] = std::move(posed[k]);
    }
    end_motion(scene);
    charge_new_arrays(scene, own, context);
    return scene;
}

std::optional<Scene> posed_outline(const Scene& scene, Context& context) {
    if (!is_posable(scene)) return {};
    Scene outline = scene;
    for (const Instance& i : moving_placements(scene))
        outline.meshes[i.mesh].normals = {}, outline.meshes[i.mesh].tangents = {};
    return valid::posed_scene(std::move(outline), context);
}

Scene posed_scene(const Scene& scene, Context& context) {
    validate(scene);
    return valid::posed_scene(scene, context);
}

}  // namespace rakelight
