// SPDX-License-Identifier: Apache-2.0
// Lighting before there are pixels: once per face (flat; Bouknight 1970, "A Procedure for Generation of Three-dimensional
// Half-toned Computer Graphics Presentations") or once per vertex (Gouraud 1971, "Continuous Shading of Curved
// Surfaces").
#pragma once
#include <cstdint>
#include <vector>

#include "engines/raster/geometry/front_end.h"
#include "engines/raster/lights/lit_corner.h"
#include "shading/draw_frame.h"

namespace rakelight::raster {

using shading::DrawFrame;

/// The lit points of a draw. Where it is lit per face: [triangles], in `side[0]`, the side that is seen. Else
/// [vertices] for the normals as they are and turned round. Points without their side's bit in `marks` mean nothing.
struct DrawLight {
    bool per_face = false;
    std::uint8_t sides = 0;           ///< bit 1: side[0] is in use, bit 2: side[1]
    std::vector<std::uint8_t> marks;  ///< [points] the same bits
    std::vector<LitPoint> side[2];
};

struct LightPoints {
    bool is_used = false;          ///< some draw is shaded flat or by Gouraud
    std::vector<DrawLight> draws;  ///< [draws]
};

/// Flat and Gouraud.
bool is_lit_at_corners(const FrontEnd& front, std::uint32_t draw);

/// Calls choose_shading(), into front.shading. Lights the faces, or the vertices of the faces, that are in a tile's bin; counts them in
/// front.stats. Each is lit once, however many pieces clipping made and however many tiles it touches. A mesh without
/// normals is lit per face in both. Nothing in unlit and Phong pictures. Same bits for any number of threads and
/// instruction set.
/// @throws Error bad_file where the points need more than PictureMemory allows; failed: cancelled
LightPoints light_points(FrontEnd& front, const Binned& binned, const std::vector<lighting::LightParameters>& lights,
                         const Kernels& kernels, LightPoints&& used, Context& context);

/// The light of a triangle's corners. In flat pictures the normal of `shade` becomes that of the face.
void make_lit_triangle(const FrontEnd& front, const LightPoints& points, const ScreenTriangle& s, ShadeTriangle& shade,
                       LitTriangle& out);

/// The one or three points that make_lit_triangle() takes its light from; empty for unlit surfaces.
std::vector<LitCorner> lit_corners(const FrontEnd& front, const LightPoints& points, const ScreenTriangle& s);

/// The frame of a draw of the picture.
DrawFrame frame_of(const FrontEnd& front, std::uint32_t draw);

}  // namespace rakelight::raster
