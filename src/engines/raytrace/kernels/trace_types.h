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
    int32_t first;  ///< of the hits whose rays these are, into HitJob::ray
    const float* origin[3];
    const float* direction[3];
    const float* length;  ///< may be infinity; < 0: nothing is to be found out, or there is no such hit
    float* seen[3];       ///< [count] out: 0..1 of red, green, blue
};

/// Where rays continue from a hit, an array each: what they share, then `lobe_planes` for each of them.
enum NextPlaneNumber : int32_t {
    next_o = 0,     ///< the hit, about the eye
    next_n = 3,     ///< unit normal of the surface's plane, on the side that is seen
    next_o_dx = 6,  ///< change of the place from pixel to pixel
    next_o_dy = 9,
    next_side = 12,    ///< 1: the front is seen, -1: the back
    next_offset = 13,  ///< [m] by which rays begin off the surface
    next_lobes = 14,
};
enum LobeNumber : int32_t { lobe_reflected, lobe_coat, lobe_refracted, lobe_count };
enum LobePlaneNumber : int32_t {
    lobe_d = 0,  ///< unit
    lobe_d_dx = 3,
    lobe_d_dy = 6,
    lobe_weight = 9,  ///< red, green, blue that what the ray brings is multiplied by
    lobe_planes = 12,
};
inline constexpr int32_t next_planes = next_lobes + int32_t(lobe_count) * int32_t(lobe_planes);

struct NextRays {
    float* planes;  ///< [next_planes][stride] out
    int32_t stride;
    const float*
        eta_front;  ///< [count + batch_padding] index of refraction before the surface over that behind, met from its front
    const float* eta_back;  ///< likewise from its back
};

/// A surface given by its formula (ExactShape), in its own space.
struct ShapeView {
    int32_t kind;  ///< ShapeNumber
    float radius, tube_radius, height, width, depth;
    float to_object[3][4];  ///< rows: about the eye -> object space
    float tangent_uv[2];    ///< how much of dP/du and of dP/dv tangents have: of texture coordinates behind a transform
};
enum ShapeNumber : int32_t { shape_none = -1, shape_sphere, shape_cylinder, shape_cone, shape_torus, shape_plane };
/// Faces of shapes, instead of triangles.
enum ShapeFaceNumber : int32_t { face_side, face_top, face_bottom };

/// Hits of one draw.
struct HitJob : MaterialJob {
    int32_t kernel;  ///< KernelNumber of the engine; what it leaves out the job does not ask for
    int32_t count;
    const int32_t* ray;       ///< [count] into `rays`; read up to batch_padding past it
    const int32_t* triangle;  ///< [count] likewise
    RayView rays;
    cpu_shading::MeshView mesh;
    ShapeView shape;       ///< instead of the triangles, which are its faces' numbers then
    int32_t is_of_splats;  ///< 1: the mesh is splats; rays leave them beyond their neighbors, which overlap them
    const float* t;        ///< [count] of shapes: where on the rays; read up to batch_padding past it
    float to_eye[3][4];    ///< rows of object space -> about the eye
    int32_t
        front_is_negative;  ///< triangles show their front where the ray goes against their normal by the corners' order
    int32_t lit_at;         ///< LitAtNumber
    float roughness;        ///< of corners: of the material, with the mean of its map
    void (*find_seen)(const void* tracer, ShadowRays* rays);  ///< null: nothing is in shadow
    const void* tracer;
    int32_t is_path;       ///< 1: rough surfaces spread what goes through, classical ones send on no more than arrives
    int32_t is_opened;     ///< 1: alpha thins the surface's own light, before the fog
    const NextRays* next;  ///< null: no ray continues
    float to_rays[3];      ///< from the eye to where Embree's coordinates are 0, negated: place about the eye + this
    float* red;            ///< [count] out, linear, finite
    float* green;
    float* blue;
    float* alpha;
};

/// What a path needs at a hit, an array each.
enum PathInNumber : int32_t {
    in_choice = 0,           ///< random numbers, [0, 1): which of the surface's lobes,
    in_direction = 1,        ///< where in the lobe (2)
    in_emitter = 3,          ///< a place on an emitter, about the eye, or the unit direction to the environment (3)
    in_emitter_n = 6,        ///< its unit normal (3)
    in_emitter_pdf = 9,      ///< [1/m^2], or [1/sr] of the environment; 0: there is no emitter
    in_emitter_is_far = 10,  ///< 1: the environment
    in_emitter_both = 11,    ///< 1: it shines from both sides
    in_emitter_size = 12,    ///< [m] largest coordinate of its triangle, about the eye
    in_lights = 13,          ///< as many as PathJob::picked_lights: into HitJob::lights, as numbers
};
inline constexpr int32_t most_picked_lights = 4;
inline constexpr int32_t path_in_planes = in_lights + most_picked_lights;

/// What a path's hit gives beside HitJob's color, which is the light of lights without an area.
enum PathOutNumber : int32_t {
    out_own = 0,        ///< own radiance (3)
    out_per_area = 3,   ///< [m^2/sr] by which densities on the surface, seen along the ray, are those of directions
    out_emitter_o = 4,  ///< where the ray to the emitter begins, about the eye (3)
    out_emitter_d = 7,  ///< the emitter is at 1 on it, the environment at infinity (3)
    out_emitter_weight = 10,  ///< of its radiance; 0: no ray (3)
    out_o = 13,               ///< where the path continues, about the eye (3)
    out_d = 16,               ///< unit (3)
    out_weight = 19,          ///< 0: it ends (3)
    out_pdf = 22,             ///< [1/sr] of the direction; 0: emitters are not sampled in this lobe
    out_through = 23,         ///< 1: through the surface
    out_straight = 24,        ///< 1: through the surface as if it were not there: the ray stays, times out_weight
    out_mirrored = 25,        ///< 1: as a mirror or clear glass leads it: what is behind all surfaces is seen
    out_side = 26,            ///< 1: the front is seen, -1: the back
    out_albedo = 27,          ///< (3)
    out_normal = 30,          ///< (3)
    path_out_planes = 33,
};

struct PathJob {
    HitJob hits;                        ///< `next` is null
    const float* in;                    ///< [path_in_planes][stride]
    float* out;                         ///< [path_out_planes][stride]
    int32_t stride;                     ///< at least the count + batch_padding
    const float *eta_front, *eta_back;  ///< as NextRays has them
    int32_t picked_lights;              ///< lights of each hit, chosen at random; < 0: all lights
    const float* light_scale;           ///< [lights] that the light of a pick is multiplied by
    int32_t asks_alone;                 ///< emitters are not met by chance: LightSampling::lights
    int32_t shines_behind;              ///< the back gives light, too
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
    int32_t needs_values;   ///< some of ChannelValues are wanted
    float* normal[3];       ///< [count + batch_padding] out, shading normal; null: not wanted
    float* face_normal[3];  ///< likewise, of the triangle's plane on the side that is seen
    float* depth;           ///< where on the ray
};

/// The functions that exist once per instruction set.
struct Kernels {
    int32_t lanes;
    int32_t (*shade)(const HitJob* job);  ///< returns how many components came out not finite: they are 0
    void (*alpha)(const HitJob* job);     ///< only `alpha` is written: for masks
    void (*through)(const HitJob* job);   ///< red, green, blue: what goes straight through, for shadows
    void (*channels)(const ChannelJob* job);
    int32_t (*walk)(const PathJob* job);  ///< as `shade`
    void (*emission)(const HitJob* job);  ///< red, green, blue: own radiance, times alpha where it is blended
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
