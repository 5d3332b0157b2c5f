// SPDX-License-Identifier: Apache-2.0
// Plain data between the engine and its kernels. Included by sources that are compiled once per instruction set:
// C headers only, no functions, so that the linker has nothing to merge.
#pragma once
#include <stdint.h>

#include "cpu_shading/channel_planes.h"
#include "cpu_shading/material_job.h"
#include "cpu_shading/mesh_view.h"
#include "engines/raster/kernels/geometry_types.h"
#include "image/srgb_table.h"
#include "shading/lights/light_box.h"
#include "shading/lights/shadow_factors.h"

namespace rakelight::raster {

using cpu_shading::kernel_classical, cpu_shading::kernel_pbr, cpu_shading::kernel_pbr_environment,
    cpu_shading::kernel_every;
using cpu_shading::MaterialJob;
using cpu_shading::TextureView, cpu_shading::TextureSlot, cpu_shading::MaterialView, cpu_shading::EnvironmentView;
using shading::LightBox;

inline constexpr int batch_padding = 32;  ///< arrays of a batch may be read and written this far past their count

/// What a pixel needs of its triangle. Planes over the screen: change per pixel in x and y, value at the tile's first
/// pixel center. Perspective: those of b1 / w, b2 / w and 1 / w are affine on the screen (Heckbert & Moreton 1991,
/// "Interpolation for polygon texture mapping and shading"). Attributes: value at corner 0 of the mesh's triangle and
/// the differences to corners 1 and 2. Floats only: kernels address them by number.
struct alignas(64) ShadeTriangle {
    float b1[3], b2[3];     ///< perspective: b1 / w, b2 / w; affine: b1, b2
    float depth[3];         ///< perspective: 1 / w [1/m]; orthographic: distance along the view axis [m]
    float texcoord0[2][3];  ///< u, then v: a0, a1 - a0, a2 - a0
    float slope0[2][2];     ///< change per pixel in x and y of (u - a0) / w, then of v; affine: not divided by w
    float normal[3][3];     ///< x, y, z likewise, world axes
    float facing;           ///< -1: the shading normal is to be turned round
    float tangent[3][3];
    float handedness;  ///< +1 or -1 of the tangent frame in the world
    float texcoord1[2][3], slope1[2][2];
    float color[4][3];
    float unused[3];
};
inline constexpr int shade_triangle_floats = int(sizeof(ShadeTriangle) / sizeof(float));

/// Light that the corners of a triangle receive, each term per unit of its reflectance (k_a, k_d, k_s): what flat and
/// Gouraud shading interpolate. R, G, B of each: a0, a1 - a0, a2 - a0.
struct LitTriangle {
    float ambient[3][3], diffuse[3][3], specular[3][3];
};
inline constexpr int lit_triangle_floats = int(sizeof(LitTriangle) / sizeof(float));

/// Triangles of one draw in one tile, whose records are wanted. `row` is read up to batch_padding past its count.
struct RecordJob : cpu_shading::MeshView {
    int32_t count;
    const TriangleRow* const* row;  ///< [count]
    int32_t tile_x, tile_y;         ///< [px] of the tile's corner
    const float* clip;              ///< [vertices] x, y, w, distance
    int32_t whole;                  ///< 0: texcoord1 and color are not written
    int32_t affine;                 ///< 1: barycentrics are not divided by w
    int32_t orthographic;
    ShadeTriangle* out;  ///< [count + batch_padding]
};

/// Frames at the corners of a triangle, beside ShadeTriangle: for lighting in the tangent space of the vertices, and for bitangents
/// that are attributes of their own.
struct CornerFrame {
    float position[3][3], normal[3][3], tangent[3][3];  ///< [corner][x, y, z], about the eye, world axes
    float handedness;
    float bitangent[3][3];
};
inline constexpr int corner_frame_floats = int(sizeof(CornerFrame) / sizeof(float));

/// One light's shadow map with its texels.
struct ShadowView : shading::ShadowFactors {
    const float* nearness;  ///< [faces][size * size]
    const int32_t* slopes;  ///< the same: how steep the surface is, shading::slope_codes
};

/// Where display values go, each to the place of its pixel: sRGB codes, opaque, R in the low byte.
struct DisplayPixels {
    uint32_t* srgb8;        ///< of the tile's first pixel; null: not wanted
    int64_t stride;         ///< [px] from row to row
    const uint32_t* table;  ///< SrgbEncoder::table()
};

/// Pixels of one draw in one tile.
struct ShadeJob : MaterialJob {
    int32_t kernel;  ///< KernelNumber; what it leaves out the job does not ask for
    int32_t count;
    const int32_t* pixel;   ///< [count] y * tile_size + x in the tile
    const float* offset_x;  ///< [count] [px] from the pixel's center to where it is shaded; null: there
    const float* offset_y;
    const int32_t* triangle;  ///< [count] into `triangles`
    const ShadeTriangle* triangles;
    const LitTriangle* lit;     ///< beside `triangles`; null: lighting is evaluated at every pixel
    const CornerFrame* frames;  ///< beside `triangles`; null: not wanted
    const ShadowView* shadows;  ///< [maps] LightParameters::shadow says which; null: none
    int32_t affine;             ///< as in RecordJob
    float ray[3][3];            ///< x, y, z of the pixel's ray: change per pixel in x and y, value at the tile's first
                                ///< pixel center. Perspective: times w it is the position about the eye;
                                ///< orthographic: the position where the distance is 0
    float* red;                 ///< [count] out, linear, finite
    float* green;
    float* blue;
    float* alpha;
    DisplayPixels display;  ///< out instead of these
    float* normal_x;        ///< [count] out, shading normal in the world; null: not wanted
    float* normal_y;
    float* normal_z;
};

/// Points of one material where lighting is evaluated before there are pixels: centroids for flat, vertices for Gouraud shading.
/// Arrays are read and written up to batch_padding past `count`.
struct LightJob {
    int32_t count;
    const float* position[3];  ///< [count] x, y, z about the eye, world axes
    const float* normal[3];    ///< [count] unit, on the side that is seen
    const MaterialJob* material;
    float roughness;    ///< of the material, with the mean of its map; not looked at for classical materials
    float* ambient[3];  ///< [count] out: R, G, B of each term per unit of its reflectance
    float* diffuse[3];
    float* specular[3];
};

/// Data of the pixels of a ShadeJob beside their color.
struct ChannelJob : cpu_shading::ChannelValues {
    const ShadeJob* shade;
};

/// Pixels of a tile that show the environment's picture.
struct SkyJob {
    int32_t count;
    const int32_t* pixel;  ///< [count] as in ShadeJob; read up to batch_padding past it
    float ray[3][3];       ///< as in ShadeJob; of any length. Orthographic: the same for all
    float pixel_size;      ///< [length of the middle ray] a pixel's side; orthographic: 0
    const EnvironmentView* environment;
    float *red, *green, *blue;  ///< [count + batch_padding] out, linear
    DisplayPixels display;      ///< out instead of these
};

/// The functions that exist once per instruction set.
struct Kernels {
    int32_t lanes;
    int32_t (*shade)(const ShadeJob* job);  ///< returns how many components came out not finite: they are 0
    void (*alpha)(const ShadeJob* job);     ///< only `alpha` is written: for masks
    void (*light)(const LightJob* job);
    void (*channels)(const ChannelJob* job);
    void (*bounds)(const ShadeJob* job, LightBox* box);  ///< of the pixels' positions
    void (*sky)(const SkyJob* job);
};

namespace scalar {
const Kernels* kernels();
}
namespace sse2 {
const Kernels* kernels();
}
namespace avx2 {
const Kernels* kernels();
}
namespace avx512x2 {
const Kernels* kernels();
}  // namespace avx512x2

}  // namespace rakelight::raster
