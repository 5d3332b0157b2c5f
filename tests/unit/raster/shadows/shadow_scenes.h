// SPDX-License-Identifier: Apache-2.0
// Scenes whose shadows are known, and the exact shadow: a ray from the point to the light, in double precision.
#pragma once
#include <cmath>
#include <optional>

#include "unit/raster/drawn.h"

namespace rakelight::test {

/// A square of side 2 `half` whose normal is the matrix's z.
inline void add_square(Scene& scene, double half, const dmat4& to_world) {
    add_object(scene, square_mesh(0, float(half)), to_world);
}

/// Facing up, through y = 0.
inline dmat4 lying() {
    dmat4 m;
    m[0] = {1, 0, 0, 0}, m[1] = {0, 0, -1, 0}, m[2] = {0, 1, 0, 0}, m[3] = {0, 0, 0, 1};
    return m;
}

/// Unit sphere with the normals of the true one.
inline Mesh sphere_mesh(int rings, int segments) {
    std::vector<vec3> points;
    std::vector<std::uint32_t> indices;
    for (int r = 0; r <= rings; ++r)
        for (int s = 0; s <= segments; ++s) {
            const double a = pi * r / rings, b = 2 * pi * (s % segments) / segments;
            points.push_back({float(std::sin(a) * std::cos(b)), float(std::cos(a)), float(std::sin(a) * -std::sin(b))});
        }
    const auto at = [&](int r, int s) { return std::uint32_t(r * (segments + 1) + s); };
    for (int r = 0; r < rings; ++r)
        for (int s = 0; s < segments; ++s)
            for (const std::uint32_t i :
                 {at(r, s), at(r + 1, s), at(r + 1, s + 1), at(r, s), at(r + 1, s + 1), at(r, s + 1)})
                indices.push_back(i);
    Mesh mesh;
    mesh.positions = points;
    mesh.normals = points;
    mesh.indices = indices;
    mesh.material = 0;
    return mesh;
}

inline Camera looking(dvec3 from, dvec3 to, double fov = 0.9) {
    Camera camera;
    camera.vertical_fov_rad = fov;
    camera.z_near = 0.01;
    camera.z_far = 100;
    const dvec3 z = normalize_or(from - to, dvec3{0, 0, 1}), x = normalize_or(cross(dvec3{0, 1, 0}, z), dvec3{1, 0, 0});
    const dvec3 y = cross(z, x);
    camera.to_world[0] = {x.x, x.y, x.z, 0}, camera.to_world[1] = {y.x, y.y, y.z, 0};
    camera.to_world[2] = {z.x, z.y, z.z, 0}, camera.to_world[3] = {from.x, from.y, from.z, 1};
    return camera;
}

inline Light lamp(dvec3 position) {
    Light light;
    light.position = position;
    return light;
}

inline Light spot_at(dvec3 position, dvec3 to, double cutoff) {
    Light light;
    light.type = LightType::spot;
    light.position = position;
    light.direction = to - position;
    light.cutoff_rad = float(cutoff);
    return light;
}

/// The triangles of a scene in the world.
class RayCast {
public:
    explicit RayCast(const Scene& scene) {
        for (const Node& node : scene.nodes)
            for (const std::uint32_t number : node.meshes)
                parts_.push_back(part_of(scene.meshes[number], *node.local.matrix));
    }
    struct Hit {
        dvec3 position, normal;  ///< towards the ray's origin
    };
    std::optional<Hit> nearest(dvec3 from, dvec3 along) const {
        std::optional<Hit> best;
        double best_t = 1e30;
        for (const Part& part : parts_) {
            if (!may_meet(part, from, along)) continue;
            for (const Triangle& t : part.triangles)
                if (const std::optional<double> at = meet(t, from, along); at && *at > 1e-6 && *at < best_t) {
                    best_t = *at;
                    const dvec3 n = normalize_or(cross(t.p[1] - t.p[0], t.p[2] - t.p[0]), dvec3{0, 0, 1});
                    best = Hit{from + along * best_t, dot(n, along) < 0 ? n : -n};
                }
        }
        return best;
    }
    /// @param along  all the way to the light
    bool is_hidden(dvec3 from, dvec3 along) const {
        for (const Part& part : parts_) {
            if (!may_meet(part, from, along)) continue;
            for (const Triangle& t : part.triangles)
                if (const std::optional<double> at = meet(t, from, along); at && *at > 1e-7 && *at < 1) return true;
        }
        return false;
    }

private:
    struct Triangle {
        dvec3 p[3];
    };
    /// The triangles of a mesh and a ball around them.
    struct Part {
        dvec3 center = {};
        double radius = 0;  ///< [m]
        std::vector<Triangle> triangles;
    };
    static Part part_of(const Mesh& mesh, const dmat4& to_world) {
        Part part;
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            Triangle t;
            for (std::size_t k = 0; k < 3; ++k)
                t.p[k] = transform_point(to_world, cast<double>(mesh.positions[mesh.indices[i + k]]));
            part.triangles.push_back(t);
        }
        for (const Triangle& t : part.triangles) part.center += t.p[0] / double(part.triangles.size());
        for (const Triangle& t : part.triangles)
            for (const dvec3& p : t.p) part.radius = std::max(part.radius, length(p - part.center));
        part.radius *= 1 + 1e-9;
        return part;
    }
    static bool may_meet(const Part& part, dvec3 from, dvec3 along) {
        return length(cross(part.center - from, along)) <= part.radius * length(along);
    }
    /// Moeller & Trumbore 1997
    static std::optional<double> meet(const Triangle& t, dvec3 from, dvec3 along) {
        const dvec3 a = t.p[1] - t.p[0], b = t.p[2] - t.p[0], q = cross(along, b);
        const double volume = dot(a, q);
        if (std::fabs(volume) < 1e-14) return {};
        const dvec3 s = from - t.p[0];
        const double u = dot(s, q) / volume;
        const dvec3 r = cross(s, a);
        const double v = dot(along, r) / volume;
        if (u < 0 || v < 0 || u + v > 1) return {};
        return dot(b, r) / volume;
    }
    std::vector<Part> parts_;
};

}  // namespace rakelight::test
