// SPDX-License-Identifier: Apache-2.0
// Of a build without draco (RAKELIGHT_DRACO=OFF).
#include "base/left_out.h"
#include "io/gltf/packed/draco.h"

namespace rakelight::io::gltf {

std::unique_ptr<DracoMesh> decode_draco(std::span<const std::byte>, const Value& from, Context&) {
    throw left_out("a mesh is compressed by Draco", "draco", "RAKELIGHT_DRACO").at(from.place());
}

}  // namespace rakelight::io::gltf
