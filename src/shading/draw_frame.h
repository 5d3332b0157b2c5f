// SPDX-License-Identifier: Apache-2.0
// Where lighting is evaluated before there are pixels: vertices, faces, and the frames that vertices have in the world.
#pragma once
#include <rakelight/engines/engine.h>

#include "shading/draw_list.h"
#include "shading/lights/lit_side.h"
#include "shading/picture_camera.h"

namespace rakelight::shading {

/// Points, normals and tangents of one draw about the eye, in world axes.
class DrawFrame {
public:
    /// @param to_eye  object -> world axes about the eye. Like list and view it must outlive this
    DrawFrame(const DrawList& list, const Draw& draw, const dmat4& to_eye, const PictureCamera& view,
              FrontFace front_face);

    DrawFrame(const DrawList& list, const Draw& draw, dmat4&& to_eye, const PictureCamera& view,
              FrontFace front_face) = delete;

    dvec3 position(std::uint32_t vertex) const;
    dvec3 normal(std::uint32_t vertex) const;  ///< unit; the mesh must have normals

    struct Face {
        dvec3 centroid, normal;  ///< unit, towards the viewer
    };
    Face face(std::uint32_t triangle) const;

    /// The corners of a triangle as a vertex stage sees them. Without normals of the mesh those of the face, on its front.
    struct Corners {
        dvec3 position[3], normal[3], tangent[3],
            bitangent[3];  ///< unit, tangents 0 where the mesh has none, bitangents where it has none of their own
        float handedness;  ///< +1 or -1 of the tangent frame in the world
    };
    Corners corners(std::uint32_t triangle) const;

    /// 0: the triangle shows the side of its normals, 1: the other one, whose normals are turned round.
    int seen_side(std::uint32_t triangle, bool is_back) const { return side_.is_turned(triangle, is_back) ? 1 : 0; }

    const LitSide& side() const { return side_; }
    const dmat3& linear() const { return linear_; }        ///< object -> world axes
    const dmat3& to_normal() const { return to_normal_; }  ///< the same for normals: the cofactor matrix, mirrored back
    /// -1: the placement mirrors; faces that stand in for missing normals turn with clockwise fronts, too.
    double mirror() const { return mirror_; }

private:
    const std::uint32_t* indices(std::uint32_t triangle) const {
        return mesh_.indices.data() + 3 * std::size_t(triangle);
    }

    const PictureCamera& view_;
    const Mesh& mesh_;
    const dmat4& to_eye_;
    dmat3 linear_, to_normal_;
    double mirror_;
    LitSide side_;
};

}  // namespace rakelight::shading
