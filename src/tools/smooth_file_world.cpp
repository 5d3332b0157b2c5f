// SPDX-License-Identifier: Apache-2.0
#include "tools/smooth_file_world.h"

#include <algorithm>
#include <cmath>

#include "math/linear.h"
#include "prepare/bind_pose.h"

namespace rakelight {
namespace {

/// Corners 1 and 2 of each triangle change places.
template <class T>
Block<T> rewound(const Block<T>& corners, Context& context) {
    MemoryCharge charge(context.memory(), corners.size() * sizeof(T), "a model placed in the world");
    std::vector<T> values(corners.begin(), corners.end());
    for (std::size_t c = 0; c + 2 < values.size(); c += 3) std::swap(values[c + 1], values[c + 2]);
    return {std::move(values), std::move(charge)};
}

Mesh placed(const Mesh& mesh, const dmat4& place, Context& context) {
    MemoryCharge charge(context.memory(), (mesh.positions.size() + mesh.normals.size()) * sizeof(vec3),
                        "a model placed in the world");
    Mesh out = mesh;
    std::vector<vec3> positions(mesh.positions.size()), normals(mesh.normals.size());
    for (std::size_t v = 0; v < positions.size(); ++v)
        positions[v] = cast<float>(transform_point(place, cast<double>(mesh.positions[v]) + mesh.origin));
    const dmat3 linear = upper_left(place), turn = cofactor(linear);
    const bool is_mirrored = determinant(linear) < 0;
    for (std::size_t v = 0; v < normals.size(); ++v)
        normals[v] = cast<float>(
            normalize_or(turn * cast<double>(mesh.normals[v]) * (is_mirrored ? -1.0 : 1.0), dvec3{0, 0, 1}));
    out.origin = {};
    out.positions = {std::move(positions), charge.split(mesh.positions.size() * sizeof(vec3))};
    out.normals = {std::move(normals), std::move(charge)};
    out.tangents = {};
    out.influences = {};
    out.targets.clear();
    if (is_mirrored && mesh.topology == Topology::triangles) {
        out.indices = rewound(mesh.indices, context);
        out.smoothing_hint = rewound(mesh.smoothing_hint, context);
    }
    return out;
}

}  // namespace

Scene in_bind_pose(const Scene& scene) {
    const std::vector<dmat4> place = bind_pose_matrices(scene);
    Scene out = scene;
    for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
        if (scene.nodes[n].skin == no_index) continue;
        Node standing;  // the node itself may carry others, and moves with its parents
        standing.name = out.nodes[n].name;
        standing.local.matrix = place[n];
        std::swap(standing.meshes, out.nodes[n].meshes);
        out.nodes[n].skin = no_index;
        out.nodes.push_back(std::move(standing));
    }
    for (Mesh& mesh : out.meshes) mesh.influences = {};
    return out;
}

Scene placed_in_world(const Scene& scene, Context& context) {
    const std::vector<dmat4> world = bind_pose_matrices(scene);
    Scene out = scene;
    out.meshes.clear();
    for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
        Node& node = out.nodes[n];
        node.parent = no_index;
        node.local = {};
        node.morph_weights.clear();
        node.skin = no_index;
        for (std::uint32_t& m : node.meshes) {
            context.throw_if_cancelled();
            out.meshes.push_back(placed(scene.meshes[m], world[n], context));
            m = std::uint32_t(out.meshes.size() - 1);
        }
    }
    return out;
}

double world_rounding(const Scene& scene) {
    double largest = 0;
    for (const Mesh& mesh : scene.meshes)
        for (const vec3& p : mesh.positions)
            for (const float x : {p.x, p.y, p.z})
                if (std::isfinite(x)) largest = std::max(largest, std::fabs(double(x)));
    return largest / 1048576;
}

}  // namespace rakelight
