// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/packed/meshopt_codec.h"

#include <meshoptimizer.h>

namespace rakelight::io::gltf {
namespace {

int unpack(const MeshoptJob& job) {
    const auto* source = reinterpret_cast<const unsigned char*>(job.data.data());
    switch (job.mode) {
        case MeshoptMode::attributes:
            return meshopt_decodeVertexBuffer(job.out.data(), job.count, job.stride, source, job.data.size());
        case MeshoptMode::triangles:
            return meshopt_decodeIndexBuffer(job.out.data(), job.count, job.stride, source, job.data.size());
        default:
            return meshopt_decodeIndexSequence(job.out.data(), job.count, job.stride, source, job.data.size());
    }
}

}  // namespace

int unpack_meshopt(const MeshoptJob& job) {
    if (const int code = unpack(job)) return code;
    switch (job.filter) {
        case MeshoptFilter::none:
            break;
        case MeshoptFilter::octahedral:
            meshopt_decodeFilterOct(job.out.data(), job.count, job.stride);
            break;
        case MeshoptFilter::quaternion:
            meshopt_decodeFilterQuat(job.out.data(), job.count, job.stride);
            break;
        case MeshoptFilter::exponential:
            meshopt_decodeFilterExp(job.out.data(), job.count, job.stride);
            break;
    }
    return 0;
}

}  // namespace rakelight::io::gltf
