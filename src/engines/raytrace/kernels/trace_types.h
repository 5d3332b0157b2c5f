// SPDX-License-Identifier: Apache-2.0
// Plain data between the engine and its kernels. Included by sources that are compiled once per instruction set: C headers
// only, no functions.
#pragma once
#include <stdint.h>

#include "cpu_shading/channel_planes.h"
#include "cpu_shading/material_job.h"
#include "cpu_shading/mesh_view.h"

namespace rakelight::raytrace {

using cpu_shading::MaterialJob;

inline constexpr int batch_padding = 32;  ///< arrays of a batch may be read and written this far past their count

/// Numbers of a ray, an array each: about the eye, in world axes. `d` need not be unit; places are o + d t. Differentials: change
/// of both from pixel to pixel, in x and in y (Igehy 1999, "Tracing ray differentials").
enum RayPlaneNumber : int32_t {
    ray_o = 0,
    ray_d = 3,
    ray_o_dx = 6,
    ray_o_dy = 9,
    ray_d_dx = 12,
    ray_d_dy = 15,
    ray_planes = 18,
};

struct RayView {
    const float* planes;  ///< [ray_planes][capacity]
    int32_t capacity;
};

/// Whether light reaches points: a ray each, from `origin` (about the eye) along `direction`, up to `length` times that.
struct ShadowRays {
    int32_t count;
    const float* origin[3];
    const float* direction[3];
    const float* length;  ///< may be infinity; < 0: nothing is to be found out
    float* seen;          ///< [count] out: 0..1
};

/// Hits of one draw.
struct HitJob : MaterialJob {
    int32_t kernel;  ///< KernelNumber of the engine; what it leaves out the job does not ask for
    int32_t count;
    const int32_t* ray;       ///< [count] into `rays`; read up to batch_padding past it
    const int32_t* triangle;  ///< [count] likewise
    RayView rays;
    cpu_shading::MeshView mesh;
    float to_eye[3][4];  ///< rows of object space -> about the eye
    int32_t
        front_is_negative;  ///< triangles show their front where the ray goes against their normal by the corners' order
    int32_t lit_at;         ///< LitAtNumber
    float roughness;        ///< of corners: of the material, with the mean of its map
    void (*find_seen)(const void* tracer, ShadowRays* rays);  ///< null: nothing is in shadow
    const void* tracer;
    float offset;  ///< [m] by which shadow rays begin off the surface, at least
    float* red;    ///< [count] out, linear, finite
    float* green;
    float* blue;
    float* alpha;
};

/// Rays that meet nothing.
struct SkyJob {
    int32_t count;  ///< from ray 0 on
    RayView rays;
    const cpu_shading::EnvironmentView* environment;
    int32_t orthographic;
    float *red, *green, *blue;  ///< [count + batch_padding] out, linear
};

enum LitAtNumber : int32_t { lit_at_points, lit_at_faces, lit_at_corners };

/// Data of the points of a HitJob beside their color.
struct ChannelJob : cpu_shading::ChannelValues {
    const HitJob* hits;
    float* normal[3];       ///< [count + batch_padding] out, shading normal; null: not wanted
    float* face_normal[3];  ///< likewise, of the triangle's plane on the side that is seen
    float* depth;           ///< where on the ray
};

/// The functions that exist once per instruction set.
struct Kernels {
    int32_t lanes;
    int32_t (*shade)(const HitJob* job);  ///< returns how many components came out not finite: they are 0
    void (*alpha)(const HitJob* job);     ///< only `alpha` is written: for masks
    void (*channels)(const ChannelJob* job);
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
namespace avx512 {
const Kernels* kernels();
}  // namespace avx512

}  // namespace rakelight::raytrace
