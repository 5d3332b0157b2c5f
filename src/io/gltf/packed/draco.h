// SPDX-License-Identifier: Apache-2.0
// KHR_draco_mesh_compression: one primitive's indices and attributes out of a Draco buffer (bitstream 2.2).
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "io/gltf/elements.h"
#include "io/gltf/value.h"

namespace rakelight::io::gltf {

/// A decoded Draco mesh. The library stays behind this door.
class DracoMesh {
public:
    virtual ~DracoMesh() = default;
    virtual std::uint64_t vertex_count() const = 0;
    virtual std::vector<std::uint32_t> indices() const = 0;  ///< [3T] each < vertex_count()
    /// Attribute `id` as one element a vertex. Whether integers are normalized is the accessor's word, in
    /// `description`.
    /// @throws Error: no such attribute, another number of components.
    virtual Elements attribute(std::uint32_t id, const Elements& description, const Value& from,
                               Context& context) const = 0;
    /// The step between two codes of positions that were stored as floats of fewer bits; 0: another attribute, or not so.
    virtual double step(std::uint32_t id) const = 0;
};

/// @param data  the compressed bytes  @param from  the primitive, for messages
/// @throws Error bad_file: not a Draco mesh of bitstream 2.2, sizes that the data cannot hold, broken data; or that this
/// build has no Draco (without_draco.cpp)
std::unique_ptr<DracoMesh> decode_draco(std::span<const std::byte> data, const Value& from, Context& context);

}  // namespace rakelight::io::gltf
