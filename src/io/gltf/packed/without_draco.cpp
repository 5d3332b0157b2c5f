// SPDX-License-Identifier: Apache-2.0
// Of a build without draco (RAKELIGHT_DRACO=OFF).
#include "base/left_out.h"
#include "io/gltf/packed/draco.h"

namespace rakelight::io::gltf {

struct DracoMesh::Impl {};

DracoMesh::DracoMesh(std::span<const std::byte>, const Value& from, Context&) {
    throw left_out("a mesh is compressed by Draco", "draco", "RAKELIGHT_DRACO").at(from.place());
}
DracoMesh::~DracoMesh() = default;
std::uint64_t DracoMesh::vertex_count() const { return 0; }
std::vector<std::uint32_t> DracoMesh::indices() const { return {}; }
Elements DracoMesh::attribute(std::uint32_t, const Elements&, const Value&, Context&) const { return {}; }
double DracoMesh::step(std::uint32_t) const { return 0; }

}  // namespace rakelight::io::gltf
