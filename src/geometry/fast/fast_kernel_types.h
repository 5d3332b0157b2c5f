// SPDX-License-Identifier: Apache-2.0
// Input of the fast path's kernels. Plain structs, because sources compiled per instruction set include this header.
#pragma once
#include <stdint.h>

#include "geometry/input/vote_kernel_types.h"

namespace rakelight::geometry {

/// Sum over the faces of one vertex, in object space. With tangents it has 8 floats { n.x, n.y, n.z, hand, t.x, t.y,
/// t.z, weight }, without them 4 { n.x, n.y, n.z, weight }.
/// - hand: sum of +-weight; exactly +-weight if all faces have one handedness, because both lanes then add equal
///   numbers
/// - weight: 0 if no face votes; negative if the general path handles the place
constexpr int tangent_row_floats = 8, normal_row_floats = 4;

/// A vote for a vertex that another piece of the mesh owns.
template <int floats>
struct FastParcel {
    uint32_t vertex;
    float row[floats];
};

/// Sums of unit vectors shorter than this share of their weights are not computed in float.
constexpr float weak_normal_share = 1.0f / 8, weak_tangent_share = 1.0f / 16;
/// The same before and after normals are fitted.
constexpr float weak_tangent_before_fit = 1.0f / 2, weak_tangent_after_fit = 1e-3f;

/// Some triangles of one mesh. A kernel adds their votes (or looks) to the rows of vertices own_begin .. own_end - 1, which no
/// other thread touches; votes for other vertices become parcels. It stops after a block of faces if `foreign` or `odd`
/// could overflow.
struct ScatterJob {
    const float* positions = nullptr;   ///< [3 * vertices]
    const float* texcoords = nullptr;   ///< [2 * vertices], or null: no votes for tangents
    const float* normals = nullptr;     ///< [3 * vertices] of the vertices, for looks; or null
    const uint32_t* indices = nullptr;  ///< [3 * triangles]
    VoteWeight weight = VoteWeight::uniform;
    float hard_cosine = -1, bent_cosine = -1;  ///< for looks
    uint32_t vertices = 0;
    uint32_t face = 0, face_end = 0;  ///< advanced by the kernel
    float* rows = nullptr;            ///< row of vertex 0 of the mesh
    uint32_t own_begin = 0, own_end = 0;
    uint32_t ready_end = 0;   ///< own rows from here on are not yet cleared; the kernel stops there
    uint32_t wanted_end = 0;  ///< and returns here the number of rows it needs
    void* foreign = nullptr;  ///< FastParcel[parcel_capacity]
    uint32_t foreign_count = 0;
    uint32_t* odd = nullptr;  ///< [odd_capacity] faces for which float is not safe, left to the caller
    uint32_t odd_count = 0;
    uint32_t smallest = 0xffffffffu, largest = 0;  ///< of the indices met
    bool is_index_bad = false;                     ///< an index was out of range; nothing was read through it
};
constexpr uint32_t face_block = 16;  ///< faces per block; a multiple of the lanes of every instruction set
constexpr uint32_t parcel_capacity = 1024, odd_capacity = 1024;

/// Some vertices of one mesh, from sums to attributes.
struct FinishJob {
    const float* rows = nullptr;
    uint32_t begin = 0, end = 0;              ///< vertices
    float* normals = nullptr;                 ///< [3 * vertices]
    float* tangents = nullptr;                ///< [4 * vertices], or null
    bool keeps_normals = false;               ///< those of the buffer stay, and tangents are made for them
    float weak_tangent = weak_tangent_share;  ///< sums across the normal below this share are left to the general path
    uint32_t isolated = 0;                    ///< counted by the kernel
    uint32_t* odd = nullptr;  ///< [odd_capacity] vertices left to the general path; the kernel stops before it
    uint32_t odd_count = 0;   ///< overflows, with begin advanced
};

/// What the faces at a vertex look like from its normal: integers in float, so that their sum does not depend on the order.
/// `ends`: two halves of a hash of the faces' far ends, ahead minus behind: 0 if each face continues at another one.
/// `turns`: how often the faces go around the vertex, if each continues. `bends`: faces that turn away from the normal
/// beyond ScatterJob::bent_cosine, and `hard_face` for each one beyond hard_cosine.
struct LookRow {
    float ends[2], turns, bends;
};
static_assert(sizeof(LookRow) == normal_row_floats * sizeof(float));
constexpr float hard_face = 4096;

struct FastKernels {
    void (*scatter_normals)(ScatterJob*);
    void (*scatter_tangents)(ScatterJob*);
    void (*finish_normals)(FinishJob*);
    void (*finish_tangents)(FinishJob*);  ///< rows of 8; tangents may be null
};
struct LookKernels {
    void (*scatter)(ScatterJob*);  ///< rows: LookRow
};

namespace scalar {
const FastKernels* fast_kernels();
const LookKernels* look_kernels();
}  // namespace scalar
namespace sse2 {
const FastKernels* fast_kernels();
const LookKernels* look_kernels();
}  // namespace sse2
namespace avx2 {
const FastKernels* fast_kernels();
const LookKernels* look_kernels();
}  // namespace avx2
namespace avx512 {
const FastKernels* fast_kernels();
const LookKernels* look_kernels();
}  // namespace avx512

}  // namespace rakelight::geometry
