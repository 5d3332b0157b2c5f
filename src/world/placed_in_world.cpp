// SPDX-License-Identifier: Apache-2.0
#include "world/placed_in_world.h"

#include <algorithm>
#include <cmath>

#include "io/position_origin.h"
#include "math/linear.h"
#include "prepare/normals/bind_pose.h"
#include "scene/charge_arrays.h"
#include "scene/placed_normal.h"

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

dvec3 in_world(const Mesh& mesh, std::size_t v, const dmat4& place) {
    return transform_point(place, cast<double>(mesh.positions[v]) + mesh.origin);
}

/// From where floats hold the positions of the placed scene.
dvec3 origin_of(const Scene& scene, const std::vector<dmat4>& world) {
    dvec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    double error = 0;
    for (std::size_t n = 0; n < scene.nodes.size(); ++n)
        for (const std::uint32_t m : scene.nodes[n].meshes)
            for (std::size_t v = 0; v < scene.meshes[m].positions.size(); ++v) {
                const dvec3 q = in_world(scene.meshes[m], v, world[n]);
                for (std::size_t k = 0; k < 3; ++k) {
                    if (!std::isfinite(q[k])) continue;
                    low[k] = std::min(low[k], q[k]), high[k] = std::max(high[k], q[k]);
                    error = std::max(error, std::fabs(double(float(q[k])) - q[k]));
                }
            }
    return io::position_origin(low, high, error);
}

Mesh placed(const Mesh& mesh, const dmat4& place, dvec3 origin, Context& context) {
    MemoryCharge charge(context.memory(), (mesh.positions.size() + mesh.normals.size()) * sizeof(vec3),
                        "a model placed in the world");
    Mesh out = mesh;
    std::vector<vec3> positions(mesh.positions.size()), normals(mesh.normals.size());
    for (std::size_t v = 0; v < positions.size(); ++v) positions[v] = cast<float>(in_world(mesh, v, place) - origin);
    const PlacedNormals turn(place);
    for (std::size_t v = 0; v < normals.size(); ++v) normals[v] = turn(mesh.normals[v]);
    out.origin = origin;
    out.positions = {std::move(positions), charge.split(mesh.positions.size() * sizeof(vec3))};
    out.normals = {std::move(normals), std::move(charge)};
    out.tangents = {};
    out.influences = {}, out.more_influences = {};
    out.targets = {};
    if (turn.is_mirrored() && mesh.topology == Topology::triangles) {
        out.indices = rewound(mesh.indices, context);
        out.smoothing_hint = rewound(mesh.smoothing_hint, context);
    }
    return out;
}

}  // namespace

Scene placed_in_world(const Scene& scene, bool holds_doubles, Context& context) {
    const std::vector<dmat4> world = bind_pose_matrices(scene);
    const dvec3 origin = holds_doubles ? origin_of(scene, world) : dvec3{};
    Scene out = charged_copy(scene, context);
    out.meshes.clear();
    for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
        Node& node = out.nodes[n];
        node.parent = no_index;
        node.local = {};
        node.morph_weights = {};
        node.skin = no_index;
        for (std::uint32_t& m : node.meshes) {
            context.throw_if_cancelled();
            out.meshes.push_back(placed(scene.meshes[m], world[n], origin, context));
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
