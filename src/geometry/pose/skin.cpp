// SPDX-License-Identifier: Apache-2.0
#include "geometry/pose/skin.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geometry/pose/skin_kernel_types.h"
#include "math/isa.h"
#include "math/linear.h"

namespace rakelight::geometry {
namespace {

constexpr std::size_t chunk = 4096;  // vertices at a time

static_assert(sizeof(JointColumns) == joint_floats * sizeof(float));
static_assert(sizeof(KernelInfluence) == sizeof(JointInfluence) &&
              offsetof(KernelInfluence, weights) == offsetof(JointInfluence, weights));

/// The blended matrix of one vertex, in double.
dmat3 blended(const SkinInput& in, std::size_t v) {
    dmat3 sum{{dvec3{}, dvec3{}, dvec3{}}};
    double weights = 0;
    const auto add = [&](const JointColumns& joint, double weight) {
        for (std::size_t c = 0; c < 3; ++c)
            sum[c] += dvec3{joint.columns[c][0], joint.columns[c][1], joint.columns[c][2]} * weight;
        weights += std::fabs(weight);
    };
    for (const auto* block : {&in.influences, &in.more_influences})
        for (std::size_t k = 0; k < 4 && !block->empty(); ++k)
            if ((*block)[v].weights[k] != 0) add(in.joints[(*block)[v].joints[k]], (*block)[v].weights[k]);
    if (weights == 0) add(in.joints[0], 1);
    return sum;
}

/// Directions whose squares exceed the float range.
void turn_odd(const SkinInput& in, const SkinOutput& out, std::size_t v) {
    const dmat3 m = blended(in, v);
    const double side = determinant(m) < 0 ? -1 : 1;
    if (!in.normals.empty()) {
        const dvec3 n = cofactor(m) * cast<double>(in.normals[v]) * side;
        out.normals[v] = cast<float>(normalize_or(n, cast<double>(in.normals[v])));
    }
    if (!in.tangents.empty()) {
        const dvec3 t = cast<double>(in.tangents[v].xyz());
        const vec3 unit = cast<float>(normalize_or(m * t, t));
        out.tangents[v] = {unit.x, unit.y, unit.z, in.tangents[v].w * float(side)};
    }
}

template <class To, class T>
To* from(std::span<T> array, std::size_t first) {
    return array.empty() ? nullptr : reinterpret_cast<To*>(array.data() + first);
}

void skin_chunk(const SkinKernels& kernels, const SkinInput& in, const SkinOutput& out, std::size_t first) {
    std::uint32_t odd[chunk];
    SkinJob job;
    job.joints = in.joints[0].columns[0].data();
    job.influences = from<const KernelInfluence>(in.influences, first);
    job.more_influences = from<const KernelInfluence>(in.more_influences, first);
    job.positions = from<const float>(in.positions, first);
    job.normals = from<const float>(in.normals, first);
    job.tangents = from<const float>(in.tangents, first);
    job.out_positions = from<float>(out.positions, first);
    job.out_normals = from<float>(out.normals, first);
    job.out_tangents = from<float>(out.tangents, first);
    job.count = std::uint32_t(std::min(in.positions.size() - first, chunk));
    job.odd = odd;
    kernels.skin(job);
    for (std::uint32_t k = 0; k < job.odd_count; ++k) turn_odd(in, out, first + odd[k]);
}

}  // namespace

JointColumns columns_of(const dmat4& m) {
    JointColumns c;
    for (std::size_t k = 0; k < 4; ++k) c.columns[k] = {float(m[k].x), float(m[k].y), float(m[k].z), 0};
    return c;
}

void skin_some_vertices(const SkinInput& in, const SkinOutput& out) {
    const SkinKernels& kernels = *RL_BY_ISA(isa_from_environment(), skin_kernels());
    for (std::size_t first = 0; first < in.positions.size(); first += chunk) skin_chunk(kernels, in, out, first);
}

void skin_vertices(const SkinInput& in, const SkinOutput& out, Context& context) {
    const SkinKernels& kernels = *RL_BY_ISA(isa_from_environment(), skin_kernels());
    context.parallel_for((in.positions.size() + chunk - 1) / chunk,
                         [&](std::size_t c) { skin_chunk(kernels, in, out, c * chunk); });
}

}  // namespace rakelight::geometry
