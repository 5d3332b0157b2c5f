// SPDX-License-Identifier: Apache-2.0
#include "io/obj/obj_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/cloud_material.h"
#include "io/position_origin.h"
#include "math/linear.h"

namespace rakelight::io::obj {
namespace {

dvec3 origin_of(const std::vector<dvec3>& positions) {
    dvec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    double error = 0;
    for (const dvec3& p : positions)
        for (std::size_t k = 0; k < 3; ++k) {
            if (!std::isfinite(p[k])) continue;
            low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
            error = std::max(error, std::fabs(double(float(p[k])) - p[k]));
        }
    return position_origin(low, high, error);
}

/// What `of` makes of the number of each vertex in `indices`.
template <class T, class Of>
Block<T> block_of(const std::vector<std::uint32_t>& vertices, Context& context, const Of& of) {
    MemoryCharge charge(context.memory(), vertices.size() * sizeof(T), "the points of an OBJ file");
    std::vector<T> array;
    array.reserve(vertices.size());
    for (const std::uint32_t v : vertices) array.push_back(of(v));
    return {std::move(array), std::move(charge)};
}

}  // namespace

bool is_point_cloud(const Contents& contents, const VertexData& data) {
    return contents.elements == 0 && contents.positions > 0 &&
           (!data.colors.empty() || data.normals.size() == data.positions.size());
}

void add_points(Scene& scene, VertexData& data, const std::string& name, Context& context) {
    MemoryCharge charge(context.memory(), data.positions.size() * sizeof(std::uint32_t), "the points of an OBJ file");
    std::vector<std::uint32_t> vertices;
    vertices.reserve(data.positions.size());
    for (std::uint32_t v = 0; v < data.positions.size(); ++v)
        if (rakelight::is_finite(data.positions[v])) vertices.push_back(v);
    if (vertices.empty()) throw Error(ErrorCode::bad_file, "nothing to draw: no vertex is finite");
    Mesh mesh;
    mesh.name = name;
    mesh.topology = Topology::points;
    mesh.origin = origin_of(data.positions);
    mesh.positions = block_of<vec3>(vertices, context,
                                    [&](std::uint32_t v) { return cast<float>(data.positions[v] - mesh.origin); });
    if (!data.colors.empty())
        mesh.colors = block_of<vec4>(vertices, context, [&](std::uint32_t v) { return data.colors[v]; });
    if (data.normals.size() == data.positions.size())
        mesh.normals = block_of<vec3>(vertices, context, [&](std::uint32_t v) { return data.normals[v]; });
    for (std::uint32_t i = 0; i < vertices.size(); ++i) vertices[i] = i;
    mesh.indices = {std::move(vertices), std::move(charge)};
    mesh.material = std::uint32_t(scene.materials.size());
    scene.materials.push_back(plain_material(!mesh.colors.empty()));
    scene.nodes.push_back({.name = name, .meshes = {std::uint32_t(scene.meshes.size())}});
    scene.meshes.push_back(std::move(mesh));
}

}  // namespace rakelight::io::obj
