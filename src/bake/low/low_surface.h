// SPDX-License-Identifier: Apache-2.0
// LOW for baking: triangles in world space with ray directions and tangent frames.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

#include "math/linear.h"

namespace rakelight::bake {

/// Barycentric weights.
using CornerWeights = std::array<double, 3>;

/// A triangle in the world. Vectors are unit at the corners.
struct LowTriangle {
    dvec3 place[3], cage[3];  ///< [m]; cage: normal smoothed over all objects without creases
    dvec3 normal[3], tangent[3];
    double handedness = 1;  ///< of the tangents in world space, seen from outside
    dmat3 to_object;        ///< transforms normals from world to object space, without normalization
};

/// A place on a triangle.
struct LowPoint {
    dvec3 place, cage;      ///< cage: unit
    dvec3 normal, tangent;  ///< interpolated
    double handedness = 1;
    dmat3 to_object;
};

LowPoint point_of(const LowTriangle& triangle, const CornerWeights& weights);

class LowSurface {
public:
    /// All drawn meshes with the set of texture coordinates.
    /// @param scene prepared, posed, with normals; with tangents if frames are needed
    /// @throws Error bad_file: no triangles, over the memory budget
    LowSurface(const Scene& scene, std::uint32_t set, Context& context);

    std::uint32_t triangle_count() const { return first_.back(); }
    LowTriangle triangle(std::uint32_t number) const;
    const Mesh& mesh_of(std::uint32_t triangle) const;
    std::array<std::uint32_t, 3> vertices(std::uint32_t triangle) const;  ///< of its mesh
    std::array<vec2, 3> texcoords(std::uint32_t triangle) const;
    /// Whether its placement mirrors: the corners are clockwise seen from outside.
    bool is_turned(std::uint32_t number) const;
    /// Vertices of any mesh with equal texture coordinates and equal world position have the same index.
    std::vector<std::uint32_t> map_vertices() const;

private:
    struct Part {
        Mesh mesh;  ///< shares its arrays with the scene
        dmat4 to_world;
        std::vector<vec3> cage{};                   ///< [V'] object space
        std::vector<std::uint32_t> cage_indices{};  ///< [3T], or empty: the mesh's
    };
    struct Corner {
        std::size_t part, at;  ///< at: of the mesh's indices
    };
    Corner first_corner(std::uint32_t triangle) const;

    std::uint32_t set_;
    std::vector<Part> parts_;
    std::vector<std::uint32_t> first_;  ///< [parts + 1] triangles before each
    MemoryCharge charge_;
};

}  // namespace rakelight::bake
