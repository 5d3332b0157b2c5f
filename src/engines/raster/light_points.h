// SPDX-License-Identifier: Apache-2.0
// Lighting before there are pixels: once a face (flat; Bouknight 1970, "A Procedure for Generation of Three-dimensional
// Half-toned Computer Graphics Presentations") or once a vertex (Gouraud 1971, "Continuous Shading of Curved
// Surfaces").
#pragma once
#include <cstdint>
#include <vector>

#include "engines/raster/front_end.h"

namespace rakelight::raster {

/// Points and normals of one draw about the eye, in world axes.
class DrawFrame {
public:
    DrawFrame(const FrontEnd& front, std::uint32_t draw);

    dvec3 position(std::uint32_t vertex) const;
    dvec3 normal(std::uint32_t vertex) const;  ///< unit; the mesh must have normals
    void corners(std::uint32_t triangle, std::uint32_t (&index)[3], dvec3 (&position)[3]) const;

    struct Face {
        dvec3 centroid, normal;  ///< unit, towards the viewer
    };
    Face face(std::uint32_t triangle) const;

private:
    const View& view_;
    const Mesh& mesh_;
    const dmat4& to_eye_;
    dmat3 to_normal_;
    double mirror_;
};

/// What a point receives, per unit of k_a, k_d and k_s.
struct LitPoint {
    float ambient[3], diffuse[3], specular[3];
};

/// The lit points of a draw. Where it is lit per face: [triangles], in `side[0]`, the side that is seen. Else
/// [vertices] for the normals as they are and turned round; a side that nothing shows is empty. Points that no drawn
/// triangle uses are zero.
struct DrawLight {
    bool per_face = false;
    std::vector<LitPoint> side[2];
};

struct LightPoints {
    std::vector<DrawLight> draws;  ///< [draws]; empty in unlit and Phong pictures
};

/// Lights the faces, or the vertices of the faces, that are in a tile's bin; counts them in front.stats. Each is lit
/// once, however many pieces clipping made and however many tiles it touches. A mesh without normals is lit per face in
/// both. Nothing in unlit and Phong pictures. Same bits for any number of threads and instruction set.
/// @throws Error bad_file where the points need more than PictureMemory allows; failed: cancelled
LightPoints light_points(FrontEnd& front, const Binned& binned, const std::vector<lighting::LightParameters>& lights,
                         const Kernels& kernels, Context& context);

/// The light of a triangle's corners. In flat pictures the normal of `shade` becomes that of the face.
void make_lit_triangle(const FrontEnd& front, const LightPoints& points, const ScreenTriangle& s, ShadeTriangle& shade,
                       LitTriangle& out);

/// The part of a kernel's job that a material, the settings and the view say: no pixels.
ShadeJob material_job(const FrontEnd& front, const std::vector<lighting::LightParameters>& lights,
                      std::uint32_t material);

/// Whether the shading normal is turned round. A surface that is shown from both sides is lit from the side it is seen
/// from: by winding where the format gives winding a meaning, else so that the normals agree with the side that faces
/// the viewer.
/// @param position, normal  of the corners, about the eye in world axes
/// @return -1 or 1
float facing(const FrontEnd& front, const ScreenTriangle& s, const dvec3 (&position)[3], const dvec3 (&normal)[3]);

/// 0: a triangle of a mesh with normals shows the side of its normals, 1: the other one; and its vertices.
int seen_side(const FrontEnd& front, const DrawFrame& frame, const ScreenTriangle& s, std::uint32_t (&index)[3]);

}  // namespace rakelight::raster
