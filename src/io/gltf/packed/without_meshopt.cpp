// SPDX-License-Identifier: Apache-2.0
// Of a build without meshoptimizer (RAKELIGHT_MESHOPT=OFF).
#include "base/left_out.h"
#include "io/gltf/packed/meshopt_codec.h"

namespace rakelight::io::gltf {

int unpack_meshopt(const MeshoptJob&) {
    throw left_out("a buffer is compressed by meshopt", "meshoptimizer", "RAKELIGHT_MESHOPT");
}

}  // namespace rakelight::io::gltf
