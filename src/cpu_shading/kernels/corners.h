// SPDX-License-Identifier: Apache-2.0
// The corners of a vector of triangles of one mesh, in world axes. Per instruction set.
#pragma once
#include "cpu_shading/kernels/texcoords.h"
#include "cpu_shading/mesh_view.h"
#include "math/wide_rows.h"

namespace rakelight::cpu_shading::RL_ISA {

/// The three corners of `lanes` triangles, in the order of the mesh.
struct Corners {
    int32_t index[3][lanes];
    integer triangle;
    bool has_last;  ///< the last vertex is among them: what follows it in memory is not ours

    void find(const MeshView& mesh, integer triangles) {
        triangle = triangles;
        mask is_last = mask(false);
        for (int32_t k = 0; k < 3; ++k) {
            const integer i = gather_i(mesh.indices, triangle * integer(3) + integer(k));
            store(index[k], i);
            is_last = is_last || i == integer(mesh.vertices - 1);
        }
        has_last = any_lane(is_last);
    }
};

/// `width` floats of each lane's vertex at corner k.
template <int width>
inline void load_corner(const float* base, const Corners& c, int32_t k, real* v) {
    using rakelight::wide::RL_ISA::load_vectors;
    if (!c.has_last || width == 4)
        return load_vectors<width, 1>(base, reinterpret_cast<const uint32_t*>(c.index[k]), v);
    for (int32_t j = 0; j < width; ++j) v[j] = gather(base + j, load_i(c.index[k]) * integer(width));
}

inline vec3 load_corner3(const float* base, const Corners& c, int32_t k) {
    real v[3];
    load_corner<3>(base, c, k, v);
    return vec3(v[0], v[1], v[2]);
}

inline vec3 transformed(const float (&rows)[3][3], vec3 v) {
    const auto row = [&](int r) { return real(rows[r][0]) * v.x + real(rows[r][1]) * v.y + real(rows[r][2]) * v.z; };
    return vec3(row(0), row(1), row(2));
}

/// Normal of the face in world axes, not unit.
inline vec3 face_normal(const MeshView& mesh, const Corners& c) {
    const vec3 p0 = load_corner3(mesh.positions, c, 0);
    return transformed(mesh.to_normal,
                       cross(load_corner3(mesh.positions, c, 1) - p0, load_corner3(mesh.positions, c, 2) - p0));
}

/// -1 where the shading normal is to be turned round (lit_side.h).
inline real facing_of(const MeshView& mesh, const Corners& c, mask is_back) {
    integer turns = select(is_back, integer(1), integer(0)) + integer(mesh.turned);
    if (mesh.against != nullptr) turns = turns + gather_i(mesh.against, c.triangle);
    return select((turns & integer(1)) != integer(0), real(-1.0f), real(1.0f));
}

/// Unit normals of the corners; of meshes without normals those of the faces.
inline void load_normals(const MeshView& mesh, const Corners& c, vec3 (&normal)[3]) {
    if (mesh.normals == nullptr) {
        normal[0] = normal[1] = normal[2] = safe_normalize(face_normal(mesh, c));
        return;
    }
    for (int32_t k = 0; k < 3; ++k)
        normal[k] = safe_normalize(transformed(mesh.to_normal, load_corner3(mesh.normals, c, k)));
}

/// Unit tangents of the corners, 0 where the mesh has none. @return the handedness of the frame in the world
inline real load_tangents(const MeshView& mesh, const Corners& c, vec3 (&tangent)[3]) {
    real handedness(mesh.mirror);
    if (mesh.tangents == nullptr) {
        tangent[0] = tangent[1] = tangent[2] = vec3(real(0.0f));
        return handedness;
    }
    for (int32_t k = 0; k < 3; ++k) {
        real t[4];
        load_corner<4>(mesh.tangents, c, k, t);
        tangent[k] = safe_normalize_or(transformed(mesh.linear, vec3(t[0], t[1], t[2])), vec3(real(0.0f)));
        if (k == 0) handedness = handedness * t[3];
    }
    return handedness;
}

/// Unit bitangents of the corners, 0 where the mesh has none of its own.
inline void load_bitangents(const MeshView& mesh, const Corners& c, vec3 (&bitangent)[3]) {
    for (int32_t k = 0; k < 3; ++k)
        bitangent[k] =
            mesh.bitangents == nullptr
                ? vec3(real(0.0f))
                : safe_normalize_or(transformed(mesh.linear, load_corner3(mesh.bitangents, c, k)), vec3(real(0.0f)));
}

}  // namespace rakelight::cpu_shading::RL_ISA
