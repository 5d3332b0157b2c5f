// SPDX-License-Identifier: Apache-2.0
// The head of a Draco buffer, read before the library sees it: the library allocates by its counts.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <rakelight/base/context.h>

#include "io/gltf/value.h"

namespace rakelight::io::gltf {

struct DracoHeader {
    std::uint8_t major = 0, minor = 0;
    bool is_mesh = false;
    std::uint64_t faces = 0;   ///< triangles that the connectivity announces
    std::uint64_t points = 0;  ///< vertices; edge-breaker meshes may get more from attribute seams, at most 3 a face
};

/// Draco bitstream specification 2.2, sections "Draco Decode", "Metadata", "Sequential connectivity" and "EdgeBreaker".
/// nullopt: cut short or not Draco.
std::optional<DracoHeader> read_draco_header(std::span<const std::byte> data);

/// @param from  the primitive, for messages
/// @throws Error bad_file: not a Draco mesh of bitstream 2.2; counts that the data cannot hold, or that are over the memory budget
void check_draco_header(std::span<const std::byte> data, const Value& from, Context& context);

}  // namespace rakelight::io::gltf
