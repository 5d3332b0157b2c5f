// SPDX-License-Identifier: Apache-2.0
// LOW as its maps see it: triangles in the world with the directions of rays and the frames that normals are written in.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <rakelight/context.h>
#include <rakelight/scene.h>

#include "math/linear.h"

namespace rakelight::bake {

/// Numbers of a triangle's corners.
using CornerWeights = std::array<double, 3>;

/// A triangle in the world. Vectors are unit at the corners.
struct LowTriangle {
    dvec3 place[3], cage[3];  ///< [m]; the normal over all objects, without creases
    dvec3 normal[3], tangent[3];
    double handedness = 1;  ///< of the tangents in the world, as seen from outside
    dmat3 to_object;        ///< takes normals of the world to the mesh's object space, not to unit length
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
    /// Of all drawn meshes that have the set of texture coordinates.
    /// @param scene  prepared, posed, with normals; with tangents where frames are asked for
    /// @throws Error bad_file: no triangles, over the memory budget
    LowSurface(const Scene& scene, std::uint32_t set, Context& context);

    std::uint32_t triangle_count() const { return first_.back(); }
    LowTriangle triangle(std::uint32_t number) const;
    const Mesh& mesh_of(std::uint32_t triangle) const;
    std::array<std::uint32_t, 3> vertices(std::uint32_t triangle) const;  ///< of its mesh
    std::array<vec2, 3> texcoords(std::uint32_t triangle) const;
    /// Its placement mirrors: the corners go clockwise as seen from outside.
    bool is_turned(std::uint32_t number) const;
    /// Vertices at one place of the map and of the world have the same number, whatever their mesh.
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
